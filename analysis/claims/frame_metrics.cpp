// SPDX-License-Identifier: MIT
// Metrics of frames. A claim names a particle by its position at the start; it is then followed by its identity.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/claims/finite.h"
#include "analysis/claims/metric.h"
#include "analysis/claims/volume_share.h"

namespace bake {
namespace {

double distance(const Vector3& a, const Vector3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// The particle that started nearest to `point`.
std::int64_t particle_at(const CheckedFrame& start, const Vector3& point) {
  const auto positions = start.positions();
  if (positions.empty()) throw InputError("found no particle at the start, allowed: a point inside a body");
  std::size_t nearest = 0;
  for (std::size_t row = 1; row < start.particles(); ++row)
    if (distance(position(positions, row), point) < distance(position(positions, nearest), point)) nearest = row;
  return start.identities()[nearest];
}

std::size_t row_of(const Results& run, int frame, const CheckedFrame& reader, std::int64_t particle) {
  const std::int64_t row = reader.rows_by_identity(particle, 1)[0];
  if (row < 0)
    throw InputError(fmt::format("{}: found no particle {}, allowed: frames of one run, and particles that stay in the domain",
                                 (run.folder() / "frames" / frame_name(frame)).string(), particle));
  return static_cast<std::size_t>(row);
}

Vector3 place_of(const Results& run, int frame, std::int64_t particle) {
  const CheckedFrame reader = run.frame(frame);
  return position(reader.positions(), row_of(run, frame, reader, particle));
}

double temperature_of(const Results& run, int frame, std::int64_t particle) {
  const CheckedFrame reader = run.frame(frame);
  return reader.column("temperature")[row_of(run, frame, reader, particle)];
}

/// The distance between two particles, divided by that at the start.
double distance_gain(const Results& run, const MetricPlace& at) {
  const CheckedFrame start = run.frame(0);
  const auto a = particle_at(start, *at.from_m), b = particle_at(start, *at.to_m);
  const auto apart = [&](int frame) {
    const Vector3 place = place_of(run, frame, a);
    return distance(place, place_of(run, frame, b));
  };
  const double before = apart(0);
  return before > 0 ? apart(run.frame_at(at.time_s)) / before : std::nan("");
}

double temperature_at(const Results& run, const MetricPlace& at) {
  return temperature_of(run, run.frame_at(at.time_s), particle_at(run.frame(0), *at.point_m));
}

double temperature_lead(const Results& run, const MetricPlace& at) {
  const CheckedFrame start = run.frame(0);
  const int frame = run.frame_at(at.time_s);
  const auto a = particle_at(start, *at.from_m), b = particle_at(start, *at.to_m);
  if (a == b) throw NoNumber(fmt::format("{}: found one particle nearest to from_m and to_m, allowed: two", run.folder().string()));
  return temperature_of(run, frame, a) - temperature_of(run, frame, b);
}

/// The water of a particle over what it had at the start.
double water_at(const Results& run, const MetricPlace& at) {
  const CheckedFrame start = run.frame(0);
  const auto particle = particle_at(start, *at.point_m);
  const auto held = [&](int frame, const CheckedFrame& reader) {
    return static_cast<double>(reader.column("water_mass")[row_of(run, frame, reader, particle)]);
  };
  const double before = held(0, start);
  const int frame = run.frame_at(at.time_s);
  return before > 0 ? held(frame, run.frame(frame)) / before : std::nan("");
}

/// Time of the first frame at which a particle has a temperature; infinite if it never has.
double time_to_reach(const Results& run, const MetricPlace& at) {
  const auto particle = particle_at(run.frame(0), *at.point_m);
  const auto times = run.column("time_s");
  for (std::size_t frame = 0; frame < times.size(); ++frame)
    if (temperature_of(run, static_cast<int>(frame), particle) >= *at.temperature_C) return times[frame];
  return k_infinity;
}

/// The share of its water that each particle has lost since the start.
std::vector<double> dryness(const CheckedFrame& start, const CheckedFrame& now) {
  const auto before = start.column("water_mass"), after = now.column("water_mass");
  std::vector<double> dry;
  for (const std::size_t row : rows_at_start(start, now)) {
    const auto had = static_cast<double>(before[row]);
    dry.push_back(had > 0 ? 1 - static_cast<double>(after[dry.size()]) / had : 0);
  }
  return dry;
}

/// The volume that has dried, divided by the area that touches air: the depth of the layer if it were equally deep everywhere. A particle
/// that has lost half the given share of its water does not count, one that has lost one and a half times the share counts fully, and the
/// weight is linear between. There are two reasons: with a sharp edge a layer of few particles would change in jumps, and with no lower end
/// round-off inside a whole loaf would add up. Temperature cannot replace water here, because it passes through a loaf long before the
/// crust has formed.
double crust_thickness(const Results& run, const MetricPlace& at) {
  const int number = run.frame_at(at.time_s);
  const CheckedFrame now = run.frame(number);
  const auto volumes = now.column("volume");
  const auto dry = dryness(run.frame(0), now);
  double crust = 0;
  for (std::size_t row = 0; row < volumes.size(); ++row)
    crust += static_cast<double>(volumes[row]) * std::clamp(dry[row] / *at.dried_share - 0.5, 0.0, 1.0);
  const double area = run.at("surface_m2", static_cast<std::size_t>(number));
  return area > 0 ? crust / area : std::nan("");
}

/// The horizontal centre of the particles at the start.
std::array<double, 2> axis_of(const Results& run) {
  const auto positions = run.frame(0).positions();
  std::array<double, 2> sum{};
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    sum[0] += positions[i];
    sum[1] += positions[i + 1];
  }
  const std::size_t count = positions.size() / 3;
  return {sum[0] / static_cast<double>(count), sum[1] / static_cast<double>(count)};
}

double distance_from(const std::array<double, 2>& axis, const Vector3& place) { return std::hypot(place[0] - axis[0], place[1] - axis[1]); }

double outflow(const Results& run, const MetricPlace& at) {
  const auto axis = axis_of(run);
  const CheckedFrame frame = run.frame(run.frame_at(at.time_s));
  const auto positions = frame.positions();
  return volume_share(frame, [&](std::size_t row) { return distance_from(axis, position(positions, row)) > *at.radius_m; });
}

/// The distance from an upright axis that a share of the volume does not exceed. A whole body's rim would be one particle.
double radius_of_share(const CheckedFrame& frame, const std::array<double, 2>& axis, double share) {
  const auto positions = frame.positions();
  const auto volumes = frame.column("volume");
  std::vector<std::pair<double, double>> radius_and_volume;
  double all = 0;
  for (std::size_t row = 0; row < volumes.size(); ++row) {
    radius_and_volume.emplace_back(distance_from(axis, position(positions, row)), volumes[row]);
    all += static_cast<double>(volumes[row]);
  }
  std::sort(radius_and_volume.begin(), radius_and_volume.end());
  double within = 0;
  for (const auto& [radius, volume] : radius_and_volume)
    if (all > 0 && (within += volume) >= share * all) return radius;
  return std::nan("");
}

std::array<double, 2> axis_at(const Results& run, const MetricPlace& at) {
  return at.point_m ? std::array{(*at.point_m)[0], (*at.point_m)[1]} : axis_of(run);
}

double diameter(const Results& run, const MetricPlace& at) {
  constexpr double k_share = 0.99;
  return 2 * radius_of_share(run.frame(run.frame_at(at.time_s)), axis_at(run, at), k_share);
}

/// The diameter over time, and which share it has gained of what it gains at most.
struct Spread {
  std::vector<double> times, diameters, gained;

  Spread(const Results& run, MetricPlace at) : times(run.column("time_s")) {
    run.expect_change();
    for (const double time : times) {
      at.time_s = time;
      diameters.push_back(diameter(run, at));
    }
    for (const double now : diameters) gained.push_back((now - diameters.front()) / gain());
  }
  double gain() const { return largest_of(diameters) - diameters.front(); }
};

double spread_rate(const Results& run, const MetricPlace& at) {
  constexpr double k_from = 0.1, k_to = 0.9;
  const Spread spread(run, at);
  return (k_to - k_from) * spread.gain() /
         (time_of_share(spread.times, spread.gained, k_to) - time_of_share(spread.times, spread.gained, k_from));
}

double time_to_spread(const Results& run, const MetricPlace& at) {
  constexpr double k_share = 0.95;
  const Spread spread(run, at);
  return time_of_share(spread.times, spread.gained, k_share);
}

/// Growth between frames belongs to the time between them.
double set_time(const Results& run, const MetricPlace& at) {
  const Spread spread(run, at);
  std::vector<double> times, rates;
  for (std::size_t i = 1; i < spread.times.size(); ++i) {
    times.push_back((spread.times[i - 1] + spread.times[i]) / 2);
    rates.push_back((spread.diameters[i] - spread.diameters[i - 1]) / (spread.times[i] - spread.times[i - 1]));
  }
  const double half = largest_of(rates) / 2;
  if (!(half > 0)) return std::nan("");
  for (std::size_t i = rates.size() - 1; i > 0; --i)
    if (rates[i - 1] >= half && rates[i] < half)
      return times[i - 1] + (times[i] - times[i - 1]) * (rates[i - 1] - half) / (rates[i - 1] - rates[i]);
  return k_infinity;
}

double diameter_kept(const Results& run, const MetricPlace& at) {
  const Spread spread(run, at);
  return spread.diameters.back() / largest_of(spread.diameters);
}

double height_over_diameter(const Results& run, const MetricPlace& at) {
  return run.at("height_m", static_cast<std::size_t>(run.frame_at(at.time_s))) / diameter(run, at);
}

/// The top within a radius of the axis: the highest particle of each ring of equal area.
std::vector<std::array<double, 2>> top_profile(const Results& run, const MetricPlace& at) {
  constexpr std::size_t k_rings = 8;
  const auto axis = axis_at(run, at);
  std::vector<std::array<double, 2>> highest(k_rings, {0, -k_infinity});
  const auto positions = run.frame(run.frame_at(at.time_s)).positions();
  for (std::size_t row = 0; row < positions.size() / 3; ++row) {
    const Vector3 place = position(positions, row);
    const double share = std::pow(distance_from(axis, place) / *at.radius_m, 2);
    if (share >= 1) continue;
    auto& ring = highest[static_cast<std::size_t>(share * k_rings)];
    if (place[2] > ring[1]) ring = {share * *at.radius_m * *at.radius_m, place[2]};
  }
  std::erase_if(highest, [](const auto& ring) { return !std::isfinite(ring[1]); });
  return highest;
}

/// kappa of z = z_0 - kappa r^2 / 2 through the top: least squares in r^2.
double top_curvature(const Results& run, const MetricPlace& at) {
  const auto top = top_profile(run, at);
  const auto n = static_cast<double>(top.size());
  double x = 0, z = 0, xx = 0, xz = 0;
  for (const auto& [r2, height] : top) {
    x += r2 / n;
    z += height / n;
  }
  for (const auto& [r2, height] : top) {
    xx += (r2 - x) * (r2 - x);
    xz += (r2 - x) * (height - z);
  }
  return xx > 0 ? -2 * xz / xx : std::nan("");
}

/// Innermost and outermost ring of the same profile.
double dome_rise(const Results& run, const MetricPlace& at) {
  const auto top = top_profile(run, at);
  return top.size() > 1 ? (top.front()[1] - top.back()[1]) / (2 * *at.radius_m) : std::nan("");
}

/// The top over the inner half of the radius and the top over the next quarter, each the mean of rings of equal width in which the highest
/// particle stands; their difference over the height. A paraboloid has 0.27, whatever its height, a flat top 0, a dent less. The outer
/// quarter, where every body goes down to its rim, does not count.
double doming(const Results& run, const MetricPlace& at) {
  constexpr std::size_t k_rings = 8, k_inner = 4, k_outer = 6;
  const double width = diameter(run, at) / 2 / k_rings;
  const auto axis = axis_at(run, at);
  std::array<double, k_outer> top;
  top.fill(-k_infinity);
  const CheckedFrame frame = run.frame(run.frame_at(at.time_s));
  const auto positions = frame.positions();
  double lowest = k_infinity;
  for (std::size_t row = 0; row < positions.size() / 3; ++row) {
    const Vector3 place = position(positions, row);
    lowest = std::min(lowest, place[2]);
    const double ring = distance_from(axis, place) / width;
    if (ring < k_outer) top[static_cast<std::size_t>(ring)] = std::max(top[static_cast<std::size_t>(ring)], place[2]);
  }
  const double inner = std::accumulate(top.begin(), top.begin() + k_inner, 0.0) / k_inner;
  const double outer = std::accumulate(top.begin() + k_inner, top.end(), 0.0) / (k_outer - k_inner);
  const double height = *std::max_element(top.begin(), top.end()) - lowest;
  return std::isfinite(inner) && std::isfinite(outer) && height > 0 ? (inner - outer) / height : std::nan("");
}

}  // namespace

std::vector<Metric> frame_metrics() {
  return {
      {"distance_gain", "1", non_negative,
       "distance of the particles that started nearest to from_m and to_m, over that at the start: a slit's width", distance_gain,
       needs("from_m", "to_m"), knows("time_s")},
      {"temperature_at", "C", above_absolute_zero, "temperature of the particle that started nearest to point_m", temperature_at,
       needs("point_m"), knows("time_s")},
      {"temperature_lead", "K", any_number,
       "temperature of the particle that started nearest to from_m, less that of the one nearest to to_m: surface and core",
       temperature_lead, needs("from_m", "to_m"), knows("time_s")},
      {"water_at", "1", non_negative, "water of the particle that started nearest to point_m, over what it had at the start", water_at,
       needs("point_m"), knows("time_s")},
      {"time_to_reach", "s", non_negative, "time at which the particle that started nearest to point_m reaches temperature_C",
       time_to_reach, needs("point_m", "temperature_C")},
      {"crust_thickness", "m", non_negative,
       "mean thickness of the layer that has lost dried_share of its water: its volume over the area that touches air", crust_thickness,
       needs("dried_share"), knows("time_s")},
      {"outflow", "1", fraction, "share of the volume that is farther than radius_m from the upright axis through the start's middle",
       outflow, needs("radius_m"), knows("time_s")},
      {"diameter", "m", non_negative,
       "twice the distance from the upright axis (through point_m, or the start's middle) within which 99 % of the volume is", diameter,
       needs(), knows("point_m", "time_s")},
      {"spread_rate", "m/s", non_negative,
       "rate at which that diameter grows, the mean from a tenth to nine tenths of what it gains at most", spread_rate, needs(),
       knows("point_m")},
      {"time_to_spread", "s", non_negative, "time at which that diameter has 95 % of what it gains at most", time_to_spread, needs(),
       knows("point_m")},
      {"set_time", "s", non_negative, "last time at which that diameter grows half as fast as it does at most", set_time, needs(),
       knows("point_m")},
      {"diameter_kept", "1", fraction, "that diameter at the end over the largest on the way: less than 1 for what draws together again",
       diameter_kept, needs(), knows("point_m")},
      {"height_over_diameter", "1", non_negative, "height over that diameter: what is flat has little", height_over_diameter, needs(),
       knows("point_m", "time_s")},
      {"top_curvature", "1/m", any_number, "curvature of the top within radius_m of that axis: above 0 for a dome, below for a dent",
       top_curvature, needs("radius_m"), knows("point_m", "time_s")},
      {"dome_rise", "1", any_number, "height of the top at that axis above the top just within radius_m of it, over twice radius_m",
       dome_rise, needs("radius_m"), knows("point_m", "time_s")},
      {"doming", "1", any_number,
       "mean height of the top over the inner half of the radius, less that over the next quarter, over the height: 0.27 for a paraboloid, "
       "0 for a flat top, less for a dented one; the radius is half the diameter",
       doming, needs(), knows("point_m", "time_s")},
  };
}

}  // namespace bake
