// SPDX-License-Identifier: MIT
#include "experiments/report/body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "analysis/surface/point_grid.h"
#include "experiments/report/sections.h"
#include "solver/core/errors.h"
#include "solver/io/frames.h"

namespace bake::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::array k_fields{"temperature", "saturation", "porosity", "browning"};
constexpr double k_nodes = 10000;  ///< of the grid of fields inside a body

struct Frame {
  std::string name;  ///< "0042.hdf"
  Mesh surface;
  std::vector<std::int64_t> ids;
  std::vector<float> positions, volumes;
  std::vector<std::vector<float>> fields;  ///< of the particles, as Scale::fields
};

struct Body {
  fs::path folder;
  std::vector<Frame> frames;
};

using Steps = std::vector<std::pair<std::string, FieldSteps>>;

/// The names of the frames in a folder, in order.
std::vector<std::string> frames_in(const fs::path& folder) {
  std::vector<std::string> names;
  const std::string prefix = "surface_";
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (const std::string name = entry.path().filename(); name.starts_with(prefix) && name.ends_with(".hdf"))
      names.push_back(name.substr(prefix.size()));
  if (names.empty()) throw InputError(fmt::format("{}: found no surface, allowed: what bake figure makes", folder.string()));
  std::sort(names.begin(), names.end());
  return names;
}

/// Whether a field differs anywhere in the bodies by what can be read of a legend; an apple has pores without gas.
bool varies(const std::vector<fs::path>& folders, const std::string& field) {
  constexpr float k_least = 1e-3f;  // of a share; of temperatures far less than a legend shows
  float low = INFINITY, high = -INFINITY;
  for (const fs::path& folder : folders)
    for (const std::string& name : frames_in(folder))
      for (const float value : FrameReader(folder / ("particles_" + name)).column(field)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  return high - low > k_least;
}

/// Which fields all bodies have, in the order of the page: one model may have no water, or no gas. At least one, if there is any.
std::vector<std::string> fields_of(const std::vector<fs::path>& folders) {
  std::vector<std::string> names(k_fields.begin(), k_fields.end());
  for (const fs::path& folder : folders) {
    const FrameReader reader(folder / ("particles_" + frames_in(folder).front()));
    std::erase_if(names, [&](const std::string& name) { return !reader.has(name); });
  }
  std::vector<std::string> differing;
  std::copy_if(names.begin(), names.end(), std::back_inserter(differing), [&](const std::string& name) { return varies(folders, name); });
  return differing.empty() ? names : differing;
}

Body read_body(const fs::path& folder, const std::vector<std::string>& fields) {
  Body body{folder, {}};
  for (const std::string& name : frames_in(folder)) {
    const FrameReader particles(folder / ("particles_" + name));
    const std::vector<double> x = particles.positions();
    Frame frame{name, read_mesh(folder / ("surface_" + name)), particles.identities(), {x.begin(), x.end()}, particles.column("volume"),
                {}};
    for (const std::string& field : fields) frame.fields.push_back(particles.column(field));
    if (frame.ids.empty()) throw InputError(fmt::format("{}: found no particle in {}", folder.string(), name));
    body.frames.push_back(std::move(frame));
  }
  return body;
}

template <class Visit>
void for_each_frame(const std::vector<Body>& bodies, Visit visit) {
  for (const Body& body : bodies)
    for (const Frame& frame : body.frames) visit(frame);
}

/// The box around all surfaces and particles at all times.
struct Box {
  std::array<double, 3> low, high;
  explicit Box(const std::vector<Body>& bodies) {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    const auto include = [&](const auto& points) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], static_cast<double>(points[i]));
        high[i % 3] = std::max(high[i % 3], static_cast<double>(points[i]));
      }
    };
    for_each_frame(bodies, [&](const Frame& frame) { include(frame.surface.points), include(frame.positions); });
  }
  Cube cube() const { return {low, std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]})}; }
};

/// The range of each field over all bodies and times. A share begins at 0, and browning is seen against all that it can be.
Steps steps_of(const std::vector<Body>& bodies, const std::vector<std::string>& fields) {
  Steps steps;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    FieldSteps range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for_each_frame(bodies, [&](const Frame& frame) {
      for (const float value : frame.fields[f]) range = {std::min<double>(range.low, value), std::max<double>(range.high, value)};
    });
    if (fields[f] != "temperature") range.low = 0;
    if (fields[f] == "browning") range.high = 1;
    if (!(range.high > range.low)) range.high = range.low + 1;
    steps.emplace_back(fields[f], range);
  }
  return steps;
}

/// Typical distance of neighbours [m].
double spacing_of(const Frame& frame) {
  std::vector<float> volumes = frame.volumes;
  const auto middle = volumes.begin() + static_cast<std::ptrdiff_t>(volumes.size() / 2);
  std::nth_element(volumes.begin(), middle, volumes.end());
  return std::cbrt(static_cast<double>(*middle));
}

/// Nodes of the grid on which a cut shows the fields, from the low corner of the box; x runs fastest.
struct Nodes {
  std::array<double, 3> low;
  double spacing;
  std::array<std::size_t, 3> shape;
  explicit Nodes(const Box& box) : low(box.low) {
    double volume = 1;
    for (std::size_t a = 0; a < 3; ++a) volume *= box.high[a] - box.low[a];
    spacing = std::cbrt(volume / k_nodes);
    for (std::size_t a = 0; a < 3; ++a) shape[a] = static_cast<std::size_t>(std::ceil((box.high[a] - box.low[a]) / spacing)) + 1;
  }
};

/// Codes of the fields at the nodes: means of the particles near, the nearest of most weight [Shepard 1968]; 0 where none is.
std::vector<std::vector<std::uint8_t>> fields_at(const Nodes& nodes, const Frame& frame, const Steps& steps) {
  const auto h = static_cast<float>(std::max(nodes.spacing, spacing_of(frame)));
  const float reach = 1.5f * h, far = 3 * h;  // beyond the surface by some nodes, so that the interpolated rim is right
  const PointGrid near(frame.positions, reach);
  std::vector<std::vector<std::uint8_t>> codes(steps.size());
  std::vector<double> sums(steps.size());
  for (std::size_t n = 0; n < nodes.shape[0] * nodes.shape[1] * nodes.shape[2]; ++n) {
    const std::array<std::size_t, 3> at{n % nodes.shape[0], n / nodes.shape[0] % nodes.shape[1], n / nodes.shape[0] / nodes.shape[1]};
    Eigen::Vector3f place;
    for (int a = 0; a < 3; ++a)
      place[a] =
          static_cast<float>(nodes.low[static_cast<std::size_t>(a)] + nodes.spacing * static_cast<double>(at[static_cast<std::size_t>(a)]));
    double weights = 0;
    std::fill(sums.begin(), sums.end(), 0.0);
    const auto add = [&](std::size_t i, float distance2) {
      const double weight = std::pow(std::sqrt(distance2) + h / 8, -3);
      weights += weight;
      for (std::size_t f = 0; f < sums.size(); ++f) sums[f] += weight * static_cast<double>(frame.fields[f][i]);
    };
    near.within(place, reach, add);
    if (weights == 0)
      if (const std::int64_t i = near.nearest(place, far); i >= 0) add(static_cast<std::size_t>(i), 0);
    for (std::size_t f = 0; f < sums.size(); ++f)
      codes[f].push_back(weights > 0 ? steps[f].second.code(sums[f] / weights) : std::uint8_t{0});
  }
  return codes;
}

/// The identities that occur in a body, rising: a particle's place is its rank among them.
std::vector<std::int64_t> identities_in(const Body& body) {
  std::vector<std::int64_t> ids;
  for (const Frame& frame : body.frames) ids.insert(ids.end(), frame.ids.begin(), frame.ids.end());
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

ParticleCodes codes_of(const Frame& frame, const std::vector<std::int64_t>& ids, const Cube& cube, const Steps& steps) {
  ParticleCodes codes;
  codes.positions.assign(ids.size(), {Cube::k_absent, Cube::k_absent, Cube::k_absent});
  codes.fields.assign(steps.size(), std::vector<std::uint8_t>(ids.size()));
  for (std::size_t row = 0; row < frame.ids.size(); ++row) {
    const auto place = static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), frame.ids[row]) - ids.begin());
    for (std::size_t a = 0; a < 3; ++a) codes.positions[place][a] = cube.code(static_cast<double>(frame.positions[3 * row + a]), a);
    for (std::size_t f = 0; f < steps.size(); ++f) codes.fields[f][place] = steps[f].second.code(static_cast<double>(frame.fields[f][row]));
  }
  return codes;
}

/// What all bodies of an object share.
struct Scale {
  Box box;
  Cube cube;
  Steps steps;
  Nodes nodes;
  Scale(const std::vector<Body>& bodies, const std::vector<std::string>& fields)
      : box(bodies), cube(box.cube()), steps(steps_of(bodies, fields)), nodes(box) {}
};

PackedBody packed(const Body& body, const Scale& scale, bool particles) {
  PackedBody made;
  const auto put = [&made](const Bytes& bytes) {
    const Bytes piece = deflated(bytes);
    const std::size_t at = made.bytes.size();
    made.bytes.insert(made.bytes.end(), piece.begin(), piece.end());
    return json{at, piece.size()};
  };
  json fields = json::array();
  for (const auto& [name, range] : scale.steps) fields.push_back({{"name", name}, {"low", range.low}, {"high", range.high}});
  const std::vector<std::int64_t> ids = identities_in(body);
  made.head = {{"low", scale.box.low},
               {"high", scale.box.high},
               {"span", scale.cube.span},
               {"steps", Cube::k_steps},
               {"fields", fields},
               {"look", *read_json(body.folder / "look.json")},
               {"grid", {{"spacing", scale.nodes.spacing}, {"shape", scale.nodes.shape}}},
               {"particles", particles ? ids.size() : 0},
               {"radius", 0.55 * spacing_of(body.frames.back())},
               {"frames", json::array()}};
  ParticleCodes before;
  for (const Frame& frame : body.frames) {
    json one{{"time", frame.surface.time_s},
             {"vertices", frame.surface.vertex_count()},
             {"triangles", frame.surface.cell_count()},
             {"mesh", put(packed_mesh(frame.surface, scale.cube, scale.steps, (body.folder / ("surface_" + frame.name)).string()))},
             {"fields", put(packed_fields(fields_at(scale.nodes, frame, scale.steps)))}};
    if (particles) {
      const bool is_first = before.positions.empty();
      ParticleCodes now = codes_of(frame, ids, scale.cube, scale.steps);
      one["particles"] = put(packed_particles(now, is_first ? nullptr : &before));
      before = std::move(now);
    }
    made.head["frames"].push_back(std::move(one));
  }
  return made;
}

}  // namespace

std::vector<PackedBody> packed_bodies(const std::vector<fs::path>& folders, bool particles) {
  std::vector<Body> bodies;
  bodies.reserve(folders.size());
  for (const fs::path& folder : folders)
    if (!fs::exists(folder / "look.json"))
      throw InputError(fmt::format("{}: missing; make the figure again", (folder / "look.json").string()));
  const std::vector<std::string> fields = fields_of(folders);
  for (const fs::path& folder : folders) bodies.push_back(read_body(folder, fields));
  const Scale scale(bodies, fields);
  std::vector<PackedBody> made;
  made.reserve(bodies.size());
  for (const Body& body : bodies) made.push_back(packed(body, scale, particles));
  return made;
}

}  // namespace bake::report
