// SPDX-License-Identifier: MIT
#include "figures/make_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "figures/programs.h"
#include "figures/steps.h"

namespace bake {

void say(const MakeOptions& options, const std::string& line) {
  if (!options.quiet) fmt::print(stderr, "{}\n", line);
}

bool MadeFigure::holds() const {
  return std::all_of(verdicts.begin(), verdicts.end(), [](const ClaimVerdict& v) { return v.holds; });
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
  return {read_figure(items.figure_file_of(item), names_of(computed)), std::move(computed)};
}

namespace {

/// Before hours of simulation.
void check_programs(const Place& place) {
  const auto& runs = place.figure.runs;
  if (std::any_of(runs.begin(), runs.end(), [](const FigureRun& run) { return run.mesh; })) find_program("bake-mesh");
  if (place.options.pictures && place.options.only_run.empty() && !place.figure.pictures.empty()) find_program("bake-render");
}

}  // namespace

MadeFigure make_figure(const Items& items, const Item& item, const MakeOptions& options) {
  auto [figure, computed] = read_figure(items, item);
  const Place place{item, figure, options};
  check_programs(place);
  make_runs(place);
  if (!options.only_run.empty()) return {{}, {}, place.run(options.only_run)};
  if (!figure.runs.empty()) computed = compute(item);  // it may be about its runs
  make_surfaces(place);
  if (options.pictures) make_pictures(place);
  make_charts(place, computed);
  write_tables(place, computed);
  const auto verdicts = check_claims(place, computed);
  write_claims(place, computed, verdicts);
  return {verdicts, computed.tables, place.item_folder()};
}

}  // namespace bake
