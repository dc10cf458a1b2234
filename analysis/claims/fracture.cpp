// SPDX-License-Identifier: MIT
#include "analysis/claims/fracture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "solver/core/errors.h"

namespace bake {
namespace {

Fracture::Crack crack_of(const nlohmann::json& json) { return {json.at("area_m2"), json.at("length_m"), json.at("centre_m")}; }

Fracture::Piece piece_of(const nlohmann::json& json) { return {json.at("volume_m3"), json.at("closed")}; }

Fracture::Frame frame_of(const nlohmann::json& json) {
  Fracture::Frame frame{json.at("time_s"), json.at("crack_area_m2"), json.at("volume_m3"), json.at("cut_volume_m3"), {}, {}};
  for (const auto& crack : json.at("cracks")) frame.cracks.push_back(crack_of(crack));
  for (const auto& piece : json.at("pieces")) frame.pieces.push_back(piece_of(piece));
  return frame;
}

}  // namespace

const Fracture::Frame& Fracture::at(std::optional<double> time_s) const {
  if (!time_s) return frames.back();
  return *std::min_element(frames.begin(), frames.end(),
                           [&](const Frame& a, const Frame& b) { return std::abs(a.time_s - *time_s) < std::abs(b.time_s - *time_s); });
}

Fracture read_fracture(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    throw InputError(
        fmt::format("{}: cannot open: there is no fracture surface here, allowed: a folder of bake-mesh fracture", file.string()));
  try {
    const nlohmann::json json = nlohmann::json::parse(in);
    Fracture fracture{file, json.at("mesh_volume_m3"), {}};
    for (const auto& frame : json.at("frames")) fracture.frames.push_back(frame_of(frame));
    if (fracture.frames.empty()) throw InputError(fmt::format("{}: found no frame", file.string()));
    return fracture;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not a description of fracture surfaces: {}", file.string(), error.what()));
  }
}

}  // namespace bake
