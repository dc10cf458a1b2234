// SPDX-License-Identifier: MIT
// A stiff elastic film on deep soft ground, in plane strain, both compressed along x by the logarithmic strain e: it wrinkles when e is
// large enough. Y is the modulus of film or ground, E = Y / (1 - nu^2), h the film's thickness, f cos(k x) a load on it and w cos(k x)
// what it yields. For a film that is thin against 1/k
//     f = S(k, e) w,   S = E_f h^3 k^4 / 12 + B k - E_f h k^2 e,
// whose terms are bending, ground and compression. S vanishes, and the film wrinkles, at
//     e_c(k) = h^2 k^2 / 12 + B / (E_f h k).
// With B = E_s / 2, of a surface that may slide beneath the film, e_c is least at the wavelength 2 pi h (E_f / 3 E_s)^(1/3), and the onset
// there is 1/4 (3 E_s / E_f)^(2/3). But the film holds the ground, at its lower face, which bending moves along x by h k w / 2 against
// where the ground would go. The stiffness of a half space for displacements w and u of its surface (normal and along x alike
// 4 mu (1 - nu) k / (3 - 4 nu), between them 2 mu (1 - 2 nu) k / (3 - 4 nu)) then gives
//     B = 4 mu (1 - nu) / (3 - 4 nu) (1 + (1 - 2 nu) / (2 - 2 nu) h k + (h k)^2 / 4).
//
// Of the solver S is asked: the load is put on, all motion damped, and w read off when it is at rest, for e = 0 and for e of two fifths
// of the onset. S falls linearly with e; where it would be zero is e_c(k). The least value of a k^2 + b / k, fitted to e_c at three k, is
// the onset, and where it is the wavelength: of the solver and of the theory alike.
#include "experiments/convergence/film.h"

#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace film {

namespace {

using std::numbers::pi;

// Y_s = rho = h = 1
constexpr double nu = 0.4, Y_f = 30;
constexpr double E_s = 1 / (1 - nu * nu), E_f = Y_f * E_s, mu_s = 1 / (2 * (1 + nu));
constexpr double k_length = 21, k_depth = 12;  // of the piece, when compressed
constexpr std::array k_half_waves{2, 3, 4};    // in its length; the onset's are about 3
static_assert(k_half_waves.size() == Waves{}.size());

constexpr double k_load = 0.002;  // of each wave, for each unit of the film's mass [m/s^2]

Waves wave_numbers() {
  Waves k;
  for (std::size_t i = 0; i < k.size(); ++i) k[i] = pi * k_half_waves[i] / k_length;
  return k;
}

double held_ground(double k) { return 4 * mu_s * (1 - nu) / (3 - 4 * nu) * (1 + (1 - 2 * nu) / (2 - 2 * nu) * k + k * k / 4); }
double critical(double k) { return k * k / 12 + held_ground(k) / (E_f * k); }
double stiffness(double k, double e) { return E_f * k * k * (critical(k) - e); }

/// A rate that brings the slowest of the waves to rest soon; the ground moves along to a depth of about 1/k.
double damping(double e) {
  double slowest = 1e9;
  for (const double k : wave_numbers()) slowest = std::min(slowest, std::sqrt(stiffness(k, e) / (1 + 1 / k)));
  return 1.4 * slowest;
}

std::string body(const char* material, double length, double width, double low, double high) {
  return fmt::format(R"(
[[body]]
material = "{}"
particles_per_cell = 8
jitter = 0
shape = {{ box = {{ centre_m = [{:.17g}, {:.17g}, {:.17g}], half_extents_m = [{:.17g}, {:.17g}, {:.17g}] }} }}
)",
                     material, length / 2, width / 2, (low + high) / 2, length / 2, width / 2, (high - low) / 2);
}

/// How far the film yields to waves of load of one sign or the other, for each unit of load; `cells` in its thickness. The piece is pressed
/// evenly, and free of stress along z: nu is that of both. Then walls hold it where it is; at the sides it slips.
Waves yielding(int cells, double e, double sign) {
  const double dx = 1. / cells, length = k_length * std::exp(e);
  StudyScene setting("motion, elasticity");
  setting.frame_s = k_pressed;
  setting.dx = dx;
  setting.low = {-3 * dx, 0, -k_depth - 3 * dx};
  setting.high = {k_length + 1 + 3 * dx, dx, 1 + 4 * dx};
  setting.faces = "y_min = \"slip\"\ny_max = \"slip\"\n";
  setting.time = "safety = 0.9";
  setting.material += fmt::format("young_modulus_Pa = 1\npoisson_ratio = {}\n", nu);
  setting.tables =
      fmt::format("[[material]]\nname = \"film\"\ndensity_kg_per_m3 = 1\nyoung_modulus_Pa = {}\npoisson_ratio = {}\n", Y_f, nu) +
      body("dough", length, dx, -k_depth, 0) + body("film", length, dx, 0, 1) + wall("slip", 0, 0, 1, 0) +
      wall("slip", k_length, 0, -1, 0) + wall("sticky", 0, dx - k_depth, 0, 1);
  const auto s = setting.begin();
  press(*s, e, nu);
  const Snapshot pressed = s->snapshot();

  const Waves k = wave_numbers();
  const auto push = [=](const Point& x) {
    const double share = x[2] > dx / 4 ? 1 : x[2] > -dx / 4 ? 0.5 : 0;  // of a node in the film's lower face half the mass is film
    double sum = 0;
    for (const double each : k) sum += sign * k_load * share * std::cos(each * x[0]);
    return sum;
  };
  return load(*s, damping(e), push, [&] {
    const Snapshot now = s->snapshot();
    Waves w{};
    double count = 0;
    for (std::size_t p = 0; p < now.id.size(); ++p) {
      if (now.material[p] != 1) continue;
      ++count;
      for (std::size_t i = 0; i < k.size(); ++i)
        w[i] += 2 * sign * (now.position[p][2] - pressed.position[p][2]) * std::cos(k[i] * pressed.position[p][0]);
    }
    for (double& each : w) each /= count * k_load * std::exp(e);  // film that is pressed has more mass in each length
    return w;
  });
}

/// Where S, found at 0 and e, would be zero. Pressed dough moves a little by itself, since its particles now stand unevenly in the cells:
/// the mean of both signs of the load is free of that.
Waves critical_strains_of_film(int cells) {
  const double e = std::log(1 + 1 / (2 * k_length));  // takes half of h: half a cell for each cell of the film, whole rows of particles
  return critical_strains(yielding(cells, 0, 1), 0, mean(yielding(cells, e, 1), yielding(cells, e, -1)), e);
}

}  // namespace

}  // namespace film

std::vector<Errors> wrinkles(bool quick) {
  using namespace film;
  Waves exact;
  for (std::size_t i = 0; i < exact.size(); ++i) exact[i] = critical(wave_numbers()[i]);
  const Wrinkle held = least_of_fit(wave_numbers(), exact), thin{2 * pi * std::cbrt(E_f / (3 * E_s)), std::pow(3 * E_s / E_f, 2. / 3) / 4};
  Errors wavelength, onset, thin_wavelength, thin_onset;
  wavelength.quantity = "wavelength, of a film that holds the ground at its lower face";
  onset.quantity = "onset, of a film that holds the ground at its lower face";
  thin_wavelength.quantity = "wavelength against 2 pi h (E_f / 3 E_s)^(1/3)";
  thin_onset.quantity = "onset against 1/4 (3 E_s / E_f)^(2/3)";
  wavelength.low = 0.8, wavelength.high = 2.2;
  wavelength.why =
      "between first and second order: bending is that of a film whose faces are smeared over a part of a cell; theory itself takes h k = "
      "0.45 for small and the ground, of 12 h, for deep";
  onset.why =
      "no order: even a film of one cell is as near as theory goes, which leaves out terms of (h k)^2 / 12 = 2 % and all that compression "
      "by 2 % does to the ground";
  onset.high = 0.03;
  thin_wavelength.high = 0.1, thin_onset.high = 0.15;
  thin_wavelength.why =
      "the formula of an infinitely thin film on ground that may slide; ground that the film holds at its lower face shifts it by 1 to 2 %";
  thin_onset.why =
      "the formula of an infinitely thin film on ground that may slide; ground that the film holds at its lower face is stiffer by 16 % at "
      "h k = 0.45, which puts the onset up by two thirds of that";
  for (Errors* e : {&onset, &thin_wavelength, &thin_onset}) e->figure = Errors::Figure::largest_error;
  for (Errors* e : {&wavelength, &onset, &thin_wavelength, &thin_onset}) {
    e->refined = "cells in the film";
    e->refinements = quick ? std::vector<double>{1, 2} : std::vector<double>{1, 2, 3};
  }
  for (const double n : wavelength.refinements) {
    const Wrinkle found = least_of_fit(wave_numbers(), critical_strains_of_film(static_cast<int>(n)));
    wavelength.errors.push_back(std::abs(found.wavelength / held.wavelength - 1));
    onset.errors.push_back(std::abs(found.onset / held.onset - 1));
    thin_wavelength.errors.push_back(std::abs(found.wavelength / thin.wavelength - 1));
    thin_onset.errors.push_back(std::abs(found.onset / thin.onset - 1));
  }
  return {wavelength, onset, thin_wavelength, thin_onset};
}

}  // namespace bake::studies
