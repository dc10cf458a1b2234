// SPDX-License-Identifier: MIT
#include "analysis/charts/chart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "analysis/charts/labels.h"
#include "analysis/charts/text.h"
#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace bake::charts {
namespace {

Chart a_chart() {
  Chart chart;
  chart.name = "sample";
  chart.title = "A sample, with \"quotes\" & <brackets>";
  Panel one{"(a) first_panel", {"pressure $p$", "Pa"}, {"yield stress $τ_y$", "Pa"}};
  one.series.push_back({"$n$ = 0.1", Kind::line, {0, 1, 2}, {4, 5, NAN}});
  one.series.push_back({"measured", Kind::error_bars, {0, 2}, {3, 4}, {2, 3.5}, {4, 4.5}});
  one.series.push_back({"range", Kind::band, {0, 2}, {}, {1, 1}, {2, 3}});
  one.series.push_back({"paths", Kind::arrows, {0}, {1}, {}, {}, {2}, {3}});
  one.marks.push_back({1, 5, "peak $θ_r$", Side::above});
  one.rules.push_back({true, 0.5, "$θ_1$"});
  one.legend = Legend::top_left;
  Panel two{"(b) second", {"time", "s", Scale::logarithmic}, {"error", "", Scale::logarithmic}};
  two.heat_map = HeatMap{{1, 10, 100}, {1, 10}, {0.5, NAN}, {"heat $q$", "W/m$^2$"}};
  chart.panels = {one, two};
  return chart;
}

bool gnuplot_is_there() { return std::system("command -v gnuplot >/dev/null") == 0; }

TEST(ChartText, EscapesWhatGnuplotWouldTakeForMarkup) {
  EXPECT_EQ(gnuplot_text("bread_draft^2 {a} @b &c ~d \\e"), "'bread\\_draft\\^2 \\{a\\} \\@b \\&c \\~d \\\\e'");
  EXPECT_EQ(gnuplot_text("s'more\nhot"), "'s''more hot'");
}

TEST(ChartText, SetsMathematicsBetweenDollars) {
  EXPECT_EQ(gnuplot_text("stress $τ_y$ in Pa"), "'stress {/:Italic τ}_{{/:Italic y}} in Pa'");
  EXPECT_EQ(gnuplot_text("$p_{tr}^2$"), "'{/:Italic p}_{tr}^{2}'");
  EXPECT_EQ(gnuplot_text("$a-1$"), "'{/:Italic a}−1'") << "a minus, not a hyphen";
  EXPECT_EQ(gnuplot_text("5 $$"), "'5 $'");
  EXPECT_EQ(gnuplot_text("cost $5"), "'cost $5'");
  EXPECT_EQ(gnuplot_text("$x_{"), "'$x\\_\\{'") << "never closed: no mathematics";
}

TEST(ChartText, UnbalancedGroupsDoNotRunAway) {
  EXPECT_EQ(gnuplot_text("$x_$"), "'{/:Italic x}_{}'");
  EXPECT_NO_THROW(gnuplot_text("$x_{ab$"));
  EXPECT_NO_THROW(gnuplot_text("$}{$"));
  EXPECT_NO_THROW(gnuplot_text("$\xce$"));
}

TEST(ChartText, IsPlainWithoutItsMarkup) { EXPECT_EQ(plain_text("trial $p_{tr}$ [{a}]"), "trial p_tr [{a}]"); }

TEST(ChartCsv, HoldsEveryNumberUnderItsNameAndUnit) {
  const std::string csv = csv_of(a_chart());
  const std::string headings = csv.substr(0, csv.find('\n'));
  EXPECT_EQ(headings.substr(0, headings.find(",(a) first_panel: measured")),
            "(a) first_panel: n = 0.1: pressure p [Pa],(a) first_panel: n = 0.1: yield stress τ_y [Pa]");
  for (const char* heading : {"(a) first_panel: measured: yield stress τ_y low [Pa]", "(a) first_panel: range: yield stress τ_y high [Pa]",
                              "(a) first_panel: paths: pressure p end [Pa]", "(a) first_panel: marks: text",
                              "(b) second: heat map: time to [s]", "(b) second: heat map: heat q [W/m^2]"})
    EXPECT_NE(headings.find(heading), std::string::npos) << heading;
  const std::string rows = csv.substr(headings.size() + 1);
  EXPECT_EQ(rows.substr(0, rows.find('\n')), "0,4,0,3,2,4,0,1,2,0,1,2,3,peak θ_r,1,5,1,10,1,10,0.5");
  EXPECT_EQ(rows.substr(rows.find('\n') + 1, 10), "1,5,2,4,3.") << "second row";
}

TEST(ChartCsv, QuotesWhatHoldsACommaOrQuotes) {
  Chart chart = a_chart();
  chart.panels.resize(1);
  chart.panels[0].series.resize(1);
  chart.panels[0].series[0].name = "a, \"b\"";
  EXPECT_EQ(csv_of(chart).substr(0, 30), "\"a, \"\"b\"\": pressure p [Pa]\",\"a");
}

TEST(ChartColours, DifferAndStayBetweenTheEnds) {
  EXPECT_NE(palette(0), palette(1));
  EXPECT_EQ(palette(0), palette(6));
  EXPECT_EQ(ramp(-1), ramp(0));
  EXPECT_EQ(ramp(2), ramp(1));
  EXPECT_NE(ramp(0), ramp(1));
  EXPECT_EQ(ramp(0.5).size(), 7u);
}

Panel crowded(std::vector<Mark> marks) {
  Panel panel{"", {"x"}, {"y"}};
  panel.series.push_back({"points", Kind::points, {50, 58}, {50, 50}});
  panel.marks = std::move(marks);
  return panel;
}

std::vector<Side> sides_in_a_square(const Panel& panel) { return label_sides(panel, {0, 100}, {0, 100}, 200, 200, 8); }

TEST(ChartLabels, StandWhereTheyCoverNothing) {
  const auto sides = sides_in_a_square(crowded({{50, 50, "left one", Side::free}, {58, 50, "right one", Side::free}}));
  EXPECT_EQ(sides, (std::vector<Side>{Side::left, Side::right}));
}

TEST(ChartLabels, KeepOutOfEachOthersWayAndOfLines) {
  EXPECT_EQ(
      sides_in_a_square(crowded({{58, 50, "asked for", Side::right}, {50, 51, "to the left", Side::left}, {54, 50, "free", Side::free}})),
      (std::vector<Side>{Side::right, Side::left, Side::above}));
  Panel crossed = crowded({{50, 50, "upright only", Side::free}});
  crossed.series = {{"level", Kind::line, {0, 100}, {50, 50}}, {"upwards", Kind::line, {50, 50}, {50, 100}}};
  EXPECT_EQ(sides_in_a_square(crossed), std::vector<Side>{Side::below});
}

TEST(ChartLabels, StayOnThePanel) {
  EXPECT_EQ(sides_in_a_square(crowded({{98, 20, "at the end", Side::free}})), std::vector<Side>{Side::left});
  Panel decades = crowded({{900, 2, "at the end", Side::free}});
  decades.x.scale = Scale::logarithmic;
  EXPECT_EQ(label_sides(decades, {1, 1000}, {0, 100}, 200, 200, 8), std::vector<Side>{Side::left});
}

class AWrittenChart : public testing::Test {
 protected:
  template <class Error = std::invalid_argument>
  std::string error_of(const Chart& chart) const {
    return message_of<Error>([&] { write_chart(chart, folder_.path()); });
  }
  bool is_empty() const { return std::filesystem::is_empty(folder_.path()); }
  const TemporaryFolder folder_;
};

TEST_F(AWrittenChart, HasItsThreeFiles) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  write_chart(a_chart(), folder_.path() / "new" / "folder");
  const std::string svg = contents(folder_.path() / "new/folder/sample.svg");
  EXPECT_NE(svg.find("<title>A sample, with \"quotes\" &amp; &lt;brackets&gt;</title>"), std::string::npos);
  EXPECT_NE(svg.find("prefers-color-scheme: dark"), std::string::npos);
  EXPECT_NE(svg.find("first_panel"), std::string::npos) << "an underscore stays one";
  EXPECT_NE(svg.rfind("</svg>"), std::string::npos) << "whole";
  EXPECT_EQ(contents(folder_.path() / "new/folder/sample.pdf").substr(0, 5), "%PDF-");
  EXPECT_EQ(contents(folder_.path() / "new/folder/sample.csv"), csv_of(a_chart()));
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_.path() / "new/folder")) ++files;
  EXPECT_EQ(files, 3u) << "nothing else is left";
}

TEST_F(AWrittenChart, OfUnequalColumnsIsRefused) {
  Chart chart = a_chart();
  chart.panels[0].series[0].y.pop_back();
  EXPECT_EQ(error_of(chart), "chart sample: $n$ = 0.1: columns of unequal length");
  EXPECT_TRUE(is_empty());
}

TEST_F(AWrittenChart, WithNothingOnALogarithmicAxisIsRefused) {
  Chart chart = a_chart();
  chart.panels[0].y.scale = Scale::logarithmic;
  chart.panels[0].series[0].y[0] = 0;
  EXPECT_EQ(error_of(chart), "chart sample: $n$ = 0.1: 0 cannot stand on the logarithmic axis 'yield stress $τ_y$'");
  chart.panels[0].series.clear();
  EXPECT_EQ(error_of(chart), "chart sample: a panel has nothing to draw");
  chart.panels = {a_chart().panels[1]};
  chart.panels[0].heat_map->value.pop_back();
  EXPECT_EQ(error_of(chart), "chart sample: a heat map needs a value for each cell between its edges");
  EXPECT_TRUE(is_empty());
}

TEST_F(AWrittenChart, WithoutGnuplotSaysWhatToInstall) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder_.path().c_str(), 1);
  const std::string said = error_of<InputError>(a_chart());
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(said, "gnuplot is missing: apt-get install gnuplot-nox fonts-liberation");
  EXPECT_TRUE(is_empty());
}

TEST_F(AWrittenChart, ThatGnuplotRefusesRepeatsItsWords) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  Chart chart = a_chart();
  chart.panels[0].series[0].colour = "no colour'";
  const std::string said = error_of<OutputError>(chart);
  EXPECT_EQ(said.substr(0, 29), "sample: gnuplot failed: line ") << said;
  EXPECT_NE(said.find("color name"), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos);
  EXPECT_TRUE(is_empty());
}

TEST_F(AWrittenChart, IntoAFileInsteadOfAFolderIsRefused) {
  std::ofstream(folder_.path() / "file") << "x";
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_THROW(write_chart(a_chart(), folder_.path() / "file"), OutputError);
}

}  // namespace
}  // namespace bake::charts
