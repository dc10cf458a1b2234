// SPDX-License-Identifier: MIT
#include "analysis/browning/browning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/core/errors.h"
#include "solver/io/frames.h"
#include "solver/io/json_fault.h"

namespace bake {
namespace {

/// Times of the frames that a run has written so far.
std::vector<double> frame_times(const std::filesystem::path& results) {
  const std::filesystem::path file = results / "frames.hdf.series";
  std::ifstream in(file);
  if (!in) throw InputError(fmt::format("{}: no run is here, allowed: a folder that bake run has written", results.string()));
  std::vector<double> times;
  try {
    const nlohmann::json series = nlohmann::json::parse(in);
    for (const auto& entry : series.at("files")) times.push_back(entry.at("time").get<double>());
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not a list of frames: {}", file.string(), json_fault(error)));
  }
  if (times.empty()) throw InputError(fmt::format("{}: the run has written no frame yet", results.string()));
  return times;
}

}  // namespace

double browning_rate(const BrowningLaw& law, double temperature_C, double dryness) {
  const double dry = law.reference_dryness > 0 ? std::clamp(dryness / law.reference_dryness, 0.0, 1.0) : 1;
  return dry * std::pow(10, (temperature_C - law.reference_temperature_C) / law.tenfold_K) / law.reference_time_s;
}

double browning_degree(double integral) { return -std::expm1(-integral); }

int frame_at(const std::filesystem::path& results, double time_s) {
  const std::vector<double> times = frame_times(results);
  const auto nearest =
      std::min_element(times.begin(), times.end(), [&](double a, double b) { return std::abs(a - time_s) < std::abs(b - time_s); });
  if (std::abs(*nearest - time_s) > 1e-6 * std::max(1.0, std::abs(time_s)))
    throw InputError(fmt::format("{}: found no frame at {:g} s (frames from {:g} to {:g} s): another run, or one that is not finished",
                                 results.string(), time_s, times.front(), times.back()));
  return static_cast<int>(nearest - times.begin());
}

BrowningHistory::BrowningHistory(std::filesystem::path results, const BrowningLaw& law)
    : results_(std::move(results)), law_(law), last_frame_(static_cast<int>(frame_times(results_).size()) - 1) {}

void BrowningHistory::advance_to(int frame) {
  if (frame > last_frame_)
    throw InputError(fmt::format("{}: asked for frame {}, but the run has come to frame {} only: finish it first (bake run --resume)",
                                 results_.string(), frame, last_frame_));
  if (frame < taken_) throw std::invalid_argument("a history of browning cannot go back");
  if (taken_ < 0) take(0);
  const int first = taken_, stride = (frame - first) / k_most_samples + 1;
  for (int next = first + stride; next < frame; next += stride) take(next);
  if (frame > taken_) take(frame);
}

void BrowningHistory::take(int frame) {
  const FrameReader reader(results_ / "frames" / frame_name(frame));
  const std::vector<std::int64_t> ids = reader.identities();
  if (!reader.has("temperature"))
    throw InputError(fmt::format("{}: a run without heat does not brown: set paint = \"constant\" or \"field\" in the view's [[object]]",
                                 results_.string()));
  const std::vector<float> temperatures = reader.column("temperature");
  const std::vector<double> positions = reader.positions();
  const std::vector<float> water = reader.has("water_mass") ? reader.column("water_mass") : std::vector<float>();
  const double passed_s = taken_ < 0 ? 0 : reader.time_s() - time_s_;
  for (std::size_t row = 0; row < ids.size(); ++row) {
    constexpr std::int64_t k_most_ids = std::int64_t{1} << 32;
    if (ids[row] < 0 || ids[row] >= k_most_ids) throw InputError(fmt::format("{}: found particle id {}", results_.string(), ids[row]));
    const auto id = static_cast<std::size_t>(ids[row]);
    if (id >= particles_.size()) particles_.resize(std::max(id + 1, 2 * particles_.size()));
    Particle& particle = particles_[id];
    const bool is_new = !particle.seen;
    if (is_new) {
      particle.seen = true;
      particle.first_water_kg = water.empty() ? 0 : water[row];
      std::copy_n(&positions[3 * row], 3, particle.first_position.begin());
    }
    const double dryness = particle.first_water_kg > 0 ? 1 - water[row] / particle.first_water_kg : 1;
    const double rate = browning_rate(law_, temperatures[row], dryness);
    if (!is_new) particle.integral += passed_s * (particle.rate + rate) / 2;
    particle.rate = rate;
  }
  taken_ = frame;
  time_s_ = reader.time_s();
}

std::vector<double> BrowningHistory::degrees(std::span<const std::int64_t> ids) const {
  std::vector<double> degrees;
  for (const std::int64_t id : ids)
    degrees.push_back(id >= 0 && id < static_cast<std::int64_t>(particles_.size())
                          ? browning_degree(particles_[static_cast<std::size_t>(id)].integral)
                          : 0);
  return degrees;
}

std::vector<double> BrowningHistory::first_positions(std::span<const std::int64_t> ids) const {
  std::vector<double> positions;
  for (const std::int64_t id : ids) {
    const bool known = id >= 0 && id < static_cast<std::int64_t>(particles_.size());
    const std::array<float, 3> p = known ? particles_[static_cast<std::size_t>(id)].first_position : std::array<float, 3>{0, 0, 0};
    positions.insert(positions.end(), p.begin(), p.end());
  }
  return positions;
}

}  // namespace bake
