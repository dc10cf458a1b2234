// SPDX-License-Identifier: MIT
// Colours: sRGB as screens and view files have it, linear light for the path tracer, and maps from numbers to colours.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace bake {

/// Red, green, blue. In view files and pictures sRGB from 0 to 1, inside the path tracer linear radiance or albedo.
using Colour = Eigen::Vector3f;

/// The transfer function of IEC 61966-2-1, channel by channel, and its inverse; both clamp to 0..1.
Colour linear_from_srgb(const Colour& srgb);
Colour srgb_from_linear(const Colour& linear);

/// CIE 1976 lightness L* of an sRGB colour, from 0 (black) to 100 (white).
float lightness(const Colour& srgb);

/// A colour at a position of a ramp.
struct ColourStop {
  float at;
  Colour srgb;
};
/// The ramp at `x`, linear in sRGB between its stops and constant beyond them. `ramp` has at least one stop, in rising order.
Colour ramp_colour(const std::vector<ColourStop>& ramp, float x);

/// Perceptual maps for fields: viridis, cividis and inferno get steadily lighter; vik is darkest at its ends, lightest in its middle.
/// All are made for readers with colour-vision deficiency, too.
/// Source of the stops: viridis and inferno by van der Walt and Smith (CC0), cividis by Nunez, Anderton and Renslow (2018,
/// doi:10.1371/journal.pone.0199239), vik by Crameri (2018, doi:10.5281/zenodo.1243862).
enum class ColourMap { viridis, cividis, inferno, vik };
constexpr auto choice_names(ColourMap) { return std::array{"viridis", "cividis", "inferno", "vik"}; }

/// The stops of a map, from 0 to 1.
const std::vector<ColourStop>& stops_of(ColourMap map);

/// sRGB colour of `x` from 0 to 1; beyond, that of the nearer end. Grey for what is not a number.
Colour map_colour(ColourMap map, float x);

}  // namespace bake
