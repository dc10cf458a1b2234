// SPDX-License-Identifier: MIT
// Faces of the domain, and what the ledger tells on request.
#include "solver/scene/givers.h"
#include "tests/unit/scene/scenes.h"

namespace bake::test {
namespace {

std::string with_faces(const std::string& faces, const std::string& tables = "") {
  return replaced(k_least, "min_m", faces + "min_m") + tables;
}
Scene scene_of(const std::string& text) { return parse_scene(text, "bread.toml", {}); }
const std::string k_plate = "[[collider]]\nshape = { half_space = { normal = [0, 0, 1] } }\n";

TEST(Givers, AreThoseThatAskForIt) {
  const Scene scene = scene_of(k_least + k_plate + "name = \"plate\"\nledger = true\n" + k_plate +
                               "[[grip]]\nname = \"hand\"\nshape = { sphere = { radius_m = 0.1 } }\nledger = true\n"
                               "[[face]]\nat = \"z_max\"\nledger = true\n[[face]]\nat = \"x_min\"\n");
  std::vector<std::string> names;
  for (const Giver& giver : givers_of(scene)) names.push_back(giver.name);
  EXPECT_EQ(names, (std::vector<std::string>{"collider_plate", "grip_hand", "face_z_max"}));
  EXPECT_FALSE(givers_of(scene)[1].gives_heat);
}

TEST(Givers, NeedANameOfTheirOwnThatColumnsCanHave) {
  EXPECT_EQ(
      error_of(k_least + k_plate + "ledger = true\n"),
      "bread.toml:11: collider.0.ledger: found true and the name \"\", allowed: with a name of letters, digits and _, by which its columns "
      "are called");
  EXPECT_EQ(
      error_of(k_least + k_plate + "name = \"hot plate\"\nledger = true\n"),
      "bread.toml:12: collider.hot plate.ledger: found true and the name \"hot plate\", allowed: with a name of letters, digits and _, by "
      "which its columns are called");
  const std::string plate = k_plate + "name = \"plate\"\nledger = true\n";
  EXPECT_EQ(error_of(k_least + plate + plate),
            "bread.toml:16: collider.plate.ledger: found true and the name 'plate' again, allowed: with a name of its own");
  EXPECT_EQ(
      error_of(k_least + k_plate + "ledgr = true\n").rfind("bread.toml:11: collider.0: unknown key 'ledgr', did you mean 'ledger'?", 0),
      0u);
}

TEST(AFaceOfTheDomain, IsNamedOnceAndClosed) {
  const std::string face = "[[face]]\nat = \"x_max\"\n";
  EXPECT_EQ(error_of(k_least + face + face), "bread.toml:12: face.1.at: found 'x_max' again, allowed: each face once");
  EXPECT_EQ(error_of(k_least + "[[face]]\nat = \"xmax\"\n"), "bread.toml:10: face.0.at: unknown name 'xmax', did you mean 'x_max'?");
  EXPECT_EQ(error_of(with_faces("x_max = \"open\"\n", face)),
            "bread.toml:11: face.0.at: found 'x_max', which is open: nothing is there that could give anything, allowed: a closed face");
  EXPECT_EQ(error_of(k_least + "[[face]]\nledger = true\n").rfind("bread.toml:9: face.0.at: missing", 0), 0u);
}

TEST(AFaceOfTheDomain, PassesHeatByATemperatureOrAFlux) {
  const std::string face = "[[face]]\nat = \"x_max\"\n";
  EXPECT_EQ(error_of(k_least + face + "temperature_C = 100\nheat_flux_W_per_m2 = 3\n"),
            "bread.toml:12: face.0.heat_flux_W_per_m2: found beside temperature_C, allowed: one of them");
  EXPECT_EQ(error_of(k_least + face + "heat_transfer_coefficient_W_per_m2K = 3\n"),
            "bread.toml:11: face.0.heat_transfer_coefficient_W_per_m2K: found without temperature_C, allowed: with it");
  EXPECT_EQ(
      error_of(k_least + "[surface]\nform = \"published\"\n" + face + "temperature_C = 100\n"),
      "bread.toml:13: face.0.temperature_C: found without heat_transfer_coefficient_W_per_m2K beside form = 'published', allowed: with it");
  EXPECT_EQ(error_of(k_least + "[heat]\nheat_transfer_form = \"published\"\n" + face + "heat_flux_W_per_m2 = 100\n"),
            "bread.toml:13: face.0.heat_flux_W_per_m2: found beside heat_transfer_form = 'published', allowed: beside the standard form");
  EXPECT_TRUE(scene_of(k_least + face + "temperature_C = [[0, 20], [3, 100]]\n").faces.front().passes_heat());
  EXPECT_FALSE(scene_of(k_least + face).faces.front().passes_heat());
}

TEST(PeriodicFaces, ComeInPairsAMultipleOfFourCellsApart) {
  EXPECT_EQ(error_of(with_faces("y_min = \"periodic\"\n")),
            "bread.toml:6: domain.y_min: found 'periodic' opposite y_max = 'separating', allowed: both periodic or none");
  EXPECT_EQ(error_of(with_faces("y_min = \"open\"\ny_max = \"periodic\"\n")),
            "bread.toml:7: domain.y_max: found 'periodic' opposite y_min = 'open', allowed: both periodic or none");
  const std::string pair = "y_min = \"periodic\"\ny_max = \"periodic\"\n";
  EXPECT_TRUE(scene_of(with_faces(pair)).domain.is_periodic(1));
  EXPECT_FALSE(scene_of(with_faces(pair)).domain.is_periodic(0));
  EXPECT_EQ(
      error_of(replaced(with_faces(pair), "[1, 1, 1]", "[1, 0.985, 1]")),
      "bread.toml:9: domain.max_m: found 98.5 cells of 0.01 m along y at paper quality, allowed between periodic faces: a multiple of 4 "
      "cells (with multiples of 16 at paper quality all qualities have one)");
  EXPECT_EQ(error_of(replaced(with_faces(pair), "[1, 1, 1]", "[1, 1.02, 1]")).rfind("bread.toml:9: domain.max_m: found 102 cells", 0), 0u);
}

TEST(PeriodicFaces, RefuseWhatHasNoImageBeyondThem) {
  const std::string pair = "x_min = \"periodic\"\nx_max = \"periodic\"\n";
  const auto with_box = [&](const std::string& kind, const std::string& half, const std::string& more = "") {
    return with_faces(
        pair, "[[" + kind + "]]\nshape = { box = { centre_m = [0.5, 0.5, 0], half_extents_m = [" + half + ", 0.3, 0.1] } }\n" + more);
  };
  for (const char* half : {"0.5", "0.6", "0.47"}) EXPECT_EQ(scene_of(with_box("collider", half)).colliders.size(), 1u);
  const auto box = [&](const char* kind, const char* half, const char* more = "") { return error_of(with_box(kind, half, more)); };
  EXPECT_EQ(
      box("collider", "0.48"),
      "bread.toml:12: collider.0.shape: found from 0.02 to 0.98 m along x at 0 s, allowed beside periodic faces, beyond which it has no "
      "image: through both (0 and 1 m) or 3 cells away from both");
  EXPECT_EQ(box("grip", "0.48").rfind("bread.toml:12: grip.0.shape: found from 0.02 to 0.98 m along x", 0), 0u);
  EXPECT_EQ(box("collider", "0.1", "motion = [{ time_s = 0 }, { time_s = 3, position_m = [0.4, 0, 0] }]\n")
                .rfind("bread.toml:12: collider.0.shape: found from 0.8 to 1 m along x at 3 s", 0),
            0u);
  EXPECT_EQ(
      error_of(with_faces(pair, "[[face]]\nat = \"x_max\"\ntemperature_C = 20\n")),
      "bread.toml:12: face.0.at: found 'x_max', which is periodic: nothing is there that could give anything, allowed: a closed face");
}

}  // namespace
}  // namespace bake::test
