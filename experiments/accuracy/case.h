// SPDX-License-Identifier: MIT
// What is computed, in which ways, and how wrong the result is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace bake {
struct Scene;
}

namespace bake::studies::accuracy {

/// Who takes the steps: the solver, or the textbook baker (reference/textbook), which stages them as the paper does.
enum class By { solver, textbook };

/// One way to compute a case: how fine, and what differs from the default.
struct Variant {
  std::string label;                   ///< of its curve: "default", "cubic kernel"
  int cells = 0;                       ///< that the case's length is divided into: what dx is
  int per_cell = 0;                    ///< particles in a cell; 0: as the case has them
  std::vector<std::string> overrides;  ///< `key=value` of the scene
  By by = By::solver;
};

/// What one run of a variant found.
struct Found {
  double error = std::numeric_limits<double>::quiet_NaN();  ///< relative, as the case defines it
  std::map<std::string, double> parts;                      ///< the errors that it is the rms of, by quantity; empty if it is a single one
  std::string failure;                                      ///< why there is no error, else empty
  std::int64_t particles = 0, steps = 0, particle_steps = 0;
  double wall_s = 0, cpu_s = 0;  ///< of the steps alone: filling and files are not counted
};

enum class Effort { quick, usual, full };

struct Case {
  std::string name;
  std::string measured;            ///< the error in words
  std::string scene;               ///< of experiments/, "teaching/heated_slab"; empty if it is the study's own
  std::string cells_of;            ///< what `cells` divides: "the slab's length"
  std::vector<int> cells;          ///< of every curve, rising; --quick takes the first three
  std::vector<int> full_cells;     ///< further ones with --full
  std::vector<int> quality;        ///< cells at draft, standard and paper, where a scene has them: the default's curve has these, too
  std::vector<std::string> knobs;  ///< those that are turned (see knobs.cpp), without dx
  Effort from = Effort::quick;     ///< the least effort that measures it unless it is asked for by name
  int version = 1;                 ///< raised when `measure` changes: what was stored before is then measured anew
  std::function<Scene(const Variant&)> scene_of;
  std::function<Found(const Scene&, By)> measure;
  std::function<std::string()> missing = [] { return std::string(); };  ///< why it cannot be measured, else empty
  /// Without an exact solution: makes what it is measured against, in a folder where an unfinished run goes on.
  std::function<void(const std::filesystem::path& folder)> make_reference = {};
};

/// Every variant of a case that this effort measures; the default's come first, each curve's with rising cells.
std::vector<Variant> variants_of(const Case& c, Effort effort);

/// experiments/<name>.toml.
std::filesystem::path scene_path(const std::string& name);
/// The same read with dx = length / v.cells, the overrides of the case, then those of the variant. Throws InputError.
Scene scene_of_file(const std::string& name, double length, const Variant& v, const std::vector<std::string>& of_case = {});

/// All cases, in order of their names in the tables. To add one, add a line in cases.cpp.
const std::vector<Case>& all_cases();
/// Throws InputError, with the known names.
const Case& find_case(const std::string& name);

Case heated_slab();
Case cooling_sphere();
Case barenblatt();
Case elastic_bar();
Case vortex();
Case drying_cube();
Case dough_pull();
Case rising_ball();
Case cookie();
Case bread();

}  // namespace bake::studies::accuracy
