// SPDX-License-Identifier: MIT
#include "analysis/charts/labels.h"

#include "analysis/charts/text.h"

namespace bake::charts {
namespace {

struct Spot {
  double x, y;
};

struct Box {
  double left, right, bottom, top;
};

double common_area(const Box& a, const Box& b) {
  return std::max(0., std::min(a.right, b.right) - std::max(a.left, b.left)) *
         std::max(0., std::min(a.top, b.top) - std::max(a.bottom, b.bottom));
}

double area(const Box& box) { return (box.right - box.left) * (box.top - box.bottom); }

Box around(const Spot& p, double half) { return {p.x - half, p.x + half, p.y - half, p.y + half}; }

/// From 0 at the low end of an axis to `length` at its high end.
double along(const Axis& axis, const Extent& extent, double length, double value) {
  if (axis.scale == Scale::logarithmic)
    return length * (std::log(value) - std::log(extent.low)) / (std::log(extent.high) - std::log(extent.low));
  return length * (value - extent.low) / (extent.high - extent.low);
}

class Sheet {
 public:
  Sheet(const Panel& panel, const Extent& across, const Extent& up, double width, double height, double letters)
      : panel_(panel), across_(across), up_(up), width_(width), height_(height), letters_(letters) {
    for (const Series& series : panel.series) cover(series);
    for (const Mark& mark : panel.marks)
      if (mark.side != Side::free) covered_.push_back(text_box(mark, mark.side));
  }

  Side choose(const Mark& mark) {
    constexpr double k_nothing = 1e-6;  // rounding errors must not decide
    Side best = Side::right;
    double least = std::numeric_limits<double>::infinity();
    for (const Side side : {Side::right, Side::left, Side::above, Side::below}) {
      const Box box = text_box(mark, side);
      double hidden = area(box) - common_area(box, {0, width_, 0, height_});
      for (const Box& other : covered_) hidden += common_area(box, other);
      if (hidden < least - k_nothing * letters_ * letters_) least = hidden, best = side;
    }
    covered_.push_back(text_box(mark, best));
    return best;
  }

 private:
  Spot spot(double x, double y) const { return {along(panel_.x, across_, width_, x), along(panel_.y, up_, height_, y)}; }

  /// Covers the points of a series, and small boxes all along its lines.
  void cover(const Series& series) {
    const bool lines = series.kind == Kind::line || series.kind == Kind::line_and_points || series.kind == Kind::error_bars;
    const double point = 0.3 * letters_, dot = 0.1 * letters_;
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      const Spot here = spot(series.x[i], series.y[i]);
      if (std::isnan(here.x) || std::isnan(here.y)) continue;
      if (series.kind != Kind::line) covered_.push_back(around(here, point));
      if (!lines || i == 0) continue;
      const Spot before = spot(series.x[i - 1], series.y[i - 1]);
      if (std::isnan(before.x) || std::isnan(before.y)) continue;
      const int dots = 1 + static_cast<int>(std::hypot(here.x - before.x, here.y - before.y) / (4 * dot));
      for (int k = 0; k <= dots; ++k) {
        const double share = static_cast<double>(k) / dots;
        covered_.push_back(around({before.x + share * (here.x - before.x), before.y + share * (here.y - before.y)}, dot));
      }
    }
  }

  Box text_box(const Mark& mark, Side side) const {
    constexpr double k_letter_width = 0.55, k_line_height = 1.1;  // over the letters' height
    const Spot at = spot(mark.x, mark.y);
    const double width = k_letter_width * letters_ * static_cast<double>(plain_text(mark.text).size()), half = 0.5 * width;
    const double height = k_line_height * letters_, aside = 0.5 * letters_, off = 0.4 * letters_;
    switch (side) {
      case Side::left:
        return {at.x - aside - width, at.x - aside, at.y - 0.5 * height, at.y + 0.5 * height};
      case Side::above:
        return {at.x - half, at.x + half, at.y + off, at.y + off + height};
      case Side::below:
        return {at.x - half, at.x + half, at.y - off - height, at.y - off};
      case Side::centre:
        return {at.x - half, at.x + half, at.y - 0.5 * height, at.y + 0.5 * height};
      default:
        return {at.x + aside, at.x + aside + width, at.y - 0.5 * height, at.y + 0.5 * height};
    }
  }

  const Panel& panel_;
  Extent across_, up_;
  double width_, height_, letters_;
  std::vector<Box> covered_;
};

}  // namespace

std::vector<Side> label_sides(const Panel& panel, const Extent& across, const Extent& up, double width, double height, double letters) {
  Sheet sheet(panel, across, up, width, height, letters);
  std::vector<Side> sides;
  for (const Mark& mark : panel.marks) sides.push_back(mark.side == Side::free ? sheet.choose(mark) : mark.side);
  return sides;
}

}  // namespace bake::charts
