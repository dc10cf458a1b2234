// SPDX-License-Identifier: MIT
#include <algorithm>
#include <mutex>
#include <stdexcept>

#include "solver/boundary/fill.h"
#include "solver/boundary/rotation.h"
#include "solver/boundary/shapes.h"

namespace bake {
namespace {

constexpr Box3 k_everywhere{{-k_infinity, -k_infinity, -k_infinity}, {k_infinity, k_infinity, k_infinity}};

/// The part whose distance comes first in the order `before`, and that distance.
struct Decisive {
  const Shape* part;
  double distance;
};

template <class Before>
Decisive decisive(const std::vector<ShapePtr>& parts, const Point& x, Before before) {
  Decisive best{parts[0].get(), parts[0]->distance(x)};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const double distance = parts[i]->distance(x);
    if (before(distance, best.distance)) best = {parts[i].get(), distance};
  }
  return best;
}

/// Several shapes in one, whose volume takes some tenths of a second and is measured once.
class Combination : public Shape {
 public:
  double volume() const final {
    std::call_once(once_, [this] { volume_ = measured_volume(); });
    return volume_;
  }

 private:
  virtual double measured_volume() const { return sampled_volume(*this); }
  mutable std::once_flag once_;
  mutable double volume_ = 0;
};

class Union final : public Combination {
 public:
  explicit Union(std::vector<ShapePtr> parts) : parts_(std::move(parts)) {}
  double distance(const Point& x) const override { return decisive(parts_, x, std::less{}).distance; }
  Point normal(const Point& x) const override { return decisive(parts_, x, std::less{}).part->normal(x); }
  Box3 bounds() const override {
    Box3 box = parts_[0]->bounds();
    for (const ShapePtr& part : parts_) {
      const Box3 other = part->bounds();
      for (int i = 0; i < 3; ++i) {
        box.low[i] = std::min(box.low[i], other.low[i]);
        box.high[i] = std::max(box.high[i], other.high[i]);
      }
    }
    return box;
  }

 private:
  /// The sum of its parts if none can overlap, as of many grains, for which sampling would take long.
  double measured_volume() const override {
    double sum = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        if (meet(parts_[i]->bounds(), parts_[j]->bounds())) return sampled_volume(*this);
      sum += parts_[i]->volume();
    }
    return sum;
  }
  static bool meet(const Box3& a, const Box3& b) {
    for (int i = 0; i < 3; ++i)
      if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
    return true;
  }

  std::vector<ShapePtr> parts_;
};

class Intersection final : public Combination {
 public:
  explicit Intersection(std::vector<ShapePtr> parts) : parts_(std::move(parts)) {}
  double distance(const Point& x) const override { return decisive(parts_, x, std::greater{}).distance; }
  Point normal(const Point& x) const override { return decisive(parts_, x, std::greater{}).part->normal(x); }
  Box3 bounds() const override {
    Box3 box = k_everywhere;
    for (const ShapePtr& part : parts_) {
      const Box3 other = part->bounds();
      for (int i = 0; i < 3; ++i) {
        box.low[i] = std::max(box.low[i], other.low[i]);
        box.high[i] = std::max(box.low[i], std::min(box.high[i], other.high[i]));  // empty if the parts do not overlap
      }
    }
    return box;
  }

 private:
  std::vector<ShapePtr> parts_;
};

class Complement final : public Shape {
 public:
  explicit Complement(ShapePtr shape) : shape_(std::move(shape)) {}
  double distance(const Point& x) const override { return -shape_->distance(x); }
  Point normal(const Point& x) const override { return -shape_->normal(x); }
  Box3 bounds() const override { return k_everywhere; }

 private:
  ShapePtr shape_;
};

class Transformed final : public Shape {
 public:
  Transformed(ShapePtr shape, double scale, const Rotation& rotation, const Vector3& move)
      : shape_(std::move(shape)), scale_(scale), rotation_(rotation), move_(move) {}
  double distance(const Point& x) const override { return scale_ * shape_->distance(to_drawn(x)); }
  Point normal(const Point& x) const override { return rotation_ * shape_->normal(to_drawn(x)); }
  Box3 bounds() const override {
    const Box3 box = turned(rotation_, shape_->bounds());
    return {scale_ * box.low + move_, scale_ * box.high + move_};
  }
  double volume() const override { return scale_ * scale_ * scale_ * shape_->volume(); }

 private:
  Point to_drawn(const Point& x) const { return (1 / scale_) * turn_back(rotation_, x - move_); }

  ShapePtr shape_;
  double scale_;
  Rotation rotation_;
  Vector3 move_;
};

void require_shapes(const std::vector<ShapePtr>& shapes) {
  if (shapes.empty()) throw std::invalid_argument("a combination of shapes needs at least one shape");
  if (std::find(shapes.begin(), shapes.end(), nullptr) != shapes.end())
    throw std::invalid_argument("a combination of shapes holds a null shape");
}

}  // namespace

ShapePtr make_union(std::vector<ShapePtr> parts) {
  require_shapes(parts);
  return std::make_shared<Union>(std::move(parts));
}

ShapePtr make_intersection(std::vector<ShapePtr> parts) {
  require_shapes(parts);
  return std::make_shared<Intersection>(std::move(parts));
}

ShapePtr make_difference(ShapePtr first, std::vector<ShapePtr> cut) {
  require_shapes({first});
  require_shapes(cut);
  std::vector<ShapePtr> parts = {std::move(first)};
  for (ShapePtr& shape : cut) parts.push_back(std::make_shared<Complement>(std::move(shape)));
  return std::make_shared<Intersection>(std::move(parts));
}

ShapePtr make_transformed(ShapePtr shape, double scale, const Vector3& rotate_deg, const Vector3& move_m) {
  require_shapes({shape});
  if (!(scale > 0)) throw std::invalid_argument("the scale of a shape must be above 0");
  return std::make_shared<Transformed>(std::move(shape), scale, matrix(quaternion(k_rad_per_deg * rotate_deg)), move_m);
}

}  // namespace bake
