// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/run_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/claims/results.h"
#include "solver/core/errors.h"
#include "solver/core/vector3.h"
#include "solver/scene/settings.h"

namespace bake {
namespace {

double node_distance(const nlohmann::json& scene) {
  constexpr auto names = choice_names(Quality{});
  const auto quality = std::find(names.begin(), names.end(), scene.at("quality").get<std::string>()) - names.begin();
  return scene.at("grid").at("dx_m").get<double>() * coarsening(static_cast<Quality>(quality));
}

}  // namespace

RunFrames::RunFrames(const std::filesystem::path& results, const std::vector<Point>& vertices, std::int64_t first_particle)
    : folder_(results),
      first_particle_(first_particle),
      dx_m_(node_distance(Results(results).description().at("scene"))),
      positions_(vertices) {
  while (std::filesystem::exists(file(count()))) times_s_.push_back(FrameReader(file(count())).time_s());
  if (times_s_.empty()) throw InputError(fmt::format("{}: there are no frames", (folder_ / "frames").string()));
  read(0);
  check_first_frame(vertices);
}

void RunFrames::check_first_frame(const std::vector<Point>& vertices) const {
  const auto missing = std::find(rows_.begin(), rows_.end(), -1);
  if (missing != rows_.end())
    throw InputError(fmt::format("{}: particle {} is not there, allowed: a run whose particles {} to {} are the vertices of the mesh",
                                 file(0).string(), missing - rows_.begin() + first_particle_, first_particle_,
                                 first_particle_ + static_cast<std::int64_t>(vertices.size()) - 1));
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const double away = length(positions_[v] - vertices[v]);
    if (away > 0.01 * dx_m_)
      throw InputError(fmt::format("{}: particle {} is {:.3g} m from vertex {}, allowed: a run that started from this mesh",
                                   file(0).string(), first_particle_ + static_cast<std::int64_t>(v), away, v));
  }
}

int RunFrames::nearest(double time_s) const {
  const auto nearer = [&](double a, double b) { return std::abs(a - time_s) < std::abs(b - time_s); };
  return static_cast<int>(std::min_element(times_s_.begin(), times_s_.end(), nearer) - times_s_.begin());
}

void RunFrames::read(int frame) {
  current_.clear();
  current_.emplace_back(file(frame));
  const std::vector<double> flat = current_.front().positions();
  rows_ = current_.front().rows_by_identity(first_particle_, positions_.size());
  for (std::size_t v = 0; v < positions_.size(); ++v)
    for (int k = 0; rows_[v] >= 0 && k < 3; ++k) positions_[v][k] = flat[3 * rows_[v] + k];
}

std::vector<float> RunFrames::column(const std::string& name, std::size_t components) const {
  const FrameReader& frame = current_.front();
  if (!frame.has(name)) return {};
  const std::vector<float> stored = frame.column(name, components);
  std::vector<float> values(components * positions_.size(), 0);
  for (std::size_t v = 0; v < positions_.size(); ++v)
    for (std::size_t c = 0; rows_[v] >= 0 && c < components; ++c) values[components * v + c] = stored[components * rows_[v] + c];
  return values;
}

}  // namespace bake
