// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/fracture/fracture.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "meshing/fracture/census.h"
#include "meshing/fracture/depth.h"
#include "meshing/fracture/positions.h"
#include "meshing/fracture/run_frames.h"
#include "solver/core/errors.h"
#include "solver/core/vector3.h"
#include "solver/io/atomic_file.h"

namespace bake {
namespace {

using nlohmann::json;

struct CarriedField {
  const char* name;
  const char* unit;
  std::size_t components;
};
constexpr CarriedField k_carried[] = {
    {"temperature", "C", 1}, {"peak_temperature", "C", 1}, {"saturation", "1", 1}, {"porosity", "1", 1}, {"velocity", "m/s", 3}};

Topology read_topology(const std::filesystem::path& file) {
  const Mesh mesh = read_mesh(file);
  try {
    return make_topology(to_tet_mesh(mesh));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<int> wanted_frames(const FractureOptions& options, const RunFrames& run) {
  std::vector<int> frames = options.frames;
  if (frames.empty() && options.every > 0)
    for (int f = 0; f < run.count(); f += options.every) frames.push_back(f);
  if (frames.empty()) frames.push_back(run.count() - 1);
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  if (frames.front() < 0 || frames.back() >= run.count())
    throw InputError(
        fmt::format("--frames: found {}, allowed: 0 to {}", frames.front() < 0 ? frames.front() : frames.back(), run.count() - 1));
  return frames;
}

json as_json(const Crack& crack) {
  return {{"area_m2", crack.area_m2},
          {"length_m", crack.length_m},
          {"centre_m", crack.centre_m},
          {"low_m", crack.low_m},
          {"high_m", crack.high_m}};
}
json as_json(const Piece& piece) { return {{"vertices", piece.vertices}, {"volume_m3", piece.volume_m3}, {"closed", piece.closed}}; }

template <class Things>
json list(const Things& things) {
  json result = json::array();
  for (const auto& thing : things) result.push_back(as_json(thing));
  return result;
}

double volume_of(const std::vector<Piece>& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), 0., [](double sum, const Piece& piece) { return sum + piece.volume_m3; });
}

/// One surface as it is written, and its description.
class Surface {
 public:
  Surface(const Topology& topology, const RunFrames& run, int frame, const std::vector<std::int32_t>& broken_at, int passes)
      : surface_(cut(topology, broken_at)),
        shape_(material_shape(topology, surface_, passes)),
        pieces_(pieces(topology, broken_at)),
        points_(node_positions(topology, surface_, shape_, broken_at, frame, run.positions())) {
    report_["frame"] = frame;
    report_["time_s"] = run.time_s(frame);
    report_["broken_edges"] = std::count_if(broken_at.begin(), broken_at.end(), [](std::int32_t at) { return at >= 0; });
    const std::vector<Crack> found = cracks(surface_, shape_.points);
    double area = 0;
    for (const Crack& crack : found) area += crack.area_m2;
    const std::vector<Piece> parts = take_census(surface_, pieces_, points_);
    report_["crack_area_m2"] = area;
    report_["cracks"] = list(found);
    report_["pieces"] = list(parts);
    report_["volume_m3"] = volume_of(parts);
    report_["cut_volume_m3"] = volume_of(take_census(surface_, pieces_, shape_.points));
  }

  const json& report() const { return report_; }

  Mesh mesh(const RunFrames& run, int frame, const std::function<double(const Point&)>& depth) const {
    Mesh mesh;
    mesh.time_s = run.time_s(frame);
    for (const Point& x : points_) mesh.points.insert(mesh.points.end(), x.begin(), x.end());
    for (const Triangle& t : surface_.triangles) mesh.cells.insert(mesh.cells.end(), t.begin(), t.end());
    for (const CarriedField& field : k_carried) {
      const std::vector<float> values = run.column(field.name, field.components);
      if (!values.empty())
        mesh.fields.push_back({field.name, field.unit, field.components, node_values(surface_, shape_, values, field.components)});
    }
    const std::vector<float> piece(pieces_.begin(), pieces_.end());
    mesh.fields.push_back({"piece", "1", 1, node_values(surface_, shape_, piece, 1)});
    std::vector<double> crack(points_.size(), 1), depths(points_.size(), 0);
    for (std::size_t t = 0; t < surface_.skin_triangles; ++t)
      for (const std::int32_t n : surface_.triangles[t]) crack[n] = 0;
    for (std::size_t n = 0; n < depths.size(); ++n)
      if (crack[n] > 0) depths[n] = depth(shape_.points[n]);
    mesh.fields.push_back({"crack", "1", 1, crack});
    mesh.fields.push_back({"depth", "m", 1, depths});
    return mesh;
  }

 private:
  CutSurface surface_;
  MaterialShape shape_;
  std::vector<std::int32_t> pieces_;
  std::vector<Point> points_;
  json report_;
};

/// What the wanted surface of a frame is cut along.
std::vector<std::int32_t> resolved_breaks(const Topology& topology, const Breaking& breaking, double smallest_crack_m2, int passes) {
  if (smallest_crack_m2 == 0) return breaking.broken_at();
  const CutSurface surface = cut(topology, breaking.broken_at());
  const std::vector<Crack> found = cracks(surface, material_shape(topology, surface, passes).points);
  return without_specks(topology, breaking.broken_at(), found, smallest_crack_m2);
}

std::string summary(const json& report) {
  return fmt::format("frame {} ({:.4g} s): {} broken edges, {} cracks of {:.4g} m^2, {} pieces", report["frame"].get<int>(),
                     report["time_s"].get<double>(), report["broken_edges"].get<std::size_t>(), report["cracks"].size(),
                     report["crack_area_m2"].get<double>(), report["pieces"].size());
}

/// Volumes of the frame read last over the first ones; of particles that have left: zero.
std::vector<double> growth(const RunFrames& run, const std::vector<float>& first_volumes) {
  const std::vector<float> volumes = run.column("volume", 1);
  std::vector<double> growth(volumes.size());
  for (std::size_t v = 0; v < growth.size(); ++v) growth[v] = double(volumes[v]) / double(first_volumes[v]);
  return growth;
}

}  // namespace

void write_fracture(const FractureOptions& options, const std::function<void(const std::string&)>& tell,
                    const std::function<void(double)>& progress) {
  const Topology topology = read_topology(options.mesh);
  RunFrames run(options.results, topology.mesh.points, options.first_particle);
  const std::vector<int> frames = wanted_frames(options, run);
  const int reference = run.nearest(options.reference_time_s);
  run.read(reference);
  const BreakingRule rule{options.stretch, options.smallest_gap_m.value_or(k_smallest_gap * run.dx_m()), options.void_ratio};
  const std::vector<float> first_volumes = rule.void_ratio > 0 ? run.column("volume", 1) : std::vector<float>{};
  if (rule.void_ratio > 0 && first_volumes.empty())
    throw InputError(fmt::format("{}: found no column 'volume' in its frames, needed for --void-ratio", options.results.string()));
  Breaking breaking(topology, run.positions(), rule);
  const double smallest_crack_m2 = options.smallest_crack * run.dx_m() * run.dx_m();
  const auto depth = depth_in(topology);
  std::filesystem::create_directories(options.out);

  json report{{"mesh", options.mesh.string()},
              {"results", options.results.string()},
              {"reference_frame", reference},
              {"reference_time_s", run.time_s(reference)},
              {"stretch", rule.stretch},
              {"smallest_gap_m", rule.smallest_gap_m},
              {"void_ratio", rule.void_ratio},
              {"smallest_crack_m2", smallest_crack_m2},
              {"mesh_volume_m3", volume(topology.mesh)},
              {"frames", json::array()}};
  for (int frame = 0; frame <= frames.back(); ++frame) {
    progress(frame / (frames.back() + 1.0));
    run.read(frame);
    breaking.advance(frame, run.positions(), rule.void_ratio > 0 ? growth(run, first_volumes) : std::vector<double>{});
    if (!std::binary_search(frames.begin(), frames.end(), frame)) continue;
    const auto broken_at = resolved_breaks(topology, breaking, smallest_crack_m2, options.smoothing_passes);
    const Surface surface(topology, run, frame, broken_at, options.smoothing_passes);
    write_mesh(options.out / frame_name(frame), surface.mesh(run, frame, depth));
    report["frames"].push_back(surface.report());
    tell(summary(surface.report()));
  }
  write_text_atomically(options.out / "fracture.json", report.dump(1) + "\n");
}

}  // namespace bake
