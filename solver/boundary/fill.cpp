// SPDX-License-Identifier: MIT
#include "solver/boundary/fill.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "solver/core/parallel.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

/// Random numbers that are the same everywhere: splitmix64. [Steele, Lea, Flood 2014]
class Random {
 public:
  /// `skipped`: how many of the seed's numbers are left out.
  explicit Random(std::uint64_t seed, std::uint64_t skipped = 0) : state_(seed + skipped * k_stride) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += k_stride);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< in [0, 1)
  Vector3 in_cube() {                                                       ///< in [-1, 1)^3
    const double x = uniform(), y = uniform(), z = uniform();
    return {2 * x - 1, 2 * y - 1, 2 * z - 1};
  }

 private:
  static constexpr std::uint64_t k_stride = 0x9e3779b97f4a7c15u;
  std::uint64_t state_;
};

using Count3 = std::array<std::int64_t, 3>;

double places_in(const Box3& box, double spacing_m) {
  double places = 1;
  for (int i = 0; i < 3; ++i) places *= (box.high[i] - box.low[i]) / spacing_m + 1;
  return places;
}

Box3 finite_bounds(const Shape& shape, double spacing_m) {
  if (!(spacing_m > 0) || !std::isfinite(spacing_m)) throw std::invalid_argument("the spacing of a filling must be a number above 0");
  const Box3 box = shape.bounds();
  const double cells = places_in(box, spacing_m);
  if (!std::isfinite(cells)) throw std::invalid_argument("a shape without end cannot be filled");
  if (cells > k_most_places) throw std::invalid_argument("the spacing of a filling is too small for its shape (more than 10^10 cells)");
  return box;
}

/// Dart throwing on a grid so fine that a cell holds at most one point. [Bridson 2007]
class PoissonSampler {
 public:
  PoissonSampler(const Shape& shape, const Box3& bounds, double radius, std::uint64_t seed)
      : shape_(shape), radius_(radius), cell_(radius / std::sqrt(3.0)), random_(seed) {
    // The packing extends beyond the shape, because points crowd at the rim of a packing; the shape then cuts through its interior.
    reach_ = 2 * radius;
    for (int i = 0; i < 3; ++i) {
      low_[i] = bounds.low[i] - reach_ - k_fringe * cell_;
      size_[i] = static_cast<std::int64_t>(std::ceil((bounds.high[i] + reach_ - low_[i]) / cell_)) + k_fringe + 1;
    }
    stored_.assign(static_cast<std::size_t>(size_[0] * size_[1] * size_[2]), -1);
    list_neighbours();
  }

  std::vector<Point> fill() {
    for_cells(k_fringe, [&](const Count3& c, std::size_t cell) {
      if (stored_[cell] >= 0) return;
      const Vector3 place = 0.5 * (random_.in_cube() + Vector3{1, 1, 1});
      if (try_point(low_ + cell_ * (place + Vector3{double(c[0]), double(c[1]), double(c[2])}))) grow();
    });
    std::vector<Point> inside;
    for_cells(k_fringe, [&](const Count3&, std::size_t cell) {
      if (stored_[cell] >= 0 && is_inside_[stored_[cell]]) inside.push_back(points_[stored_[cell]]);
    });
    return inside;
  }

 private:
  static constexpr int k_fringe = 2;  ///< cells around the grid that stay empty: neighbours need no bounds check
  static constexpr int k_tries = 30;

  template <class Visit>
  void for_cells(std::int64_t margin, Visit visit) const {
    for (std::int64_t i = margin; i < size_[0] - margin; ++i)
      for (std::int64_t j = margin; j < size_[1] - margin; ++j)
        for (std::int64_t k = margin; k < size_[2] - margin; ++k) visit(Count3{i, j, k}, index({i, j, k}));
  }

  std::size_t index(const Count3& c) const { return static_cast<std::size_t>((c[0] * size_[1] + c[1]) * size_[2] + c[2]); }

  /// Offsets of the cells that may hold a point within the radius, nearest first, so that most darts are rejected early.
  void list_neighbours() {
    std::vector<std::pair<std::int64_t, std::ptrdiff_t>> offsets;
    for (std::int64_t i = -2; i <= 2; ++i)
      for (std::int64_t j = -2; j <= 2; ++j)
        for (std::int64_t k = -2; k <= 2; ++k)
          if (i * i + j * j + k * k < 12) offsets.push_back({i * i + j * j + k * k, (i * size_[1] + j) * size_[2] + k});
    std::sort(offsets.begin(), offsets.end());
    for (const auto& [square, offset] : offsets) neighbours_.push_back(offset);
  }

  /// Accepts the point if it is near the shape and far enough from all others.
  bool try_point(const Point& x) {
    Count3 c;
    for (int i = 0; i < 3; ++i) {
      c[i] = static_cast<std::int64_t>(std::floor((x[i] - low_[i]) / cell_));
      if (c[i] < k_fringe || c[i] >= size_[i] - k_fringe) return false;
    }
    const std::size_t cell = index(c);
    for (const std::ptrdiff_t offset : neighbours_) {
      const std::int32_t other = stored_[cell + offset];
      if (other >= 0 && dot(x - points_[other], x - points_[other]) < radius_ * radius_) return false;
    }
    const double distance = shape_.distance(x);
    if (distance > reach_) return false;
    is_inside_.push_back(distance <= 0);
    stored_[cell] = static_cast<std::int32_t>(points_.size());
    active_.push_back(stored_[cell]);
    points_.push_back(x);
    return true;
  }

  /// From the latest active point, throws darts into the shell between one and two radii until it is surrounded. (The
  /// latest rather than a random one, for the cache.)
  void grow() {
    while (!active_.empty()) {
      const Point centre = points_[active_.back()];
      bool placed = false;
      for (int attempt = 0; attempt < k_tries && !placed; ++attempt) placed = try_point(centre + radius_ * in_shell());
      if (!placed) active_.pop_back();
    }
  }

  Vector3 in_shell() {
    for (;;) {
      const Vector3 x = 2.0 * random_.in_cube();
      if (dot(x, x) >= 1 && dot(x, x) < 4) return x;
    }
  }

  const Shape& shape_;
  double radius_, cell_, reach_;
  Point low_;
  Count3 size_;
  Random random_;
  std::vector<std::int32_t> stored_;  ///< per cell: index of its point, or -1
  std::vector<std::ptrdiff_t> neighbours_;
  std::vector<Point> points_;
  std::vector<bool> is_inside_;  ///< of the points
  std::vector<std::int32_t> active_;
};

/// The places of a cubic lattice, layer by layer along x.
class LatticeOfPlaces {
 public:
  LatticeOfPlaces(const Shape& shape, double spacing_m, double jitter, std::uint64_t seed)
      : shape_(shape), spacing_(spacing_m), jitter_(jitter), seed_(seed) {
    const Box3 box = finite_bounds(shape, spacing_m);
    for (int i = 0; i < 3; ++i) {
      // One more layer on either side, from which points may be displaced into the shape.
      count_[i] = std::max<std::int64_t>(1, std::llround((box.high[i] - box.low[i]) / spacing_m)) + 2;
      first_[i] = 0.5 * (box.low[i] + box.high[i]) - 0.5 * static_cast<double>(count_[i] - 1) * spacing_m;
    }
  }
  std::int64_t layers() const { return count_[0]; }
  /// Not inlined: two copies of it may round differently.
  [[gnu::noinline]] void visit_layer(std::int64_t i, const std::function<bool(const Point&)>& wanted,
                                     const std::function<void(const Point&)>& found) const {
    std::uint64_t drawn = static_cast<std::uint64_t>(3 * i * count_[1] * count_[2]);  // three numbers for every place, wanted or not
    for (std::int64_t j = 0; j < count_[1]; ++j) {
      for (std::int64_t k = 0; k < count_[2]; ++k, drawn += 3) {
        const Point place = first_ + spacing_ * Vector3{double(i), double(j), double(k)};
        if (!wanted(place)) continue;
        const Point x = place + 0.5 * jitter_ * spacing_ * Random(seed_, drawn).in_cube();
        if (shape_.distance(x) <= 0) found(x);
      }
    }
  }

 private:
  const Shape& shape_;
  double spacing_, jitter_;
  std::uint64_t seed_;
  Count3 count_;
  Point first_;
};

/// A cube, halved until its parts are inside of a shape, outside, or of the finest size.
struct HalvedCube {
  std::int64_t halves_inside = 0;  ///< halves of cubes of the finest size
  std::vector<Point> cut;          ///< centres of those that the surface may cut

  void add(const Shape& shape, const Point& centre, double edge, int halvings) {
    const double distance = shape.distance(centre), reach = 0.5 * std::sqrt(3.0) * edge;
    if (distance > reach) return;
    if (distance < -reach) {
      halves_inside += std::int64_t{2} << (3 * halvings);
    } else if (halvings == 0) {
      cut.push_back(centre);
    } else {
      for (const double x : {-0.25, 0.25})
        for (const double y : {-0.25, 0.25})
          for (const double z : {-0.25, 0.25}) add(shape, centre + edge * Vector3{x, y, z}, 0.5 * edge, halvings - 1);
    }
  }
};

/// The volume of a shape in cubes, of which the finest have this edge.
struct SampledVolume {
  double volume;  ///< [m^3]
  double cut;     ///< cubes of the finest size that the surface may cut
};

SampledVolume sample_volume(const Shape& shape, double finest, int halvings) {
  const Box3 box = shape.bounds();
  const double edge = std::ldexp(finest, halvings);
  std::vector<Point> centres;
  for (double x = 0.5; (x - 0.5) * edge < box.high[0] - box.low[0]; ++x)
    for (double y = 0.5; (y - 0.5) * edge < box.high[1] - box.low[1]; ++y)
      for (double z = 0.5; (z - 0.5) * edge < box.high[2] - box.low[2]; ++z) centres.push_back(box.low + edge * Vector3{x, y, z});
  std::vector<HalvedCube> cubes(centres.size());
  for_each_parallel(cubes.size(), 1, [&](std::size_t c) { cubes[c].add(shape, centres[c], edge, halvings); });
  std::vector<std::size_t> cut_before(cubes.size());
  std::transform_exclusive_scan(cubes.begin(), cubes.end(), cut_before.begin(), std::size_t{0}, std::plus{},
                                [](const HalvedCube& cube) { return cube.cut.size(); });
  for_each_parallel(cubes.size(), 1, [&](std::size_t c) {
    Random random(2019, 3 * cut_before[c]);
    for (const Point& centre : cubes[c].cut) {
      const Vector3 off = 0.5 * finest * random.in_cube();
      for (const Point& x : {centre + off, centre - off}) cubes[c].halves_inside += shape.distance(x) <= 0;
    }
  });
  double halves = 0, cut = 0;
  for (const HalvedCube& cube : cubes) {
    halves += static_cast<double>(cube.halves_inside);
    cut += static_cast<double>(cube.cut.size());
  }
  return {0.5 * halves * finest * finest * finest, cut};
}

}  // namespace

void visit_lattice(const Shape& shape, double spacing_m, double jitter, std::uint64_t seed, const std::function<bool(const Point&)>& wanted,
                   const std::function<void(const Point&)>& found) {
  const LatticeOfPlaces lattice(shape, spacing_m, jitter, seed);
  for (std::int64_t i = 0; i < lattice.layers(); ++i) lattice.visit_layer(i, wanted, found);
}

std::vector<Point> fill_lattice(const Shape& shape, double spacing_m, double jitter, std::uint64_t seed) {
  const LatticeOfPlaces lattice(shape, spacing_m, jitter, seed);
  std::vector<std::vector<Point>> layers(static_cast<std::size_t>(lattice.layers()));
  for_each_parallel(layers.size(), 1, [&](std::size_t i) {
    lattice.visit_layer(
        static_cast<std::int64_t>(i), [](const Point&) { return true; }, [&](const Point& x) { layers[i].push_back(x); });
  });
  std::vector<Point> inside;
  inside.reserve(std::transform_reduce(layers.begin(), layers.end(), std::size_t{0}, std::plus{}, std::mem_fn(&std::vector<Point>::size)));
  for (std::vector<Point>& layer : layers) {
    inside.insert(inside.end(), layer.begin(), layer.end());
    layer = {};
  }
  return inside;
}

std::vector<Point> fill_poisson(const Shape& shape, double spacing_m, std::uint64_t seed) {
  const Box3 box = finite_bounds(shape, spacing_m);
  return PoissonSampler(shape, box, k_poisson_radius * spacing_m, seed).fill();
}

FillingSize estimate_filling(const Shape& shape, double spacing_m) {
  return {shape.volume() / (spacing_m * spacing_m * spacing_m), places_in(shape.bounds(), spacing_m)};
}

double sampled_volume(const Shape& shape, double at_least_m3) {
  constexpr double k_error = 2e-4, k_most_cut = 5e5;
  constexpr int k_most_rounds = 20;  // beyond them are rounding errors: of a shape that touches itself in a point
  const Box3 box = shape.bounds();
  const Vector3 extent = box.high - box.low;
  const double longest = *std::max_element(extent.begin(), extent.end());
  if (!std::isfinite(longest)) return k_infinity;
  if (!(*std::min_element(extent.begin(), extent.end()) > 0)) return 0;
  double finest = longest / 64;
  for (int round = 1;; ++round) {
    const SampledVolume sampled = sample_volume(shape, finest, std::max(0, std::ilogb(longest / 16 / finest)));
    const double error = 0.25 * std::sqrt(sampled.cut) * finest * finest * finest;
    const double wanted = k_error * std::max(sampled.volume, at_least_m3);
    if (error <= wanted || sampled.cut > k_most_cut || round == k_most_rounds) return sampled.volume;
    // the error goes with finest^2, the number of cut cubes with 1 / finest^2
    finest *= std::max({0.25, std::sqrt(0.5 * sampled.cut / k_most_cut), 0.95 * std::sqrt(wanted / error)});
  }
}

double Shape::volume() const { return sampled_volume(*this); }

}  // namespace bake
