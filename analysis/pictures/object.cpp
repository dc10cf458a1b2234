// SPDX-License-Identifier: MIT
#include "analysis/pictures/object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/pictures/shown.h"
#include "analysis/surface/mesh_tools.h"
#include "solver/boundary/rotation.h"
#include "solver/core/errors.h"

namespace bake {
namespace {

constexpr const char* k_browning = "browning";
constexpr const char* k_first_position = "first_position";

/// A point that gets a colour: its position in the file's own space, and the values of the file there.
struct Part {
  Mesh mesh;
  bool inside;  ///< a cut or crack face: crumb, not skin
};

std::vector<ColourStop> ramp(const std::vector<BrowningStop>& stops) {
  std::vector<ColourStop> ramp;
  ramp.reserve(stops.size());
  for (const BrowningStop& stop : stops)
    ramp.push_back({static_cast<float>(stop.degree),
                    Colour(static_cast<float>(stop.colour[0]), static_cast<float>(stop.colour[1]), static_cast<float>(stop.colour[2]))});
  return ramp;
}

/// Reads, cuts and paints one file.
class Loader {
 public:
  Loader(const Shown& shown, const View& view, const ObjectSettings& settings, Histories& histories)
      : shown_(shown), view_(view), settings_(settings), histories_(histories) {}

  PictureObject load() {
    if (shown_.is_frame() && settings_.particles == ParticleShape::spheres) return spheres();
    Mesh mesh = shown_.surface(settings_.spacing_m.value_or(0));
    if (settings_.outwards_m > 0) move_outwards(mesh, settings_.outwards_m);
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
      throw InputError(
          fmt::format("{}: cut_point_m, cut_normal: the cut leaves nothing of {}", view_.file.string(), shown_.file().string()));
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
    if (settings_.paint == Paint::field) object.bar = bar(low, high, parts.front().mesh.find(settings_.field)->unit);
    return object;
  }

  /// Adds the fields to the mesh that its colours need.
  void give_fields(Mesh& mesh) {
    if (settings_.paint == Paint::field) shown_.provide(mesh, settings_.field);
    if (settings_.paint != Paint::browning || mesh.find(k_browning)) return;
    const BrowningHistory& history = this->history();
    const std::vector<std::int64_t>& ids = shown_.particles().ids;
    shown_.add_fields(mesh, {{k_browning, "1", 1, history.degrees(ids)}, {k_first_position, "m", 3, history.first_positions(ids)}});
  }

  const BrowningHistory& history() const {
    return histories_.at(shown_.results(), view_.browning, frame_at(shown_.results(), shown_.time_s()));
  }

  /// The range of the colour map: as the view says, else that of the values.
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
    return linear_from_srgb(map_colour(settings_.map, static_cast<float>(settings_.backwards ? 1 - share : share)));
  }
  Colour constant_colour() const { return linear_from_srgb(as_eigen(settings_.colour).cast<float>()); }

  Grain grain(bool inside, double size) const {
    if (settings_.paint != Paint::browning) return {};
    const CrustSettings& c = view_.crust;
    const auto of = [&](double grain, double bump, double mottle) {
      return Grain{static_cast<float>(grain * size), static_cast<float>(bump), static_cast<float>(mottle), inside};
    };
    return inside ? of(c.crumb_grain, c.crumb_bump, c.crumb_mottle) : of(c.grain, c.bump, c.mottle);
  }
  Gloss gloss(bool inside) const {
    if (inside) return {};
    return {static_cast<float>(settings_.coat), static_cast<float>(settings_.roughness), static_cast<float>(settings_.translucent_m)};
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

  ColourBar bar(double low, double high, const std::string& unit) const {
    return {settings_.map, low, high, label_of_field(settings_.field, unit)};
  }

  PictureObject spheres() {
    std::vector<double> values;
    std::string unit;
    const Particles& particles = shown_.particles();
    if (settings_.paint == Paint::browning) {
      values = history().degrees(particles.ids);
    } else if (settings_.paint == Paint::field) {
      const MeshField* field = particles.find(settings_.field);
      if (!field || field->components != 1) shown_.refuse_field(settings_.field, particles.fields);
      values = field->values;
      unit = field->unit;
    }
    const auto [low, high] = range([&](auto visit) { std::for_each(values.begin(), values.end(), visit); });
    SphereObject object;
    object.gloss = gloss(false);
    for (std::size_t i = 0; i < particles.count(); ++i) {
      const Eigen::Vector3d p = Eigen::Map<const Eigen::Vector3f>(&particles.positions[3 * i]).cast<double>();
      if (settings_.cut_normal && (p - as_eigen(*settings_.cut_point_m)).dot(as_eigen(*settings_.cut_normal)) > 0) continue;
      const double radius = settings_.sphere_scale * std::cbrt(particles.volumes[i] * 3 / (4 * std::numbers::pi));
      object.spheres.emplace_back();
      object.spheres.back() << placed(p), static_cast<float>(radius);
      object.albedos.push_back(values.empty() ? constant_colour() : colour(values[i], false, low, high));
    }
    if (object.spheres.empty())
      throw InputError(
          fmt::format("{}: cut_point_m, cut_normal: the cut leaves nothing of {}", view_.file.string(), shown_.file().string()));
    PictureObject all{{}, {std::move(object)}, {}};
    if (settings_.paint == Paint::field) all.bar = bar(low, high, unit);
    return all;
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

  const Shown& shown_;
  const View& view_;
  const ObjectSettings& settings_;
  Histories& histories_;
  std::vector<ColourStop> skin_ = ramp(view_.crust.skin), crumb_ = ramp(view_.crust.crumb);
  Rotation rotation_ = matrix(quaternion(k_rad_per_deg * settings_.rotate_deg));
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
  Shown shown(file, results, threads);
  if (settings.material) shown.keep_material(*settings.material);
  for (const char axis : settings.mirrored) shown.mirror(axis - 'x');
  PictureObject object = Loader(shown, view, settings, histories).load();
  object.time_s = shown.time_s();
  return object;
}

}  // namespace bake
