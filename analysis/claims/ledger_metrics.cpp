// SPDX-License-Identifier: MIT
// Metrics of the ledger.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/claims/finite.h"
#include "analysis/claims/metric.h"

namespace bake {
namespace {

/// The largest without regard to sign: a negative one would turn a drift into a small number.
double largest_size(const std::vector<double>& values) { return larger(std::abs(largest_of(values)), std::abs(smallest_of(values))); }

OfRun last(const char* column) {
  return [=](const Results& run, const MetricPlace&) { return run.last(column); };
}

OfRun largest(const char* column) {
  return [=](const Results& run, const MetricPlace&) { return largest_of(run.column(column)); };
}

OfRun smallest(const char* column) {
  return [=](const Results& run, const MetricPlace&) { return smallest_of(run.column(column)); };
}

OfRun gain(const char* column) {
  return [=](const Results& run, const MetricPlace&) {
    run.expect_change();
    const double before = run.first(column);
    return before > 0 ? run.last(column) / before : std::nan("");
  };
}

/// The mass that there was at the start and that was poured.
double mass_of(const Results& run, std::string_view column) { return run.first(column) + run.last(fmt::format("emitted_{}", column)); }

double volume_gain(const Results& run, const MetricPlace&) {
  run.expect_change();
  const double before = run.first("volume_m3") + run.last("emitted_volume_m3");
  return before > 0 ? run.last("volume_m3") / before : std::nan("");
}

/// The change of momentum along `axis` that the booked impulses do not explain, divided by the mass.
OfRun momentum_drift(char axis) {
  return [=](const Results& run, const MetricPlace&) {
    const auto name = [&](const char* what) { return fmt::format("{}_{}_kg_m_per_s", what, axis); };
    const auto momentum = name("momentum"), impulse = name("impulse"), remap = name("water_remap_momentum"),
               retired = name("retired_momentum"), emitted = name("emitted_momentum");
    return run.drift({{momentum.c_str(), 1}, {impulse.c_str(), -1}, {remap.c_str(), -1}, {retired.c_str(), 1}, {emitted.c_str(), -1}}) /
           (mass_of(run, "solid_mass_kg") + mass_of(run, "water_mass_kg"));
  };
}

double springback(const Results& run, const MetricPlace& at) {
  run.expect_change();
  const auto height = [&](const std::optional<double>& time) { return run.at("height_m", static_cast<std::size_t>(run.frame_at(time))); };
  const double before = height(at.reference_time_s.value_or(0)), pressed = height(at.time_s), lost = before - pressed;
  return lost != 0 ? (run.last("height_m") - pressed) / lost : std::nan("");
}

/// A number of [oven] that does not change with time.
double steady(const Results& run, const char* key) {
  const auto& value = run.description().at("scene").at("oven").at(key);
  if (!value.is_number())
    throw InputError(fmt::format("{}: scene.oven.{}: found one that changes with time, allowed: a number", run.folder().string(), key));
  return value.get<double>();
}

/// Is there one in a list of the scene with a temperature or a flux of its own?
bool gives_heat(const Results& run, const char* list) {
  const auto& scene = run.description().at("scene");
  if (!scene.contains(list)) return false;
  return std::any_of(scene.at(list).begin(), scene.at(list).end(), [](const auto& one) {
    return (one.contains("temperature_C") && !one.at("temperature_C").is_null()) ||
           (one.contains("heat_flux_W_per_m2") && !one.at("heat_flux_W_per_m2").is_null());
  });
}

/// Of the whole surface: theta_out - q / beta, q being the heat that came in between the frames around, over area and time. Particles and
/// nodes lie deeper, which makes some 10 K in a loaf; this is the temperature that the layer above them is solved with.
double surface_temperature(const Results& run, const MetricPlace& at) {
  run.expect_change();
  for (const char* list : {"collider", "grip", "face"})
    if (gives_heat(run, list))
      throw InputError(
          fmt::format("{}: scene.{}: found one that gives heat, allowed: heat from the air alone", run.folder().string(), list));
  const std::vector<double> times = run.column("time_s"), heat = run.column("heat_exchanged_J");
  const auto frame = static_cast<std::size_t>(run.frame_at(at.time_s)), before = frame > 0 ? frame - 1 : 0,
             after = std::min(frame + 1, times.size() - 1);
  const double exposed = (times[after] - times[before]) * run.at("surface_m2", frame);
  const double beta = steady(run, "heat_transfer_coefficient_W_per_m2K");
  return exposed * beta > 0 ? steady(run, "temperature_C") - (heat[after] - heat[before]) / (exposed * beta) : std::nan("");
}

}  // namespace

std::vector<Metric> ledger_metrics() {
  return {
      {"volume_gain", "1", non_negative, "volume at the end over volume at the start and of what was poured", volume_gain},
      {"poured_mass", "kg", non_negative, "mass of the solid that emitters have poured until the end", last("emitted_solid_mass_kg")},
      {"height_gain", "1", non_negative, "height at the end over height at the start", gain("height_m")},
      {"extent_x_gain", "1", non_negative, "extent along x at the end over that at the start", gain("extent_x_m")},
      {"extent_y_gain", "1", non_negative, "extent along y at the end over that at the start", gain("extent_y_m")},
      {"height", "m", non_negative, "height at the end", last("height_m")},
      {"largest_height", "m", non_negative, "largest height on the way", largest("height_m")},
      {"springback", "1", any_number, "share of the height that was lost from reference_time_s to time_s and is there again at the end",
       springback, needs(), knows("reference_time_s", "time_s")},
      {"surface", "m^2", non_negative, "surface that touches air at the end", last("surface_m2")},
      {"surface_temperature", "C", above_absolute_zero,
       "mean temperature of the surface in a steady oven, from the heat that comes through it; of what touches air alone",
       surface_temperature, needs(), knows("time_s")},
      {"water_lost_share", "1", non_negative, "evaporated water over the water at the start and of what was poured",
       [](const Results& run, const MetricPlace&) { return run.last("water_evaporated_kg") / mass_of(run, "water_mass_kg"); }},
      {"gas_made", "mol", non_negative, "CO2 made until the end", last("gas_mol")},
      {"coldest", "C", above_absolute_zero, "lowest particle temperature at the end", last("temperature_min_C")},
      {"mean_temperature", "C", above_absolute_zero, "mean temperature by volume at the end", last("temperature_mean_C")},
      {"hottest_ever", "C", above_absolute_zero, "highest particle temperature of any frame", largest("temperature_max_C")},
      {"coldest_ever", "C", above_absolute_zero, "lowest particle temperature of any frame", smallest("temperature_min_C")},
      {"dissipated", "J", non_negative, "plastic work until the end", last("dissipated_J")},
      {"solid_drift", "1", non_negative, "largest unexplained change of the solid's mass, relative",
       [](const Results& run, const MetricPlace&) {
         return run.drift({{"solid_mass_kg", 1}, {"retired_solid_mass_kg", 1}, {"emitted_solid_mass_kg", -1}}) /
                mass_of(run, "solid_mass_kg");
       }},
      {"water_drift", "1", non_negative, "largest unexplained change of the water's mass, relative",
       [](const Results& run, const MetricPlace&) {
         return run.drift({{"water_mass_kg", 1}, {"water_evaporated_kg", 1}, {"retired_water_mass_kg", 1}, {"emitted_water_mass_kg", -1}}) /
                mass_of(run, "water_mass_kg");
       }},
      {"heat_drift", "1", non_negative, "largest unexplained change of the heat content, over the largest content",
       [](const Results& run, const MetricPlace&) {
         return run.drift({{"heat_content_J", 1},
                           {"heat_exchanged_J", -1},
                           {"latent_heat_J", 1},
                           {"vapour_heat_J", 1},
                           {"expansion_heat_J", 1},
                           {"water_remap_heat_J", -1},
                           {"retired_heat_content_J", 1},
                           {"emitted_heat_content_J", -1}}) /
                largest_size(run.column("heat_content_J"));
       }},
      {"momentum_drift_x", "m/s", non_negative, "largest unexplained change of momentum along x, over the mass", momentum_drift('x')},
      {"momentum_drift_y", "m/s", non_negative, "the same along y", momentum_drift('y')},
      {"momentum_drift_z", "m/s", non_negative, "the same along z", momentum_drift('z')},
      {"retired_particles", "1", non_negative, "particles that left through open faces", last("retired_particles")},
  };
}

}  // namespace bake
