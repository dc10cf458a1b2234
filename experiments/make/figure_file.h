// SPDX-License-Identifier: MIT
// Reads experiments/<item>/figure.toml, which tells how an item of the paper is made from runs, and what is claimed of them.
#pragma once

#include <functional>
#include <memory>

#include "analysis/claims/claim.h"
#include "experiments/make/items.h"

namespace bake {

/// [[run]]: a scene that is simulated, into results/<name>-<quality>.
struct FigureRun {
  std::string name;
  std::string scene;
  std::vector<std::string> set;
  bool mesh = false;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &FigureRun::name, "", any_number, "what claims, surfaces, pictures and charts call it", Presence::required},
        Parameter{"scene", &FigureRun::scene, "", any_number, "a scene of this folder, or <experiment>/<scene>", Presence::required},
        Parameter{"set", &FigureRun::set, "", any_number, "overrides key=value, as for bake run --set"},
        Parameter{"mesh", &FigureRun::mesh, "", any_number,
                  "the particles of body 0 are the vertices of its mesh of tetrahedra (bake-mesh tets), kept as mesh.hdf beside the run"},
    };
  }
};

/// [[surface]]: the fracture surface of a run with a mesh (bake-mesh fracture).
struct FigureSurface {
  std::string name;
  std::string run;
  double reference_time_s = 0;
  std::vector<double> times_s;
  std::optional<double> stretch, smallest_gap_m, void_ratio, smallest_crack;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &FigureSurface::name, "", any_number, "what claims and pictures call it", Presence::required},
        Parameter{"run", &FigureSurface::run, "", any_number, "the run, one with mesh = true", Presence::required},
        Parameter{"reference_time_s", &FigureSurface::reference_time_s, "s", non_negative,
                  "edges break when they are longer than `stretch` times their length at this time"},
        Parameter{"times_s", &FigureSurface::times_s, "s", non_negative, "times of the surfaces; at the end unless given"},
        Parameter{"stretch", &FigureSurface::stretch, "1", Range{1, k_infinity, true, true, "a number above 1"},
                  "an edge breaks beyond this many times its reference length; as in bake-mesh unless given"},
        Parameter{"smallest_gap_m", &FigureSurface::smallest_gap_m, "m", non_negative,
                  "an edge breaks only if it is also longer than this; as in bake-mesh unless given"},
        Parameter{
            "void_ratio", &FigureSurface::void_ratio, "1", Range{1, k_infinity, true, true, "a number above 1"},
            "an edge breaks only if also the tetrahedra around it hold this many times the volume of their dough; not asked unless given"},
        Parameter{"smallest_crack", &FigureSurface::smallest_crack, "dx^2", non_negative,
                  "cracks smaller than this many faces of a cell of the run's grid stay closed; none unless given"},
    };
  }
};

/// What follows the name of a run whose skins a picture shows.
inline constexpr std::string_view k_skin_of = ".skin";

/// [[measured]]: what others measured of the real thing, as points over time.
struct FigureMeasured {
  std::string name;
  std::string source;
  std::string reading;
  std::vector<double> times_s;
  std::vector<double> values;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &FigureMeasured::name, "", any_number, "what claims and charts call it", Presence::required},
        Parameter{"source", &FigureMeasured::source, "", any_number, "who published it, and where", Presence::required},
        Parameter{"reading", &FigureMeasured::reading, "", any_number, "how the numbers were read, and how far they can be trusted",
                  Presence::required},
        Parameter{"times_s", &FigureMeasured::times_s, "s", non_negative, "times of the points, rising", Presence::required},
        Parameter{"values", &FigureMeasured::values, "", any_number, "what was measured, in the unit of the metric it is compared with",
                  Presence::required},
    };
  }
};

enum class PictureKind { picture, slice };
constexpr auto choice_names(PictureKind) { return std::array{"picture", "slice"}; }

struct Figure;

/// [[picture]]: a picture that bake-render makes.
struct FigurePicture {
  std::string name;
  std::string figure;
  std::shared_ptr<const Figure> part;  ///< with `figure`: of that figure what the picture shows, and what is claimed of it
  std::string shows;
  PictureKind kind = PictureKind::picture;
  std::string view;
  std::vector<std::string> of;
  std::vector<double> times_s;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &FigurePicture::name, "", any_number, "name of its file", Presence::required},
        Parameter{
            "figure", &FigurePicture::figure, "", any_number,
            "another item by its name: the picture shows runs of that one's figure.toml, which are made, and their claims are measured: "
            "<name>_claims_hold is the share that holds"},
        Parameter{"shows", &FigurePicture::shows, "", any_number,
                  "what it shows: for readers who cannot see it, and as its caption on the page", Presence::required},
        Parameter{"kind", &FigurePicture::kind, "", any_number, "the command of bake-render"},
        Parameter{"view", &FigurePicture::view, "", any_number, "views/<view>.toml of this folder: camera, light, labels",
                  Presence::required},
        Parameter{"of", &FigurePicture::of, "", any_number,
                  "runs (their frames), surfaces, and <run>.skin (the skins of a run), in the order of the view's objects",
                  Presence::required},
        Parameter{"times_s", &FigurePicture::times_s, "s", non_negative, "the time of each; at the end unless given"},
    };
  }
};

/// [[montage]]: pictures of this figure as tiles of one.
struct FigureMontage {
  std::string name;
  std::string shows;
  std::vector<std::string> rows;
  int cell_width_px = 0;
  int cell_height_px = 0;
  static constexpr auto parameters() {
    constexpr Range pixels{16, 4096, false, false, "a whole number from 16 to 4096"};
    return std::tuple{
        Parameter{"name", &FigureMontage::name, "", any_number, "name of its file", Presence::required},
        Parameter{"shows", &FigureMontage::shows, "", any_number,
                  "what it shows: for readers who cannot see it, and as its caption on the page", Presence::required},
        Parameter{"rows", &FigureMontage::rows, "", any_number,
                  "rows of equal cells, \"one two two\": the picture whose name stands in cells that touch fills all of them",
                  Presence::required},
        Parameter{"cell_width_px", &FigureMontage::cell_width_px, "", pixels, "width of a cell", Presence::required},
        Parameter{"cell_height_px", &FigureMontage::cell_height_px, "", pixels, "height of a cell", Presence::required},
    };
  }
};

/// [[chart]]: a column of the ledger or a metric over time, one metric at the end against another, or, if only a name is given, a chart
/// that the item's function computes.
struct FigureChart {
  std::string name;
  std::string shows;
  std::string column;
  std::string metric;
  std::string against;
  MetricPlace place;  ///< its keys stand directly in [[chart]]
  std::string label;
  std::vector<std::string> of;
  std::vector<std::string> measured;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &FigureChart::name, "", any_number, "name of its files", Presence::required},
        Parameter{"shows", &FigureChart::shows, "", any_number,
                  "what it shows: for readers who cannot see it, and as its caption on the page", Presence::required},
        Parameter{"column", &FigureChart::column, "", any_number, "column of the ledger, drawn over time"},
        Parameter{"metric", &FigureChart::metric, "", any_number,
                  "or a metric of runs that has a time, drawn over time; what it needs stands beside it"},
        Parameter{"against", &FigureChart::against, "", any_number,
                  "a second metric of runs: each run is then one point, the first upright, both at its end; for scans"},
        Parameter{"label", &FigureChart::label, "", any_number, "beside the upright axis; the name of column or metric unless given"},
        Parameter{"of", &FigureChart::of, "", any_number, "the runs, one line each"},
        Parameter{"measured", &FigureChart::measured, "", any_number,
                  "measured points, each in the colour of the run at the same place of `of`; over time only"},
    };
  }
};

/// [[object]]: runs that the report shows as bodies that turn, from which bake-render makes small surfaces and particles.
struct FigureObject {
  std::string name;
  std::string shows;
  std::string view;
  std::string picture;
  std::vector<std::string> of;
  double from_s = 0;
  bool particles = false;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &FigureObject::name, "", any_number, "name of its folder", Presence::required},
        Parameter{"shows", &FigureObject::shows, "", any_number, "what it shows: for readers who cannot see it, and as its caption",
                  Presence::required},
        Parameter{"view", &FigureObject::view, "", any_number, "views/<view>.toml of this folder: how it browns and its colours",
                  Presence::required},
        Parameter{"picture", &FigureObject::picture, "", any_number,
                  "the [[picture]] that stands for it in print and where nothing can turn", Presence::required},
        Parameter{"of", &FigureObject::of, "", any_number, "runs; the others are seen beside the first, at its times", Presence::required},
        Parameter{"from_s", &FigureObject::from_s, "s", non_negative,
                  "only what happens from then on: where the view turns a body that was turned over"},
        Parameter{"particles", &FigureObject::particles, "", any_number,
                  "particles can be shown, too: for what tears or is poured, of which surfaces change from moment to moment"},
    };
  }
};

struct Figure {
  std::filesystem::path file;
  std::string title;
  std::string shows;   ///< what the paper claims
  bool timed = false;  ///< how long its runs take is what it tells: none goes beside another
  std::vector<FigureRun> runs;
  std::vector<FigureSurface> surfaces;
  std::vector<FigurePicture> pictures;
  std::vector<FigureMontage> montages;
  std::vector<FigureObject> objects;
  std::vector<FigureMeasured> measured;
  std::vector<FigureChart> charts;
  std::vector<Claim> claims;
};

/// Names of the charts and numbers that an item's function computes (see experiments/make/computed.h), and the way to other figures.
struct ComputedNames {
  std::vector<std::string> charts;
  std::vector<KnownNumber> numbers;
  /// Reads the figure of another item, of that name; throws InputError.
  std::function<Figure(const std::string& item)> other = {};
};

/// The number that a figure with `[[picture]] figure = "..."` has of that picture: the share of the claims of what it shows that hold.
inline std::string claims_number(const FigurePicture& picture) { return picture.name + "_claims_hold"; }

/// The runs that the picture shows, themselves or by their skins and surfaces, in the order in which it names them.
std::vector<std::string> runs_shown(const FigurePicture& picture, const Figure& figure);
/// The names of all its runs, also of those of other figures that its pictures show, each once.
std::vector<std::string> runs_of(const Figure& figure);
/// Whether that is the run or a surface of it.
bool belongs_to(const Figure& figure, const std::string& name, const std::string& run);

/// Reads the file and checks that every name in it refers to something that exists. Throws InputError with file, line, found and allowed.
Figure read_figure(const std::filesystem::path& file, const ComputedNames& computed = {});

/// The scene file of a run: experiments/<experiment>/<scene>.toml beside the figure's folder.
std::filesystem::path scene_file(const Figure& figure, const FigureRun& run);
/// The file of a view that a picture or object names.
std::filesystem::path view_file(const Figure& figure, const std::string& view);

template <class T>
const T* find_named(const std::vector<T>& list, std::string_view name) {
  for (const T& one : list)
    if (one.name == name) return &one;
  return nullptr;
}

}  // namespace bake
