// SPDX-License-Identifier: MIT
// `ledger = true`: what each collider, grip and face of the domain gives, beside what is booked of all of them.
#include <gtest/gtest.h>

#include "tests/conservation/dough.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

Vector3 impulse_of_all(const Simulation& s) {
  Vector3 sum{0, 0, 0};
  for (const Given& given : s.given()) sum = sum + given.impulse;
  return sum;
}

/// On a plate, with the transfer that calms it down soonest.
Dough resting() {
  Dough dough;
  dough.shape = "box = { half_extents_m = [0.125, 0.125, 0.125] }";
  dough.gravity = "[0, 0, -9.81]";
  dough.motion = k_pic;
  return dough;
}

TEST(AGiver, CarriesTheWeightOfWhatRestsOnIt) {
  for (const std::string& on : {std::string(R"([[collider]]
name = "plate"
shape = { half_space = { point_m = [0, 0, -0.125], normal = [0, 0, 1] } }
ledger = true
)"),
                                std::string("[[face]]\nat = \"z_min\"\nledger = true\n")}) {
    Dough dough = resting();
    dough.tables = on;
    if (on.starts_with("[[face]]")) dough.low = {-1, -1, -0.125};
    const auto s = dough.begin();
    const double weight = 9.81 * Sums(*s).mass();
    s->advance(3, 4);
    const Given before = s->given().front();
    s->advance(4, 5);
    const Vector3 force = s->given().front().impulse - before.impulse;  // of a second
    EXPECT_NEAR(force[2], weight, 1e-3 * weight) << on;
    EXPECT_NEAR(force[0], 0, 1e-3 * weight) << on;
    EXPECT_NEAR(force[1], 0, 1e-3 * weight) << on;
  }
}

/// Thrown between a knife that comes down, a plate that turns, a grip and two walls.
Dough pushed(const char* precision, bool ledger) {
  Dough dough;
  dough.precision = precision;
  dough.body = "velocity_m_per_s = [5, 4, -3]";
  dough.low = {-0.5, -0.5, -0.5};
  dough.high = {0.5, 0.5, 0.5};
  dough.faces = "friction = 0.3\ny_max = \"sticky\"";
  const std::string wish = ledger ? "ledger = true\n" : "";
  dough.tables = R"([[collider]]
name = "knife"
shape = { box = { centre_m = [0.2, 0, 0.3], half_extents_m = [0.02, 0.4, 0.2] } }
contact = "separating"
expels = true
motion = [{ time_s = 0 }, { time_s = 0.1, position_m = [0, 0, -0.4] }]
)" + wish + R"([[collider]]
name = "plate"
shape = { box = { centre_m = [0, 0, -0.45], half_extents_m = [0.3, 0.3, 0.1] } }
friction = 0.5
motion = [{ time_s = 0 }, { time_s = 1, rotation_deg = [0, 0, 90] }]
)" + wish + R"([[grip]]
name = "hand"
shape = { sphere = { centre_m = [-0.2, 0, 0], radius_m = 0.1 } }
motion = [{ time_s = 0 }, { time_s = 1, position_m = [0, -1, 0] }]
)" + wish;
  if (ledger)
    dough.tables +=
        "[[face]]\nat = \"x_max\"\nledger = true\n[[face]]\nat = \"y_max\"\nledger = true\n[[face]]\nat = \"z_min\"\nledger = true\n";
  return dough;
}

TEST(AllGivers, GiveTheImpulseThatIsBooked) {
  for (const char* precision : {"double", "single"}) {
    const auto s = pushed(precision, true).begin();
    const double scale = Sums(*s).mass() * 4;
    int steps = 0;
    take_steps(*s, 150, 1e-3, [&] {
      const Vector3 all = impulse_of_all(*s), booked = Sums(*s).impulse;
      ++steps;
      for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(all[d], booked[d], steps * round_off(precision) * scale) << d;
    });
    ASSERT_EQ(s->givers().size(), 6u);
    for (std::size_t g = 0; g < s->givers().size(); ++g)
      EXPECT_GT(length(s->given()[g].impulse), 1e-3 * scale) << s->givers()[g].name << ": else nothing was tested";
  }
}

/// Half of a cake on each of two plates that are equally hot, and an air that heats it, too.
Dough on_plates(const std::string& heat, const std::string& surface, bool ledger) {
  Dough dough;
  dough.effects = "heat";
  dough.frame_s = 5e-3;
  dough.heat = heat;
  dough.surface = surface;
  dough.shape = "box = { half_extents_m = [0.25, 0.25, 0.25] }";
  for (const char* plate : {"left", "right"})
    dough.tables += fmt::format(
        "[[collider]]\nname = \"{}\"\nshape = {{ box = {{ centre_m = [{}, 0, -0.5], half_extents_m = [0.25, 0.25, 0.25] }} }}\n"
        "temperature_C = 150\nheat_transfer_coefficient_W_per_m2K = 500\n{}",
        plate, plate[0] == 'l' ? -0.25 : 0.25, ledger ? "ledger = true\n" : "");
  return dough;
}

TEST(HotPlates, GiveTheHeatThatTheDoughGains) {
  for (const char* heat : {"", "integrator = \"backward_euler\"", "heat_transfer_form = \"published\"",
                           "heat_transfer_form = \"published\"\nintegrator = \"backward_euler\""})
    for (const char* surface : {"", "form = \"published\""})
      for (const char* precision : {"double", "single"}) {
        Dough dough = on_plates(heat, surface, true);
        dough.precision = precision;
        const auto s = dough.begin();
        const Sums start(*s);
        take_steps(*s, 40, 5e-3);
        const Sums now(*s);
        const double given = s->given()[0].heat + s->given()[1].heat, gained = now.heat - start.heat;
        EXPECT_NEAR(given, now.exchanged, 40 * round_off(precision) * std::abs(given)) << heat << surface << precision;
        EXPECT_NEAR(given, gained, 40 * round_off(precision) * now.heat) << heat << surface << precision;
        EXPECT_NEAR(s->given()[0].heat / given, 0.5, 0.12) << "half lies on either; nodes before both are the first one's";
        EXPECT_GT(std::abs(gained), 0.03 * start.heat) << "else nothing was tested";
      }
}

TEST(HotPlates, ShareTheHeatWithTheAir) {
  const char* air = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 300\n";
  Dough dough = on_plates("", "", true);
  const auto plates = dough.begin();
  dough.tables += air;
  const auto both = dough.begin();
  for (const auto* s : {&plates, &both}) take_steps(**s, 5, 5e-3);
  for (std::size_t g = 0; g < 2; ++g) EXPECT_NEAR(both->given()[g].heat / plates->given()[g].heat, 1, 0.01);
  EXPECT_GT(Sums(*both).exchanged, 2 * (both->given()[0].heat + both->given()[1].heat));
}

TEST(TheLedgerOfGivers, ChangesNoBitOfTheRun) {
  const TemporaryFolder folder;
  for (const bool hot : {false, true}) {
    std::vector<double> positions[2], temperatures[2];
    for (const bool ledger : {false, true}) {
      const auto s = (hot ? on_plates("", "", ledger) : pushed("single", ledger)).begin();
      take_steps(*s, 60, hot ? 5e-3 : 1e-3);
      const Snapshot now = s->snapshot();
      for (const Point& x : now.position) positions[ledger].insert(positions[ledger].end(), x.begin(), x.end());
      if (hot) temperatures[ledger] = now["temperature"];
      EXPECT_EQ(ledger_row(*s).size(), ledger_columns().size() + (ledger ? hot ? 8 : 23 : 0));
    }
    EXPECT_EQ(positions[0], positions[1]);
    EXPECT_EQ(temperatures[0], temperatures[1]);
  }
}

}  // namespace
}  // namespace bake
