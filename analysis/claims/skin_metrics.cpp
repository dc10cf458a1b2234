// SPDX-License-Identifier: MIT
// Metrics of what dries in a skin: how it shrinks and folds, and how it loses its water.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "analysis/claims/finite.h"
#include "analysis/claims/metric.h"
#include "solver/io/mesh_file.h"
#include "solver/scene/settings.h"

namespace bake {
namespace {

/// The mesh of the skins at a frame. Throws InputError if the run has none.
Mesh skin_at(const Results& run, int frame) { return read_mesh(run.folder() / "skins" / frame_name(frame)); }

/// A field of a skin, one finite number for each vertex.
const std::vector<double>& field_of(const Results& run, const Mesh& skin, const char* name) {
  const MeshField* field = skin.find(name);
  if (!field || field->components != 1) throw InputError(fmt::format("{}: found skins without '{}'", run.folder().string(), name));
  for (const double value : field->values)
    expect_finite(value, [&] { return fmt::format("{}: {} of a skin at {} s", run.folder().string(), name, skin.time_s); });
  return field->values;
}

Vector3 corner(const Mesh& mesh, std::size_t i) {
  const double* x = &mesh.points[3 * static_cast<std::size_t>(mesh.cells[i])];
  return {x[0], x[1], x[2]};
}

/// The mean over the area of the skin of what `value` is at its vertices.
template <class Value>
double mean_over_area(const Mesh& skin, Value value) {
  double all = 0, sum = 0;
  for (std::size_t c = 0; c < skin.cells.size(); c += 3) {
    const double area = length(cross(corner(skin, c + 1) - corner(skin, c), corner(skin, c + 2) - corner(skin, c))) / 2;
    all += area;
    for (std::size_t k = 0; k < 3; ++k) sum += area / 3 * value(static_cast<std::size_t>(skin.cells[c + k]));
  }
  return all > 0 ? sum / all : std::nan("");
}

double gain_at(const Results& run, const char* column, const MetricPlace& at) {
  const double before = run.first(column);
  return before > 0 ? run.at(column, static_cast<std::size_t>(run.frame_at(at.time_s))) / before : std::nan("");
}

double skin_area_gain(const Results& run, const MetricPlace& at) { return gain_at(run, "skin_area_m2", at); }

double skin_slack(const Results& run, const MetricPlace& at) {
  return gain_at(run, "skin_area_m2", at) / std::pow(gain_at(run, "volume_m3", at), 2. / 3);
}

double curvature_of_frame(const Results& run, int frame) {
  const Mesh skin = skin_at(run, frame);
  const std::vector<double>& curvature = field_of(run, skin, "curvature");
  return std::sqrt(mean_over_area(skin, [&](std::size_t v) { return curvature[v] * curvature[v]; }));
}

double skin_curvature(const Results& run, const MetricPlace& at) { return curvature_of_frame(run, run.frame_at(at.time_s)); }

/// The share of the water that is gone when the curvature first is this share of the last one: a fold that is seen, and not the bending
/// of a fruit that becomes smaller.
double fold_onset(const Results& run, const MetricPlace&) {
  constexpr double k_seen = 0.15;
  const std::vector<double> water = run.column("water_mass_kg");
  const double least = k_seen * curvature_of_frame(run, static_cast<int>(water.size()) - 1);
  double before = curvature_of_frame(run, 0);
  for (std::size_t i = 1; i < water.size(); ++i) {
    const double now = curvature_of_frame(run, static_cast<int>(i));
    if (now >= least && before < least) {
      const double passed = (least - before) / (now - before);
      return 1 - (water[i - 1] + passed * (water[i] - water[i - 1])) / water[0];
    }
    before = now;
  }
  return std::nan("");
}

/// What a skin is folded out of a smooth shape: how far vertices have moved along their normals, without the best fit of that by
/// polynomials of degree 4 in the place at rest, which on a ball are the waves of degree 4 or less. `areas`: of the vertices, at rest.
Eigen::VectorXd folds_of(const Mesh& rest, const Mesh& now, const Eigen::VectorXd& areas) {
  const auto n = static_cast<Eigen::Index>(rest.vertex_count());
  const Eigen::Map<const Eigen::Matrix3Xd> before(rest.points.data(), 3, n), after(now.points.data(), 3, n);
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, n);
  for (std::size_t c = 0; c < rest.cells.size(); c += 3) {
    const auto [a, b, d] = std::array{rest.cells[c], rest.cells[c + 1], rest.cells[c + 2]};
    const Eigen::Vector3d normal = (before.col(b) - before.col(a)).cross(before.col(d) - before.col(a));
    for (const auto v : {a, b, d}) normals.col(v) += normal;
  }
  normals.colwise().normalize();
  const Eigen::Vector3d middle = before.rowwise().mean();
  const Eigen::Matrix3Xd q = (before.colwise() - middle) / (before.colwise() - middle).cwiseAbs().maxCoeff();
  constexpr int k_degree = 4, k_terms = 35;
  Eigen::MatrixXd smooth(n, k_terms);
  Eigen::Index term = 0;
  for (int i = 0; i <= k_degree; ++i)
    for (int j = 0; i + j <= k_degree; ++j)
      for (int k = 0; i + j + k <= k_degree; ++k)
        smooth.col(term++) = q.row(0).array().pow(i) * q.row(1).array().pow(j) * q.row(2).array().pow(k);
  const Eigen::VectorXd moved = (after - before).cwiseProduct(normals).colwise().sum(), weight = areas.cwiseSqrt();
  const Eigen::VectorXd fit = (weight.asDiagonal() * smooth).colPivHouseholderQr().solve(weight.cwiseProduct(moved));
  return moved - smooth * fit;
}

/// The wavelength of waves w with the mean square of their slope, at rest: 2 pi sqrt(int w^2 / int |grad w|^2).
double fold_wavelength(const Results& run, const MetricPlace& at) {
  const Mesh rest = skin_at(run, 0), now = skin_at(run, run.frame_at(at.time_s));
  if (now.points.size() != rest.points.size()) throw InputError(fmt::format("{}: found skins of another mesh", run.folder().string()));
  const auto n = static_cast<Eigen::Index>(rest.vertex_count());
  const auto corner_of = [&](std::size_t c) {
    return Eigen::Map<const Eigen::Vector3d>(&rest.points[3 * static_cast<std::size_t>(rest.cells[c])]);
  };
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(n);
  const auto for_each_triangle = [&](auto visit) {
    for (std::size_t c = 0; c < rest.cells.size(); c += 3) {
      const Eigen::Vector3d a = corner_of(c + 1) - corner_of(c), b = corner_of(c + 2) - corner_of(c);
      visit(&rest.cells[c], a, b, a.cross(b).norm() / 2);
    }
  };
  for_each_triangle([&](const std::int64_t* v, const auto&, const auto&, double area) {
    for (int k = 0; k < 3; ++k) areas[v[k]] += area / 3;
  });
  const Eigen::VectorXd w = folds_of(rest, now, areas);
  double slope_2 = 0;  // on a triangle |grad w|^2 = |w_a b - w_b a|^2 / (2 A)^2, with the rises w_a and w_b along its edges a and b
  for_each_triangle([&](const std::int64_t* v, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double area) {
    slope_2 += ((w[v[1]] - w[v[0]]) * b - (w[v[2]] - w[v[0]]) * a).squaredNorm() / (4 * area);
  });
  return 2 * std::numbers::pi * std::sqrt(areas.dot(w.cwiseAbs2()) / slope_2);
}

/// Boxes of flesh, to find whether some is near a point.
class Flesh {
 public:
  Flesh(std::vector<double> positions, double reach) : positions_(std::move(positions)), reach_(reach) {
    for (std::size_t row = 0; 3 * row < positions_.size(); ++row) boxes_[box_of(position(positions_, row), {0, 0, 0})].push_back(row);
  }
  bool is_near(const Vector3& x) const {
    for (int box = 0; box < 27; ++box) {
      const auto found = boxes_.find(box_of(x, {box / 9 - 1, box / 3 % 3 - 1, box % 3 - 1}));
      if (found == boxes_.end()) continue;
      for (const std::size_t row : found->second)
        if (length(position(positions_, row) - x) <= reach_) return true;
    }
    return false;
  }

 private:
  std::uint64_t box_of(const Vector3& x, const std::array<int, 3>& step) const {
    std::uint64_t box = 0;
    for (std::size_t d = 0; d < 3; ++d)
      box = box << 21 | (static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x[d] / reach_)) + step[d]) & 0x1fffff);
    return box;
  }
  std::vector<double> positions_;
  double reach_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> boxes_;
};

/// The distance of grid nodes of a run; its scene states that of paper quality.
double dx_of(const Results& run) {
  const auto& scene = run.description().at("scene");
  const auto quality = scene.at("quality").get<std::string>();
  for (const Quality known : {Quality::draft, Quality::standard, Quality::paper})
    if (quality == word_of(known)) return scene.at("grid").at("dx_m").get<double>() * coarsening(known);
  throw InputError(fmt::format("{}: found quality '{}', allowed: draft, standard, paper", run.folder().string(), quality));
}

double skin_off_flesh(const Results& run, const MetricPlace& at) {
  const int frame = run.frame_at(at.time_s);
  const Mesh skin = skin_at(run, frame);
  const Flesh flesh(run.frame(frame).positions(), dx_of(run));
  std::size_t off = 0;
  for (std::size_t v = 0; v < skin.vertex_count(); ++v)
    off += !flesh.is_near({skin.points[3 * v], skin.points[3 * v + 1], skin.points[3 * v + 2]});
  return skin.vertex_count() > 0 ? static_cast<double>(off) / static_cast<double>(skin.vertex_count()) : std::nan("");
}

double skin_dryness(const Results& run, const MetricPlace& at) {
  const int number = run.frame_at(at.time_s);
  const Mesh skin = skin_at(run, number);
  const std::vector<double>& outside = field_of(run, skin, "saturation");
  const CheckedFrame start = run.frame(0), now = run.frame(number);
  const auto places = start.positions();
  const auto saturations = now.column("saturation");
  const auto rows = rows_at_start(start, now);
  double sum = 0, count = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (!is_in_box(position(places, rows[row]), at)) continue;
    sum += static_cast<double>(saturations[row]);
    ++count;
  }
  return mean_over_area(skin, [&](std::size_t v) { return outside[v]; }) / (sum / count);
}

double height_over_thickness(const Results& run, const MetricPlace& at) {
  return gain_at(run, "height_m", at) / std::cbrt(gain_at(run, "volume_m3", at));
}

/// R^2 of a straight line through ln(water left) over time. What is left at the end is small and its logarithm large: the last twentieth
/// of the water is left out.
double drying_straightness(const Results& run, const MetricPlace&) {
  constexpr double k_least_left = 0.05;
  const std::vector<double> times = run.column("time_s"), water = run.column("water_mass_kg");
  double n = 0, t = 0, y = 0, tt = 0, ty = 0, yy = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double left = water[i] / water[0];
    if (!(left >= k_least_left)) continue;
    const double ln = std::log(left);
    n += 1, t += times[i], y += ln, tt += times[i] * times[i], ty += times[i] * ln, yy += ln * ln;
  }
  if (n < 3) return std::nan("");
  const double covariance = ty - t * y / n;
  return covariance * covariance / ((tt - t * t / n) * (yy - y * y / n));
}

double water_left(const Results& run, const MetricPlace& at) { return gain_at(run, "water_mass_kg", at); }

}  // namespace

std::vector<Metric> skin_metrics() {
  return {
      {"skin_area_gain", "1", non_negative, "area of the skin over that at the start", skin_area_gain, needs(), knows("time_s")},
      {"skin_slack", "1", non_negative,
       "the same over (volume over that at the start)^(2/3): 1 for a skin that shrinks along with its flesh, more for one that must fold",
       skin_slack, needs(), knows("time_s")},
      {"skin_curvature", "1/m", non_negative,
       "root mean square over the area of the skin's curvature, taken from its bending: what was curved at the start counts as flat",
       skin_curvature, needs(), knows("time_s")},
      {"fold_onset", "1", fraction, "share of the water that is gone when the skin's curvature reaches 15 % of that at the end",
       fold_onset},
      {"fold_wavelength", "m", non_negative,
       "wavelength of the folds of one closed skin, as lengths were before it shrank: of what it has moved along its normals, less the "
       "best fit by polynomials of degree 4",
       fold_wavelength, needs(), knows("time_s")},
      {"skin_off_flesh", "1", fraction, "share of the skin's vertices that are more than dx from the next particle of flesh",
       skin_off_flesh, needs(), knows("time_s")},
      {"skin_dryness", "1", non_negative,
       "mean saturation at the skin over that of the flesh that started in the box from low_m to high_m: below 1 if it dries from outside",
       skin_dryness, needs("low_m", "high_m"), knows("time_s")},
      {"height_over_thickness", "1", non_negative,
       "height over that of a body that has shrunk to the same volume evenly: 1 for a slice that stays flat", height_over_thickness,
       needs(), knows("time_s")},
      {"drying_straightness", "1", fraction, "R^2 of a straight line through ln(water left) over time, while a twentieth or more is left",
       drying_straightness},
      {"water_left", "1", non_negative, "water over the water at the start", water_left, needs(), knows("time_s")},
  };
}

}  // namespace bake
