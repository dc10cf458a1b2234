// SPDX-License-Identifier: MIT
#include "experiments/make/make_figure.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "experiments/make/pipeline.h"
#include "experiments/make/programs.h"
#include "solver/core/tell.h"
#include "solver/scene/entry.h"

namespace bake {

void say(const MakeOptions& options, const std::string& line) {
  const char* const over_a_bar = isatty(STDERR_FILENO) ? "\r\x1b[K" : "";  // of a program that is under way
  if (!options.quiet) tell_user("{}{}", over_a_bar, line);
}

bool MadeFigure::holds() const {
  return !verdicts.empty() && std::all_of(verdicts.begin(), verdicts.end(), [](const ClaimVerdict& v) { return v.holds; });
}

namespace {

Computed compute(const Item& item) {
  const ComputedItem* own = find_computed(item.experiment);
  return own ? own->compute() : Computed{};
}

}  // namespace

ReadFigure read_figure(const Items& items, const Item& item) {
  if (item.status != ItemStatus::done)
    throw InputError(
        fmt::format("{} ({}): {}, allowed: an item that is done (bake list figures)", item.number, item.name, word_of(item.status)));
  Computed computed = compute(item);
  ComputedNames names = names_of(computed);
  names.other = [&](const std::string& name) {
    const Item& other = find_item(items, name);
    if (other.name == item.name) throw InputError(fmt::format("found '{}', which is this one, allowed: another", quotable(name)));
    Figure figure = read_figure(items, other).figure;
    if (std::any_of(figure.pictures.begin(), figure.pictures.end(), [](const FigurePicture& picture) { return picture.part != nullptr; }))
      throw InputError(fmt::format("found '{}', whose pictures show others, allowed: a figure of its own runs", quotable(name)));
    return figure;
  };
  return {read_figure(items.figure_file_of(item), names), std::move(computed)};
}

namespace {

/// Checks this before hours of simulation.
void check_programs(const FigurePaths& paths) {
  for (const FigurePaths& part : with_parts(paths)) {
    const auto& runs = part.figure.runs;
    if (std::any_of(runs.begin(), runs.end(), [](const FigureRun& run) { return run.mesh; })) find_program("bake-mesh");
  }
  if (paths.options.pictures && paths.options.only_run.empty() && !(paths.figure.pictures.empty() && paths.figure.objects.empty()))
    find_program("bake-render");
}

}  // namespace

MadeFigure make_figure(const Items& items, const Item& item, const MakeOptions& options) {
  auto [figure, computed] = read_figure(items, item);
  const FigurePaths paths{item, figure, options};
  check_programs(paths);
  make_runs(paths);
  if (!options.only_run.empty()) return {{}, {}, paths.run(options.only_run)};
  if (!figure.runs.empty()) computed = compute(item);  // it may need the runs
  make_surfaces(paths);
  if (options.pictures) {
    make_pictures(paths);
    make_objects(paths);
  }
  make_charts(paths, computed);
  add_parts(paths, computed);
  write_tables(paths, computed);
  const auto verdicts = check_claims(paths, computed);
  write_claims(paths, computed, verdicts);
  return {verdicts, computed.tables, paths.item_folder()};
}

}  // namespace bake
