// SPDX-License-Identifier: MIT
// Items that need no run: the tables tell equal from different. (That their claims hold is regression/figure_7 and the like.)
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "experiments/fig14_return_map/stress_state.h"
#include "experiments/fig15_bread/dough.h"
#include "experiments/make/computed.h"
#include "solver/core/errors.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

TEST(AFlowStep, LeavesAnElasticStressAsItIs) {
  const FlowStep step(bread_scene(), 0.3, 0.01);
  const Stress trial{{3, -2, 1, 4, -1, 2}};
  const Stress image = step.image(trial);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(image.at[i], trial.at[i], 1e-12);
}

TEST(AFlowStep, KnowsTheInvariantsOfAStress) {
  const Stress tau = uniaxial(3, 5);
  EXPECT_NEAR(pressure_of(tau), 3, 1e-14);
  EXPECT_NEAR(effective_of(tau), 5, 1e-14);
  EXPECT_NEAR(effective_of({{0, 0, 0, 0, 0, 2}}), 2 * std::sqrt(3.), 1e-14) << "simple shear: sqrt(3) times the shear stress";
}

double number(const Computed& computed, const std::string& name) { return find_named(computed.numbers, name)->value; }

/// A copy of the published parameters with bread's scene alone.
class TableTwo : public testing::Test {
 protected:
  TableTwo() {
    const fs::path sources = BAKE_SOURCE_DIR;
    fs::create_directories(root() / "reference/published");
    fs::create_directories(root() / "experiments/fig15_bread");
    for (const char* file :
         {"reference/published/table2.toml", "reference/published/table2_scenes.toml", "experiments/fig15_bread/bread.toml"})
      fs::copy_file(sources / file, root() / file);
  }
  fs::path root() const { return folder_.path(); }
  void replace(const char* file, std::string_view part, std::string_view other) const {
    std::string text = contents(root() / file);
    ASSERT_NE(text.find(part), std::string::npos) << part;
    text.replace(text.find(part), part.size(), other);
    std::ofstream(root() / file) << text;
  }
  void add_reason(const char* parameter) const {
    std::ofstream(root() / "reference/published/table2_scenes.toml", std::ios::app)
        << "\n[[reason]]\ncolumn = \"Bread\"\nparameter = \"" << parameter << "\"\nwhy = \"a test\"\n";
  }
  std::string cell(const Computed& computed, const char* parameter, std::size_t column) const {
    for (const auto& row : computed.tables[0].rows)
      if (row[0] == parameter) return row[column];
    return "no such row";
  }
  std::string error() const {
    return message_of<InputError>([&] { compare_parameters(root()); }).substr(root().string().size() + 1);
  }
  static constexpr const char* k_bread = "experiments/fig15_bread/bread.toml";
  static constexpr const char* k_ours = "reference/published/table2_scenes.toml";
  const TemporaryFolder folder_;
};

TEST_F(TableTwo, TellsWhatASceneStatesAndWhichSceneIsNotThere) {
  const Computed computed = compare_parameters(root());
  EXPECT_EQ(number(computed, "equal_values"), 15);
  EXPECT_EQ(number(computed, "unexplained_differences"), 0);
  EXPECT_EQ(cell(computed, "Young's", 1), "2e3 =");
  EXPECT_EQ(cell(computed, "Young's", 2), "4e4 (no scene)");
  EXPECT_EQ(cell(computed, "Δt", 1), "4e-3 (chosen)");
  EXPECT_EQ(cell(computed, "Ambient θ", 3), "N/A");
}

TEST_F(TableTwo, AnotherValueNeedsAReason) {
  replace(k_bread, "density_kg_per_m3 = 500", "density_kg_per_m3 = 450");
  Computed computed = compare_parameters(root());
  EXPECT_EQ(number(computed, "unexplained_differences"), 1);
  EXPECT_EQ(cell(computed, "Density", 1), "450 (paper 500) !");
  add_reason("Density");
  computed = compare_parameters(root());
  EXPECT_EQ(number(computed, "unexplained_differences"), 0);
  EXPECT_EQ(number(computed, "explained_differences"), 1);
  EXPECT_EQ(cell(computed, "Density", 1), "450 (paper 500) [1]");
  EXPECT_EQ(computed.tables[1].rows.back(), (std::vector<std::string>{"[1]", "Bread, Density: a test", ""}));
}

TEST_F(TableTwo, AReasonWithoutADifferenceIsCounted) {
  const double before = number(compare_parameters(root()), "stale_reasons");  // those of scenes that are not in this folder
  add_reason("Density");
  EXPECT_EQ(number(compare_parameters(root()), "stale_reasons"), before + 1);
}

TEST_F(TableTwo, ACurveThatChangesStatesNoOneValue) {
  replace(k_bread, "temperature_C = 100 # Table 2", "temperature_C = [[0, 100], [10, 120]]");
  EXPECT_EQ(cell(compare_parameters(root()), "Ambient θ", 1), "not one value (paper 100) !");
}

TEST_F(TableTwo, AWrongNameIsRefused) {
  add_reason("Densty");
  EXPECT_EQ(error(), std::string(k_ours) + ": reason: found Bread, Densty, allowed: a column and a row of the table");
  replace(k_ours, "Densty", "Density");
  replace(k_ours, "name = \"κ\"", "name = \"kappa\"");
  EXPECT_EQ(error(), std::string(k_ours) + ": no [[row]] 'κ'");
  replace("reference/published/table2.toml", ", \"150\"]", "]");
  EXPECT_EQ(error(), "reference/published/table2.toml: κ: found 5 values, allowed: one for each of the 6 columns");
}

/// The project as the table sees it, in `root`, without the runs that are stored beside the table.
void link_project(const fs::path& root) {
  fs::create_directories(root / "experiments/table01_timings/measured");
  fs::create_symlink(fs::path(BAKE_SOURCE_DIR) / "reference", root / "reference");
  for (const auto& experiment : fs::directory_iterator(fs::path(BAKE_SOURCE_DIR) / "experiments"))
    if (experiment.path().filename() != "table01_timings")
      fs::create_symlink(experiment.path(), root / "experiments" / experiment.path().filename());
}

TEST(TableOne, PutsAFinishedRunBesideThePublishedTiming) {
  const TemporaryFolder folder, root;
  link_project(root.path());
  const Computed none = compare_timings(root.path(), folder / "nothing");
  EXPECT_EQ(number(none, "rows_with_a_run"), 0);
  EXPECT_EQ(none.tables[0].rows[0][5], "not run");
  for (const auto& [name, state, particles] : {std::tuple{"bread-draft", "done", 9000}, std::tuple{"bread-standard", "done", 77000},
                                               std::tuple{"bread-paper", "running", 620000}}) {
    fs::create_directories(folder / name);
    std::ofstream(folder / name / "run.json")
        << R"({"scene": {"file": "experiments/fig15_bread/bread.toml"}, "provenance": {"threads": 2, "machine": {"cpu": "abacus"}},
              "summary": {"wall_s": 96, "time_s": 2, "particle_steps": 96e6, "peak_memory_bytes": 5e6,
                          "load_average": 0.5, "particles": )"
        << particles << R"(, "state": ")" << state << "\"}}";
  }
  const Computed some = compare_timings(root.path(), folder.path());
  EXPECT_EQ(number(some, "rows_with_a_run"), 1);
  EXPECT_EQ(number(some, "rows_at_published_size"), 0) << "that run is not done";
  const auto& row = some.tables[0].rows[0];
  EXPECT_EQ(std::vector<std::string>(row.begin() + 5, row.end()),
            (std::vector<std::string>{"bread-standard", "77K", "first 2 s", "2", "1", "5 MB", "abacus, 2 threads, load 0.5"}))
      << "two seconds are 48 frames";
  EXPECT_EQ(some.tables[0].rows[2][5], "not run") << "the cookie has a scene";
  const bool has_pancake = fs::exists(fs::path(BAKE_SOURCE_DIR) / "experiments/fig11_pancake/pancake.toml");
  EXPECT_EQ(some.tables[0].rows[3][5], has_pancake ? "not run" : "no scene yet");
  fs::copy(folder / "bread-standard/run.json", root / "experiments/table01_timings/measured/kept.json");
  EXPECT_EQ(number(compare_timings(root.path(), folder / "nothing"), "rows_with_a_run"), 1) << "a row that was kept";
}

TEST(AComputedTable, IsWrittenForTerminalProgramsAndPages) {
  const ComputedTable table{"t", "Title", {"name", "θ"}, {{"a|b", "1, 2"}, {"\"c\"", ""}}};
  EXPECT_EQ(text_of(table), "Title\n  name  θ\n  a|b   1, 2\n  \"c\"\n");
  EXPECT_EQ(csv_of(table), "name,θ\na|b,\"1, 2\"\n\"\"\"c\"\"\",\n");
  EXPECT_EQ(markdown_of(table), "Title\n\n| name | θ |\n|---|---|\n| a\\|b | 1, 2 |\n| \"c\" |  |\n");
}

}  // namespace
}  // namespace bake
