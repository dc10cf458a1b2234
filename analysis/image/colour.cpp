// SPDX-License-Identifier: MIT
#include "analysis/image/colour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace bake {
namespace {

float decoded(float c) {
  c = std::clamp(c, 0.0f, 1.0f);
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

float encoded(float c) {
  c = std::clamp(c, 0.0f, 1.0f);
  return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}

/// Stops at equal distances from colours written as 0xRRGGBB.
std::vector<ColourStop> evenly(std::initializer_list<std::uint32_t> colours) {
  std::vector<ColourStop> stops;
  const auto last = static_cast<float>(colours.size() - 1);
  for (const std::uint32_t c : colours) {
    const Colour srgb(static_cast<float>(c >> 16 & 255), static_cast<float>(c >> 8 & 255), static_cast<float>(c & 255));
    stops.push_back({static_cast<float>(stops.size()) / last, srgb / 255});
  }
  return stops;
}

}  // namespace

Colour linear_from_srgb(const Colour& srgb) { return srgb.unaryExpr(&decoded); }
Colour srgb_from_linear(const Colour& linear) { return linear.unaryExpr(&encoded); }

float lightness(const Colour& srgb) {
  const float luminance = linear_from_srgb(srgb).dot(Colour(0.2126f, 0.7152f, 0.0722f));
  return luminance <= 216.0f / 24389 ? luminance * 24389 / 27 : 116 * std::cbrt(luminance) - 16;
}

Colour ramp_colour(const std::vector<ColourStop>& ramp, float x) {
  const auto above = std::find_if(ramp.begin(), ramp.end(), [&](const ColourStop& stop) { return stop.at > x; });
  if (above == ramp.begin()) return ramp.front().srgb;
  if (above == ramp.end()) return ramp.back().srgb;
  const ColourStop& below = *(above - 1);
  const float share = (x - below.at) / (above->at - below.at);
  return (1 - share) * below.srgb + share * above->srgb;
}

const std::vector<ColourStop>& stops_of(ColourMap map) {
  static const std::array<std::vector<ColourStop>, 4> k_maps = {
      evenly({0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725}),
      evenly({0x00204d, 0x00306f, 0x2a406c, 0x48526b, 0x5e626e, 0x727374, 0x878479, 0x9e9677, 0xb6a971, 0xd0be67, 0xead357, 0xffea46}),
      evenly({0x000004, 0x210c4a, 0x57106e, 0x8a226a, 0xbc3754, 0xe45a31, 0xf98c0a, 0xf9cb35, 0xfcffa4}),
      evenly({0x001261, 0x033e7d, 0x1e6f9d, 0x71a8c4, 0xc9dde7, 0xede5e1, 0xeacebd, 0xd39774, 0xbe6533, 0x8b2706, 0x590008})};
  return k_maps[static_cast<std::size_t>(map)];
}

Colour map_colour(ColourMap map, float x) { return std::isnan(x) ? Colour::Constant(0.5f) : ramp_colour(stops_of(map), x); }

}  // namespace bake
