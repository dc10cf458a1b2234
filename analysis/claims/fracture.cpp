// SPDX-License-Identifier: MIT
#include "analysis/claims/fracture.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "analysis/claims/finite.h"
#include "solver/io/json_fault.h"

namespace bake {
namespace {

double number(const nlohmann::json& json) { return json.is_null() ? std::nan("") : json.get<double>(); }

Fracture::Crack crack_of(const nlohmann::json& json) {
  const nlohmann::json& centre = json.at("centre_m");
  return {number(json.at("area_m2")), number(json.at("length_m")), {number(centre.at(0)), number(centre.at(1)), number(centre.at(2))}};
}

Fracture::Piece piece_of(const nlohmann::json& json) { return {number(json.at("volume_m3")), json.at("closed")}; }

Fracture::Frame frame_of(const nlohmann::json& json) {
  Fracture::Frame frame{
      number(json.at("time_s")), number(json.at("crack_area_m2")), number(json.at("volume_m3")), number(json.at("cut_volume_m3")), {}, {}};
  for (const auto& crack : json.at("cracks")) frame.cracks.push_back(crack_of(crack));
  for (const auto& piece : json.at("pieces")) frame.pieces.push_back(piece_of(piece));
  return frame;
}

/// Throws NoNumber if a number of the frame is not finite, or if it is empty.
void expect_whole(const Fracture& fracture, const Fracture::Frame& frame) {
  const auto expect = [&](double value, const char* what) {
    expect_finite(value, [&] { return fmt::format("{}: {} at {} s", fracture.file.string(), what, frame.time_s); });
  };
  expect(frame.crack_area_m2, "crack_area_m2");
  expect(frame.volume_m3, "volume_m3");
  expect(frame.cut_volume_m3, "cut_volume_m3");
  expect(fracture.mesh_volume_m3, "mesh_volume_m3");
  for (const Fracture::Crack& crack : frame.cracks) {
    expect(crack.area_m2, "a crack's area_m2");
    expect(crack.length_m, "a crack's length_m");
    for (const double x : crack.centre_m) expect(x, "a crack's centre_m");
  }
  for (const Fracture::Piece& piece : frame.pieces) expect(piece.volume_m3, "a piece's volume_m3");
  if (frame.pieces.empty() || frame.volume_m3 <= 0 || fracture.mesh_volume_m3 <= 0)
    throw NoNumber(fmt::format("{}: found {} pieces of {} m^3 at {} s in a mesh of {} m^3, allowed: a body", fracture.file.string(),
                               frame.pieces.size(), frame.volume_m3, frame.time_s, fracture.mesh_volume_m3));
}

}  // namespace

const Fracture::Frame& Fracture::at(std::optional<double> time_s) const {
  if (frames.empty()) throw NoNumber(fmt::format("{}: found no frame", file.string()));
  std::vector<double> times;
  for (const Frame& frame : frames) {
    expect_finite(frame.time_s, [&] { return fmt::format("{}: time_s", file.string()); });
    times.push_back(frame.time_s);
  }
  const Frame& frame = frames[nearest_time(times, time_s.value_or(times.back()), file.string())];
  expect_whole(*this, frame);
  return frame;
}

Fracture read_fracture(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    throw InputError(
        fmt::format("{}: cannot open: there is no fracture surface here, allowed: a folder of bake-mesh fracture", file.string()));
  try {
    const nlohmann::json json = nlohmann::json::parse(in);
    Fracture fracture{file, number(json.at("mesh_volume_m3")), {}};
    for (const auto& frame : json.at("frames")) fracture.frames.push_back(frame_of(frame));
    if (fracture.frames.empty()) throw InputError(fmt::format("{}: found no frame", file.string()));
    return fracture;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not a description of fracture surfaces: {}", file.string(), json_fault(error)));
  }
}

}  // namespace bake
