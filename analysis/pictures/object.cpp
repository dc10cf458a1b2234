// SPDX-License-Identifier: MIT
#include "analysis/pictures/object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "analysis/surface/mesh_tools.h"
#include "analysis/surface/particles.h"
#include "analysis/surface/splat.h"
#include "solver/boundary/rotation.h"
#include "solver/io/frames.h"
#include "solver/io/hdf5.h"
#include "solver/scene/input_error.h"
#include "solver/scene/nearest.h"

namespace bake {
namespace {

constexpr const char* k_browning = "browning";
constexpr const char* k_first_position = "first_position";

/// What is painted: a place in the file's own space, and what the file itself knows there.
struct Part {
  Mesh mesh;
  bool inside;  ///< a cut or crack face: crumb, not skin
};

std::vector<ColourStop> ramp(const std::vector<BrowningStop>& stops) {
  std::vector<ColourStop> ramp;
  for (const BrowningStop& stop : stops)
    ramp.push_back({static_cast<float>(stop.degree),
                    Colour(static_cast<float>(stop.colour[0]), static_cast<float>(stop.colour[1]), static_cast<float>(stop.colour[2]))});
  return ramp;
}

bool is_frame(const std::filesystem::path& file) {
  const Hdf5Reader reader(file);
  if (!reader.has("VTKHDF/Types"))
    throw InputError(
        fmt::format("{}: neither a frame nor a mesh, allowed: a file of bake run, bake-mesh or bake-render surface", file.string()));
  const auto types = reader.array<std::uint8_t>("VTKHDF/Types");
  constexpr std::uint8_t k_poly_vertex = 2;
  return types.size() == 1 && types.front() == k_poly_vertex;
}

std::filesystem::path run_around(const std::filesystem::path& frame) {
  const auto folder = std::filesystem::absolute(frame).parent_path().parent_path();
  return std::filesystem::exists(folder / "frames.hdf.series") ? folder : std::filesystem::path();
}

double diameter(const std::vector<double>& points) {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::max()), high = -low;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const Eigen::Map<const Eigen::Array3d> p(&points[i]);
    low = low.min(p);
    high = high.max(p);
  }
  return points.empty() ? 0 : (high - low).matrix().norm();
}

/// Reads, cuts and paints one file.
class Loader {
 public:
  Loader(const std::filesystem::path& file, std::filesystem::path results, const View& view, const ObjectSettings& settings,
         Histories& histories, int threads)
      : file_(file), results_(std::move(results)), view_(view), settings_(settings), histories_(histories), threads_(threads) {}

  PictureObject load() {
    if (is_frame(file_)) {
      particles_ = read_particles_of_frame(file_);
      if (results_.empty()) results_ = run_around(file_);
      if (settings_.particles == ParticleShape::spheres) return {{}, {spheres()}};
      return painted(parts_of(splat_surface(*particles_, {settings_.spacing_m.value_or(0), threads_})));
    }
    Mesh mesh = read_mesh(file_);
    if (mesh.corners == 4) mesh = boundary_of_tetrahedra(mesh);
    return painted(parts_of(mesh));
  }

 private:
  /// Skin, crack faces and the face of the cut.
  std::vector<Part> parts_of(const Mesh& whole) {
    std::vector<Part> parts;
    const auto add = [&](const Mesh& mesh) {
      Part skin{mesh, false}, crack{mesh, true};
      if (const MeshField* is_crack = mesh.find("crack")) {
        skin.mesh.cells.clear();
        crack.mesh.cells.clear();
        for (std::size_t c = 0; c < mesh.cells.size(); c += 3) {
          const auto at = [&](std::size_t k) { return is_crack->values[static_cast<std::size_t>(mesh.cells[c + k])]; };
          auto& cells = at(0) + at(1) + at(2) > 2.5 ? crack.mesh.cells : skin.mesh.cells;
          cells.insert(cells.end(), &mesh.cells[c], &mesh.cells[c] + 3);
        }
        if (!crack.mesh.cells.empty()) parts.push_back(std::move(crack));
      }
      if (!skin.mesh.cells.empty()) parts.push_back(std::move(skin));
    };
    if (!settings_.cut_normal) {
      add(whole);
      return parts;
    }
    CutMesh pieces = cut(whole, as_eigen(*settings_.cut_point_m), as_eigen(*settings_.cut_normal), diameter(whole.points) / 300);
    if (pieces.kept.cells.empty())
      throw InputError(fmt::format("{}: cut_point_m, cut_normal: the cut leaves nothing of {}", view_.file.string(), file_.string()));
    add(pieces.kept);
    if (!pieces.face.cells.empty()) parts.push_back({std::move(pieces.face), true});
    return parts;
  }

  PictureObject painted(std::vector<Part> parts) {
    double size = 0;
    for (const Part& part : parts) size = std::max(size, diameter(part.mesh.points));
    for (Part& part : parts) give_fields(part.mesh);
    const auto [low, high] = range([&](auto visit) {
      for (const Part& part : parts)
        for (const double value : part.mesh.find(settings_.field)->values) visit(value);
    });
    PictureObject object;
    for (const Part& part : parts) object.meshes.push_back(triangles(part, size, low, high));
    return object;
  }

  /// Sees to it that the mesh has the fields that its paint needs.
  void give_fields(Mesh& mesh) {
    const bool browned = settings_.paint == Paint::browning;
    const std::string name = browned ? k_browning : settings_.field;
    if (settings_.paint == Paint::constant || mesh.find(name)) return;
    if (browned) {
      if (results_.empty())
        throw InputError(
            fmt::format("{}: has no field browning, and its run is not known: give --results <folder of the run>", file_.string()));
      const int frame = frame_at(results_, time_s(mesh));
      if (!particles_) particles_ = read_particles_of_frame(results_ / "frames" / frame_name(frame));
      const BrowningHistory& history = histories_.at(results_, view_.browning, frame);
      add_fields(mesh, {{k_browning, "1", 1, history.degrees(particles_->ids)},
                        {k_first_position, "m", 3, history.first_positions(particles_->ids)}});
      return;
    }
    if (!particles_ && !results_.empty())
      particles_ = read_particles_of_frame(results_ / "frames" / frame_name(frame_at(results_, time_s(mesh))));
    const MeshField* field = particles_ ? particles_->find(name) : nullptr;
    if (field && field->components == 1) return add_fields(mesh, {*field});
    refuse_field(name, mesh.fields);
  }

  double time_s(const Mesh& mesh) const { return particles_ ? particles_->time_s : mesh.time_s; }

  void add_fields(Mesh& mesh, const std::vector<MeshField>& fields) {
    for (MeshField& field : fields_at(mesh.points, *particles_, fields, threads_, file_.string())) mesh.fields.push_back(std::move(field));
  }

  [[noreturn]] void refuse_field(const std::string& name, const std::vector<MeshField>& fields) const {
    std::vector<std::string> known;
    for (const MeshField& field : particles_ ? particles_->fields : fields)
      if (field.components == 1) known.push_back(field.name);
    if (!particles_ && known.empty())
      throw InputError(fmt::format("{}: has no field '{}': give --results <folder of the run>", file_.string(), name));
    throw InputError(fmt::format("{}: has no field '{}'; {}", file_.string(), name, suggestion(name, known)));
  }

  /// What the map spans: as the view says, else the values' own range.
  template <class ForAll>
  std::pair<double, double> range(ForAll for_all) const {
    double low = k_infinity, high = -k_infinity;
    if (settings_.paint == Paint::field && (!settings_.range_low || !settings_.range_high))
      for_all([&](double value) {
        low = std::min(low, value);
        high = std::max(high, value);
      });
    return {settings_.range_low.value_or(low), settings_.range_high.value_or(high)};
  }

  /// Linear colour of what has this value of the painting field.
  Colour colour(double value, bool inside, double low, double high) const {
    if (settings_.paint == Paint::browning) return linear_from_srgb(ramp_colour(inside ? crumb_ : skin_, static_cast<float>(value)));
    const double share = high > low ? (value - low) / (high - low) : 0.5;
    return linear_from_srgb(map_colour(settings_.map, static_cast<float>(share)));
  }
  Colour constant_colour() const { return linear_from_srgb(as_eigen(settings_.colour).cast<float>()); }

  Grain grain(bool inside, double size) const {
    if (settings_.paint != Paint::browning) return {};
    const CrustSettings& c = view_.crust;
    const auto of = [&](double grain, double bump, double mottle) {
      return Grain{static_cast<float>(grain * size), static_cast<float>(bump), static_cast<float>(mottle)};
    };
    return inside ? of(c.crumb_grain, c.crumb_bump, c.crumb_mottle) : of(c.grain, c.bump, c.mottle);
  }
  Gloss gloss(bool inside) const {
    return inside ? Gloss{} : Gloss{static_cast<float>(settings_.coat), static_cast<float>(settings_.roughness)};
  }

  TriangleObject triangles(const Part& part, double size, double low, double high) const {
    const Mesh& mesh = part.mesh;
    TriangleObject object;
    object.gloss = gloss(part.inside);
    object.grain = grain(part.inside, size);
    const MeshField* texture = mesh.find(k_first_position);
    const MeshField* painting =
        settings_.paint == Paint::constant ? nullptr : mesh.find(settings_.paint == Paint::browning ? k_browning : settings_.field);
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
      object.vertices.push_back(placed(Eigen::Map<const Eigen::Vector3d>(&mesh.points[3 * i])));
      object.texture.push_back(Eigen::Map<const Eigen::Vector3d>(texture ? &texture->values[3 * i] : &mesh.points[3 * i]).cast<float>());
      object.albedos.push_back(painting ? colour(painting->values[i], part.inside, low, high) : constant_colour());
    }
    for (const auto& corners : corner_normals(mesh, settings_.crease_deg)) {
      object.normals.push_back({turned(corners[0]), turned(corners[1]), turned(corners[2])});
    }
    for (std::size_t c = 0; c < mesh.cells.size(); c += 3)
      object.triangles.push_back({static_cast<std::uint32_t>(mesh.cells[c]), static_cast<std::uint32_t>(mesh.cells[c + 1]),
                                  static_cast<std::uint32_t>(mesh.cells[c + 2])});
    return object;
  }

  SphereObject spheres() {
    std::vector<double> values;
    if (settings_.paint == Paint::browning) {
      if (results_.empty()) throw InputError(fmt::format("{}: its run is not known: give --results <folder of the run>", file_.string()));
      values = histories_.at(results_, view_.browning, frame_at(results_, particles_->time_s)).degrees(particles_->ids);
    } else if (settings_.paint == Paint::field) {
      const MeshField* field = particles_->find(settings_.field);
      if (!field || field->components != 1) refuse_field(settings_.field, {});
      values = field->values;
    }
    const auto [low, high] = range([&](auto visit) { std::for_each(values.begin(), values.end(), visit); });
    SphereObject object;
    object.gloss = gloss(false);
    for (std::size_t i = 0; i < particles_->count(); ++i) {
      const Eigen::Vector3d p = Eigen::Map<const Eigen::Vector3f>(&particles_->positions[3 * i]).cast<double>();
      if (settings_.cut_normal && (p - as_eigen(*settings_.cut_point_m)).dot(as_eigen(*settings_.cut_normal)) > 0) continue;
      const double radius = settings_.sphere_scale * std::cbrt(particles_->volumes[i] * 3 / (4 * std::numbers::pi));
      object.spheres.emplace_back();
      object.spheres.back() << placed(p), static_cast<float>(radius);
      object.albedos.push_back(values.empty() ? constant_colour() : colour(values[i], false, low, high));
    }
    if (object.spheres.empty())
      throw InputError(fmt::format("{}: cut_point_m, cut_normal: the cut leaves nothing of {}", view_.file.string(), file_.string()));
    return object;
  }

  static Eigen::Vector3d as_eigen(const Vector3& v) { return {v[0], v[1], v[2]}; }
  Vec3f turned(const Vec3f& p) const {
    const Vector3 q = rotation_ * Vector3{p.x(), p.y(), p.z()};
    return as_eigen(q).cast<float>();
  }
  Vec3f placed(const Eigen::Vector3d& p) const {
    const Vector3 q = rotation_ * Vector3{p.x(), p.y(), p.z()};
    return (as_eigen(q) + as_eigen(settings_.offset_m)).cast<float>();
  }

  const std::filesystem::path& file_;
  std::filesystem::path results_;
  const View& view_;
  const ObjectSettings& settings_;
  Histories& histories_;
  int threads_;
  std::vector<ColourStop> skin_ = ramp(view_.crust.skin), crumb_ = ramp(view_.crust.crumb);
  Rotation rotation_ = matrix(quaternion(k_rad_per_deg * settings_.rotate_deg));
  std::optional<Particles> particles_;  ///< of the frame that is shown
};

}  // namespace

const BrowningHistory& Histories::at(const std::filesystem::path& results, const BrowningLaw& law, int frame) {
  Entry& entry = entries_[results];
  if (!entry.history || frame < entry.frame) entry.history = std::make_unique<BrowningHistory>(results, law);
  entry.history->advance_to(frame);
  entry.frame = frame;
  return *entry.history;
}

PictureObject load_object(const std::filesystem::path& file, const std::filesystem::path& results, const View& view,
                          const ObjectSettings& settings, Histories& histories, int threads) {
  return Loader(file, results, view, settings, histories, threads).load();
}

}  // namespace bake
