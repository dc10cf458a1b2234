// SPDX-License-Identifier: MIT
// Every link of the paper's items leads somewhere: the lint of paper/items.toml and of every experiments/<item>/figure.toml.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "experiments/make/make_figure.h"
#include "solver/scene/reader.h"

namespace bake {
namespace {

TEST(PaperItems, AreAllFiguresAndTablesOnce) {
  std::set<std::string> expected{"table 1", "table 2"}, found;
  for (int figure = 1; figure <= 19; ++figure) expected.insert("figure " + std::to_string(figure));
  for (const Item& item : read_items(BAKE_SOURCE_DIR).items)  // twice would have been refused
    if (!item.number.starts_with("experiment")) found.insert(item.number);
  EXPECT_EQ(found, expected);
}

TEST(PaperItems, LeadToExperimentsScenesViewsAndMetricsThatExist) {
  const Items items = read_items(BAKE_SOURCE_DIR);
  for (const Item& item : items.items) {
    if (item.status != ItemStatus::done) continue;
    SCOPED_TRACE(item.number);
    const ReadFigure read = read_figure(items, item);
    for (const FigureRun& run : read.figure.runs) EXPECT_NO_THROW(read_scene(scene_file(read.figure, run), {Quality::draft, run.set}));
  }
}

/// Their results have one folder.
TEST(PaperItems, MeanOneSimulationByOneNameOfARun) {
  const Items items = read_items(BAKE_SOURCE_DIR);
  std::map<std::string, std::pair<std::filesystem::path, std::vector<std::string>>> known;
  for (const Item& item : items.items) {
    if (item.status != ItemStatus::done) continue;
    const Figure figure = read_figure(items, item).figure;
    for (const FigureRun& run : figure.runs) {
      const std::pair here{std::filesystem::weakly_canonical(scene_file(figure, run)), run.set};
      EXPECT_EQ(known.emplace(run.name, here).first->second, here) << item.number << ": " << run.name;
    }
  }
}

TEST(PaperItems, UseEveryFunctionOfAnExperiment) {
  const Items items = read_items(BAKE_SOURCE_DIR);
  for (const ComputedItem& computed : computed_items()) EXPECT_NO_THROW(find_item(items, computed.experiment)) << computed.experiment;
}

}  // namespace
}  // namespace bake
