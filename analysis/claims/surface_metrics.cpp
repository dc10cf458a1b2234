// SPDX-License-Identifier: MIT
// Metrics of fracture surfaces: cracks and pieces.
#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/claims/finite.h"
#include "analysis/claims/metric.h"

namespace bake {
namespace {

constexpr Range k_at_least_one{1, k_infinity, false, true, "a number of at least 1"},
    k_half_at_most{0, 0.5, false, false, "a number from 0 to 0.5"};

double as_number(std::size_t count) { return static_cast<double>(count); }

double crack_length(const Fracture& fracture, const MetricPlace& at) {
  double sum = 0;
  for (const Fracture::Crack& crack : fracture.at(at.time_s).cracks) sum += crack.length_m;
  return sum;
}

double crack_area(const Fracture& fracture, const MetricPlace& at) {
  double within = 0;
  for (const Fracture::Crack& crack : fracture.at(at.time_s).cracks)
    if (is_in_box(crack.centre_m, at)) within += crack.area_m2;
  return within;
}

/// No number where there is no crack.
double crack_share(const Fracture& fracture, const MetricPlace& at) {
  const double all = fracture.at(at.time_s).crack_area_m2;
  return all > 0 ? crack_area(fracture, at) / all : std::nan("");
}

double open_pieces(const Fracture& fracture, const MetricPlace& at) {
  const auto& pieces = fracture.at(at.time_s).pieces;
  return as_number(
      static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(), [](const Fracture::Piece& p) { return !p.closed; })));
}

double pieces_volume(const Fracture& fracture, const MetricPlace& at) {
  const Fracture::Frame &now = fracture.at(at.time_s), &first = fracture.at(fracture.frames.front().time_s);
  if (&now == &first)
    throw NoNumber(
        fmt::format("{}: found the first of the surface's times, {} s, allowed: a later one", fracture.file.string(), now.time_s));
  return now.volume_m3 / first.volume_m3;
}

double cut_volume(const Fracture& fracture, const MetricPlace& at) {
  return fracture.at(at.time_s).cut_volume_m3 / fracture.mesh_volume_m3;
}

/// The shares of the two largest pieces in the volume of all pieces, the larger one first.
std::array<double, 2> largest_shares(const Fracture& fracture, const MetricPlace& at) {
  const Fracture::Frame& frame = fracture.at(at.time_s);
  std::vector<double> volumes{0, 0};
  for (const Fracture::Piece& piece : frame.pieces) volumes.push_back(piece.volume_m3);
  std::sort(volumes.rbegin(), volumes.rend());
  return {volumes[0] / frame.volume_m3, volumes[1] / frame.volume_m3};
}

double second_piece(const Fracture& fracture, const MetricPlace& at) { return largest_shares(fracture, at)[1]; }

double two_pieces(const Fracture& fracture, const MetricPlace& at) {
  const auto [first, second] = largest_shares(fracture, at);
  return first + second;
}

}  // namespace

std::vector<Metric> surface_metrics() {
  using F = const Fracture&;
  using P = const MetricPlace&;
  return {
      {"cracks", "1", non_negative, "number of cracks", [](F f, P at) { return as_number(f.at(at.time_s).cracks.size()); }, needs(),
       knows("time_s")},
      {"crack_area", "m^2", non_negative,
       "area of the cracks whose centres are in the box of the reference mesh; of all if there is no box", crack_area, needs(),
       knows("low_m", "high_m", "time_s")},
      {"crack_length", "m", non_negative, "length of all cracks", crack_length, needs(), knows("time_s")},
      {"crack_share", "1", fraction, "share of the cracks' area in the box of the reference mesh", crack_share, needs("low_m", "high_m"),
       knows("time_s")},
      {"pieces", "1", k_at_least_one, "number of pieces", [](F f, P at) { return as_number(f.at(at.time_s).pieces.size()); }, needs(),
       knows("time_s")},
      {"open_pieces", "1", non_negative, "number of pieces whose surface is not closed", open_pieces, needs(), knows("time_s")},
      {"pieces_volume", "1", non_negative, "volume of all pieces over that at the first of the surface's times", pieces_volume, needs(),
       knows("time_s")},
      {"cut_volume", "1", non_negative, "volume of all pieces in the reference mesh over that of the mesh", cut_volume, needs(),
       knows("time_s")},
      {"second_piece", "1", k_half_at_most, "volume of the second largest piece over that of all", second_piece, needs(), knows("time_s")},
      {"two_pieces", "1", fraction, "volume of the two largest pieces over that of all", two_pieces, needs(), knows("time_s")},
  };
}

}  // namespace bake
