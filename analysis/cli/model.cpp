// SPDX-License-Identifier: MIT
// Frames and pictures in the sizes that a page can carry: for the report.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/cli/commands.h"
#include "analysis/image/image.h"
#include "analysis/pictures/object.h"
#include "analysis/pictures/shown.h"
#include "analysis/surface/mesh_tools.h"
#include "analysis/surface/splat.h"
#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "solver/io/frames.h"
#include "solver/io/progress.h"
#include "solver/scene/entry.h"

namespace bake::render {
namespace {

namespace fs = std::filesystem;

constexpr std::array k_fields{"temperature", "saturation", "porosity", "browning"};
constexpr double k_speck = 1e-4;  ///< share of the largest part's volume below which a part is not worth its bytes

struct ModelOptions {
  fs::path view, results, out;
  std::vector<int> frames;
  int triangles = 18000, particles = 8000, threads = 0;
};

/// Whether a particle is among that share of all: the same ones in all frames, spread as by chance.
bool is_kept(std::int64_t id, double share) {
  constexpr int k_bits = 24;
  return static_cast<double>(static_cast<std::uint64_t>(id) * 0x9e3779b97f4a7c15u >> (64 - k_bits)) < share * (1 << k_bits);
}

/// The particles' fields that a page shows, as far as the run has them.
std::vector<MeshField> fields_of(const Particles& particles, const BrowningHistory* history) {
  std::vector<MeshField> fields;
  for (const char* name : k_fields) {
    if (const MeshField* field = particles.find(name)) fields.push_back(*field);
    if (std::string_view(name) == "browning" && history) fields.push_back({name, "1", 1, history->degrees(particles.ids)});
  }
  return fields;
}

void write_particles(const fs::path& path, const Particles& particles, const std::vector<MeshField>& fields, double share) {
  FrameData data;
  std::vector<float> positions;
  FrameColumn id{"id", "", std::vector<std::int64_t>(), 1};
  FrameColumn volume{"volume", "m^3", std::vector<float>(), 1};
  std::vector<FrameColumn> columns;
  for (const MeshField& field : fields) columns.push_back({field.name, field.unit, std::vector<float>(), 1});
  for (std::size_t i = 0; i < particles.count(); ++i) {
    if (!is_kept(particles.ids[i], share)) continue;
    positions.insert(positions.end(), &particles.positions[3 * i], &particles.positions[3 * i] + 3);
    std::get<std::vector<std::int64_t>>(id.values).push_back(particles.ids[i]);
    std::get<std::vector<float>>(volume.values).push_back(particles.volumes[i] / static_cast<float>(share));
    for (std::size_t f = 0; f < fields.size(); ++f)
      std::get<std::vector<float>>(columns[f].values).push_back(static_cast<float>(fields[f].values[i]));
  }
  data.positions = std::move(positions);
  data.columns = {id, volume};
  data.columns.insert(data.columns.end(), columns.begin(), columns.end());
  write_frame(path, particles.time_s, data);
}

/// A surface of about so many triangles at most, which grow in number as the distance that is resolved falls.
Mesh surface_of(Particles particles, const std::vector<MeshField>& fields, double& spacing_m, int triangles, int threads) {
  particles.fields = fields;
  Mesh mesh = splat_surface(particles, {spacing_m, threads});
  const double excess = static_cast<double>(mesh.cell_count()) / triangles;
  if (excess > 1) {
    spacing_m = (spacing_m > 0 ? spacing_m : static_cast<double>(particles.spacing())) * std::sqrt(1.05 * excess);
    mesh = splat_surface(particles, {spacing_m, threads});
  }
  return without_specks(mesh, k_speck);
}

/// Colours by degree of browning, as the page's viewer takes them: [[0, "edd9ad"], ...].
nlohmann::json stops_of(const std::vector<BrowningStop>& ramp) {
  nlohmann::json stops = nlohmann::json::array();
  for (const BrowningStop& stop : ramp) {
    const auto rgb =
        pixel(Colour(static_cast<float>(stop.colour[0]), static_cast<float>(stop.colour[1]), static_cast<float>(stop.colour[2])));
    stops.push_back({stop.degree, fmt::format("{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2])});
  }
  return stops;
}

/// The particles of a frame, completed by mirror images and turned as the view's first object.
Particles read_completed(const fs::path& frame, const ModelOptions& options, const ObjectSettings& object) {
  Shown shown(frame, options.results, thread_count(options.threads));
  if (!shown.particles().ids.empty())
    for (const char axis : object.mirrored) shown.mirror(axis - 'x');
  shown.turn(object.rotate_deg);
  return shown.particles();
}

/// Gives each mirror image identities of its own.
void number_images(Particles& particles, std::size_t images) {
  constexpr int k_bits = 40;  // more than any run has particles
  const std::size_t count = particles.ids.size() / images;
  for (std::size_t i = count; i < particles.ids.size(); ++i) particles.ids[i] += static_cast<std::int64_t>(i / count) << k_bits;
}

void make_model(const ModelOptions& options) {
  const View view = read_view(options.view);
  const ObjectSettings& object = view.objects.front();
  const std::size_t images = std::size_t{1} << object.mirrored.size();
  const int threads = thread_count(options.threads);
  fs::create_directories(options.out);
  const auto count_in = [&](int frame) { return FrameReader(options.results / "frames" / frame_name(frame)).particles(); };
  if (std::adjacent_find(options.frames.begin(), options.frames.end(), std::greater_equal<>()) != options.frames.end())
    throw InputError(fmt::format("--frames: found {}, allowed: rising numbers", fmt::join(options.frames, ",")));
  const std::size_t count = std::max(count_in(options.frames.front()), count_in(options.frames.back()));  // some may be poured
  const double share = std::min(1.0, options.particles / static_cast<double>(images * count));
  const nlohmann::json look{{"skin", stops_of(view.crust.skin)}, {"crumb", stops_of(view.crust.crumb)}};
  write_text_atomically(options.out / "look.json", look.dump() + "\n");
  Histories histories;
  Meter meter(options.out.filename().string());
  double spacing_m = 0;
  std::size_t done = 0;
  for (const int number : options.frames) {
    const fs::path frame = options.results / "frames" / frame_name(number);
    Particles particles = read_completed(frame, options, object);
    if (particles.ids.empty()) throw InputError(fmt::format("{}: has no column id, allowed: a frame of bake run", frame.string()));
    const bool has_heat = particles.find("temperature");
    const std::vector<MeshField> fields = fields_of(particles, has_heat ? &histories.at(options.results, view.browning, number) : nullptr);
    number_images(particles, images);
    write_particles(options.out / ("particles_" + frame_name(number)), particles, fields, share);
    write_mesh(options.out / ("surface_" + frame_name(number)), surface_of(particles, fields, spacing_m, options.triangles, threads));
    meter(static_cast<double>(++done) / static_cast<double>(options.frames.size()));
  }
  meter.clear();
}

}  // namespace

void add_model_command(CLI::App& app, Action& action) {
  const auto options = std::make_shared<ModelOptions>();
  CLI::App* command = app.add_subcommand("model", "Surfaces and particles of some frames, small enough for a page on which they turn");
  command
      ->add_option("view", options->view,
                   "whose [browning] colours them, and whose first [[object]] may be mirrored and turned: a TOML file")
      ->required();
  command->add_option("results", options->results, "folder of the run")->required();
  command->add_option("--frames", options->frames, "numbers of the frames, rising: 0,40,80")->required()->delimiter(',');
  command->add_option("--out", options->out, "folder of surface_<frame>.hdf, particles_<frame>.hdf and the colours, look.json")->required();
  command->add_option("--triangles", options->triangles, "most triangles of a surface [18000]")->transform(whole_number(100, 1000000));
  command->add_option("--particles", options->particles, "most particles of a frame [8000]")->transform(whole_number(1, 100000000));
  add_threads_option(*command, options->threads);
  on_request(*command, action, [options] { make_model(*options); });
}

void add_jpeg_command(CLI::App& app, Action& action) {
  struct Options {
    fs::path picture, out;
    int width = 1600, quality = 82;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("jpeg", "A picture as JPEG for a page");
  command->add_option("picture", options->picture, "a PNG file")->required();
  command->add_option("--out", options->out, "the picture, a .jpg file")->required();
  command->add_option("--width", options->width, "most pixels across [1600]")->transform(whole_number(16, 16384));
  command->add_option("--quality", options->quality, "1 to 100 [82]")->transform(whole_number(1, 100));
  on_request(*command, action, [options] {
    check_ending(options->out, ".jpg");
    const Image image = read_png(options->picture);
    const int width = std::min(image.width, options->width);
    const int height = std::max(1, static_cast<int>(std::lround(static_cast<double>(image.height) * width / image.width)));
    write_jpeg(options->out, width == image.width ? image : scaled(image, width, height), options->quality);
  });
}

}  // namespace bake::render
