// SPDX-License-Identifier: MIT
#include "experiments/make/figure_file.h"

#include <gtest/gtest.h>

#include "solver/core/errors.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

constexpr const char* k_figure = R"(title = "Loaves"
shows = "they rise"
[[run]]
name = "plain"
scene = "loaf"
[[run]]
name = "slit"
scene = "fig15_bread/loaf"
set = "oven.temperature_C=90"
mesh = true
[[surface]]
name = "torn"
run = "slit"
reference_time_s = 20
times_s = [20, 30]
[[picture]]
name = "both"
shows = "both loaves"
view = "side"
of = ["slit.skin", "plain", "torn"]
[[chart]]
name = "volume"
shows = "volume over time"
column = "volume_m3"
of = ["plain", "slit"]
[[chart]]
name = "set"
shows = "what has set over time"
metric = "heated_share"
temperature_C = 60
of = ["slit"]
[[claim]]
metric = "distance_gain"
of = "slit"
from_m = [0, 0, 0]
to_m = [1, 0, 0]
greater_than = "plain"
factor = 1.5
kind = "published"
why = "slits open"
[[claim]]
metric = "pieces"
of = "torn"
expected = 2
tolerance = 0
kind = "published"
why = "it is torn in two"
)";

class FigureFile : public testing::Test {
 protected:
  FigureFile() {
    std::filesystem::create_directories(folder_ / "fig15_bread/views");
    std::ofstream(folder_ / "fig15_bread/loaf.toml");
    std::ofstream(folder_ / "fig15_bread/views/side.toml");
  }
  Figure read(const std::string& text, const ComputedNames& computed = {}) const {
    std::ofstream(folder_ / "fig15_bread/figure.toml") << text;
    return read_figure(folder_ / "fig15_bread/figure.toml", computed);
  }
  std::string error_of(const std::string& from, const std::string& to) const {
    std::string text = k_figure;
    text.replace(text.find(from), from.size(), to);
    const std::string line = message_of<InputError>([&] { read(text); });
    return line.substr(line.find("figure.toml"));
  }
  const TemporaryFolder folder_;
};

TEST_F(FigureFile, IsReadWhole) {
  const Figure figure = read(k_figure);
  ASSERT_EQ(figure.runs.size(), 2u);
  EXPECT_EQ(figure.runs[1].set, std::vector<std::string>{"oven.temperature_C=90"});
  EXPECT_TRUE(figure.runs[1].mesh);
  EXPECT_EQ(scene_file(figure, figure.runs[0]), scene_file(figure, figure.runs[1]));
  ASSERT_EQ(figure.surfaces.size(), 1u);
  EXPECT_EQ(figure.surfaces[0].times_s, (std::vector<double>{20, 30}));
  ASSERT_EQ(figure.charts.size(), 2u);
  EXPECT_EQ(figure.charts[1].metric, "heated_share");
  EXPECT_EQ(figure.charts[1].place.temperature_C, 60);
  ASSERT_EQ(figure.claims.size(), 2u);
  EXPECT_EQ(figure.claims[0].factor, 1.5);
  EXPECT_EQ(figure.claims[0].place.to_m, (Vector3{1, 0, 0}));
  EXPECT_EQ(figure.claims[1].of, std::vector<std::string>{"torn"});
}

TEST_F(FigureFile, RefusesNamesOfNothing) {
  EXPECT_EQ(error_of("\"loaf\"", "\"laof\"").substr(0, 47), "figure.toml:5: run.0.scene: found 'laof', allow");
  EXPECT_EQ(error_of("run = \"slit\"", "run = \"slot\""), "figure.toml:13: surface.0.run: unknown run 'slot'; did you mean 'slit'?");
  EXPECT_EQ(error_of("run = \"slit\"", "run = \"plain\""), "figure.toml:13: surface.0.run: found 'plain', allowed: a run with mesh = true");
  EXPECT_EQ(error_of("\"side\"", "\"seite\"").substr(0, 46), "figure.toml:19: picture.0.view: found 'seite',");
  EXPECT_TRUE(
      error_of("\"slit.skin\"", "\"torn.skin\"").starts_with("figure.toml:20: picture.0.of: unknown run, surface or skin 'torn.skin'; "))
      << "a surface has no skins";
  EXPECT_EQ(error_of("\"torn\"]", "\"tron\"]"), "figure.toml:20: picture.0.of: unknown run, surface or skin 'tron'; did you mean 'torn'?");
  EXPECT_EQ(error_of("\"slit\"]", "\"torn\"]"), "figure.toml:25: chart.0.of: unknown run 'torn'; allowed: plain, slit");
  EXPECT_EQ(error_of("distance_gain", "distance_gian"),
            "figure.toml:33: claim.0.metric: unknown metric 'distance_gian'; did you mean 'distance_gain'?");
  EXPECT_EQ(error_of("greater_than = \"plain\"", "greater_than = \"plan\""),
            "figure.toml:37: claim.0.greater_than: unknown run or surface 'plan'; did you mean 'plain'?");
  EXPECT_EQ(error_of("name = \"slit\"", "name = \"plain\""), "figure.toml:7: run.1.name: found 'plain' again");
  EXPECT_EQ(error_of("name = \"slit\"", "name = \"../slit\""), "figure.toml:7: run.1.name: found '../slit', allowed: a-z, 0-9 and _");
}

TEST_F(FigureFile, HasObjectsOfRunsWithAPictureThatStandsForThem) {
  const std::string before = k_figure;
  const auto with = [&](const std::string& lines) { return before + "[[object]]\nname = \"turning\"\nshows = \"both loaves\"\n" + lines; };
  const Figure figure = read(with("view = \"side\"\npicture = \"both\"\nof = [\"slit\", \"plain\"]\n").c_str());
  ASSERT_EQ(figure.objects.size(), 1u);
  EXPECT_EQ(figure.objects[0].of, (std::vector<std::string>{"slit", "plain"}));
  EXPECT_FALSE(figure.objects[0].particles);
  EXPECT_EQ(figure.objects[0].from_s, 0);
  EXPECT_THROW(read(with("view = \"side\"\npicture = \"none\"\nof = \"slit\"\n").c_str()), InputError);
  EXPECT_THROW(read(with("view = \"none\"\npicture = \"both\"\nof = \"slit\"\n").c_str()), InputError);
  EXPECT_THROW(read(with("view = \"side\"\npicture = \"both\"\nof = \"torn\"\n").c_str()), InputError) << "a surface is no run";
  EXPECT_THROW(read(with("view = \"side\"\npicture = \"both\"\nof = []\n").c_str()), InputError);
}

TEST_F(FigureFile, HasMontagesOfItsPictures) {
  const std::string before = k_figure;
  const auto with = [&](const std::string& rows) {
    return before + "[[montage]]\nname = \"all\"\nshows = \"s\"\ncell_width_px = 64\ncell_height_px = 48\nrows = " + rows + "\n";
  };
  EXPECT_EQ(read(with("[\"both\", \"both\"]")).montages.at(0).rows.size(), 2u);
  const auto error = [&](const std::string& rows) { return message_of<InputError>([&] { read(with(rows)); }); };
  EXPECT_NE(error("\"both bohth\"").find("montage.0.rows: unknown picture 'bohth'; did you mean 'both'?"), std::string::npos);
  EXPECT_NE(error("[\"both both\", \"both\"]").find("montage.0.rows: found rows of 2 and 1 cells"), std::string::npos);
  EXPECT_NE(error("\"both\"\n[[montage]]\nname = \"both\"\nshows = \"s\"\ncell_width_px = 64\ncell_height_px = 48\nrows = \"both\"")
                .find("montage.1.name: found 'both' again"),
            std::string::npos)
      << "its file would be that of the picture";
}

/// A figure with one picture, of what `of` names in the loaves' figure.
std::string showing(const std::string& of, const std::string& metric = "tile_claims_hold") {
  return "title = \"Tiles\"\nshows = \"s\"\n[[picture]]\nname = \"tile\"\nshows = \"s\"\nfigure = \"loaves\"\nview = \"side\"\nof = " + of +
         "\n[[claim]]\nmetric = \"" + metric + "\"\nat_least = 1\nkind = \"published\"\nwhy = \"w\"\n";
}

TEST_F(FigureFile, ShowsRunsOfAnotherFigureWithWhatIsClaimedOfThem) {
  ComputedNames names;
  std::string more;
  names.other = [&](const std::string& item) {
    if (item != "loaves") throw InputError("unknown figure '" + item + "'");
    return FigureFile::read(k_figure + more);
  };
  const auto shown = [&](const std::string& of) { return *read(showing(of), names).pictures.at(0).part; };
  const Figure plain = shown("\"plain\"");
  EXPECT_EQ(plain.runs.size(), 1u) << "nothing is claimed of it but that another is greater";
  EXPECT_EQ(plain.claims.size(), 0u);
  const Figure slit = shown("[\"slit.skin\"]");
  EXPECT_EQ(slit.runs.size(), 2u) << "the plain one is compared with";
  EXPECT_EQ(slit.surfaces.size(), 1u);
  EXPECT_EQ(slit.claims.size(), 2u) << "of the run and of its surface";
  EXPECT_TRUE(slit.pictures.empty());

  more = "[[claim]]\nmetric = \"volume_gain\"\nof = [\"plain\", \"slit\"]\nat_least = 1\nkind = \"published\"\nwhy = \"w\"\n";
  EXPECT_EQ(shown("\"plain\"").claims.at(0).of, std::vector<std::string>{"plain"}) << "each is judged by itself";
  EXPECT_EQ(shown("\"plain\"").runs.size(), 1u);
  more.replace(more.find("at_least = 1"), 12, "order = \"rising\"");
  EXPECT_EQ(shown("\"plain\"").claims.at(0).of.size(), 2u) << "an order needs both";
  EXPECT_EQ(shown("\"plain\"").runs.size(), 2u);

  const auto error = [&](const std::string& text) { return message_of<InputError>([&] { read(text, names); }); };
  EXPECT_NE(error(showing("\"plan\"")).find("picture.0.of: unknown run, surface or skin 'plan'; did you mean 'plain'?"), std::string::npos);
  EXPECT_NE(error(showing("\"plain\"", "tile_claims")).find("unknown number 'tile_claims'; did you mean 'tile_claims_hold'?"),
            std::string::npos);
  std::string other = showing("\"plain\"");
  other.replace(other.find("loaves"), 6, "leaves");
  EXPECT_NE(error(other).find("figure.toml:6: picture.0.figure: unknown figure 'leaves'"), std::string::npos);
  EXPECT_NE(message_of<InputError>([&] { read(showing("\"plain\"")); }).find("picture.0.figure: allowed: in the figure.toml of an item"),
            std::string::npos);
}

TEST_F(FigureFile, RefusesClaimsThatCannotBeMeasured) {
  EXPECT_EQ(error_of("metric = \"pieces\"\nof = \"torn\"", "metric = \"pieces\"\nof = \"slit\""),
            "figure.toml:43: claim.1.of: found 'slit', a run, allowed: a surface, of which pieces is measured");
  EXPECT_EQ(error_of("from_m = [0, 0, 0]\n", ""),
            "figure.toml:32: claim.0.from_m: missing, allowed: what distance_gain needs: from_m, to_m");
  EXPECT_EQ(error_of("from_m = [0, 0, 0]", "from_m = [0, 0, 0]\nradius_m = 1"),
            "figure.toml:36: claim.0.radius_m: 'distance_gain' knows no such key");
  EXPECT_EQ(
      error_of("of = \"slit\"\n", ""),
      "figure.toml:33: claim.0.metric: unknown number 'distance_gain'; a metric needs `of`: the run or surface that it is measured of");
}

TEST_F(FigureFile, RefusesChartsOfWhatHasNoTimes) {
  EXPECT_EQ(error_of("metric = \"heated_share\"", "column = \"volume_m3\"\nmetric = \"heated_share\""),
            "figure.toml:29: chart.1.column: allowed: column or metric, with `of`, or a name alone");
  EXPECT_EQ(error_of("metric = \"heated_share\"", "metric = \"hated_share\""),
            "figure.toml:29: chart.1.metric: unknown metric of a run that has a time 'hated_share'; did you mean 'heated_share'?");
  EXPECT_EQ(error_of("temperature_C = 60\n", ""),
            "figure.toml:26: chart.1.temperature_C: missing, allowed: what heated_share needs: temperature_C");
  EXPECT_EQ(error_of("temperature_C = 60", "temperature_C = 60\ntime_s = 2"),
            "figure.toml:31: chart.1.time_s: the chart is drawn over all times");
}

/// Points over time that the chart of what has set draws and a claim is held to.
const char* const k_measured = R"(
[[measured]]
name = "dried"
source = "a paper"
reading = "from its table"
times_s = [0, 10, 20]
values = [1, 0.8, 0.7]
[[claim]]
metric = "water_left"
of = "plain"
measured = "dried"
at_most = 0.03
kind = "measured"
why = "the scatter of the paper"
)";

TEST_F(FigureFile, HasMeasuredPointsThatClaimsAndChartsName) {
  std::string text = std::string(k_figure) + k_measured;
  const std::string of_slit = "temperature_C = 60\nof = [\"slit\"]";
  text.replace(text.find(of_slit), of_slit.size(), of_slit + "\nmeasured = [\"dried\"]");
  const Figure figure = read(text);
  ASSERT_EQ(figure.measured.size(), 1);
  EXPECT_EQ(figure.measured[0].values, (std::vector{1., 0.8, 0.7}));
  EXPECT_EQ(figure.charts[1].measured, std::vector<std::string>{"dried"});
  EXPECT_EQ(figure.claims.back().measured, "dried");
}

TEST_F(FigureFile, RefusesMeasuredPointsThatCannotBeCompared) {
  const auto error = [&](const std::string& from, const std::string& to) {
    std::string text = std::string(k_figure) + k_measured;
    text.replace(text.find(from), from.size(), to);
    const std::string line = message_of<InputError>([&] { read(text); });
    return line.substr(line.find(": ") + 2);
  };
  EXPECT_EQ(error("times_s = [0, 10, 20]", "times_s = [0, 20, 20]"), "measured.0.times_s: allowed: rising times");
  EXPECT_EQ(error("values = [1, 0.8, 0.7]", "values = [1, 0.8]"), "measured.0.values: found 2, allowed: as many as times_s, 3");
  EXPECT_EQ(error("source = \"a paper\"", "source = \"\""), "measured.0.source: found \"\", allowed: words");
  EXPECT_EQ(error("measured = \"dried\"", "measured = \"dry\""), "claim.2.measured: unknown [[measured]] 'dry'; allowed: dried");
  EXPECT_EQ(error("metric = \"water_left\"", "metric = \"volume_gain\""),
            "claim.2.measured: found 'dried' for volume_gain, allowed: for a metric of a run that has a time");
  EXPECT_EQ(error("at_most = 0.03", "at_least = 0"), "claim.2.at_least: found 0, allowed: above 0: no water_left is below it");
  EXPECT_EQ(error("column = \"volume_m3\"", "column = \"volume_m3\"\nmeasured = [\"dried\"]"),
            "chart.0.measured: allowed: beside a metric over time, at most as many as runs");
}

TEST_F(FigureFile, RefusesChartsOfOneMetricAgainstNone) {
  const std::string over_time = "metric = \"heated_share\"\ntemperature_C = 60";
  std::string text = k_figure;
  text.replace(text.find(over_time), over_time.size(), "metric = \"height\"\nagainst = \"diameter\"");
  EXPECT_EQ(read(text).charts[1].against, "diameter");
  EXPECT_EQ(error_of("column = \"volume_m3\"", "column = \"volume_m3\"\nagainst = \"diameter\""),
            "figure.toml:25: chart.0.against: needs a metric beside it");
  EXPECT_EQ(error_of(over_time, "metric = \"height\"\nagainst = \"diametre\""),
            "figure.toml:30: chart.1.against: unknown metric of a run 'diametre'; did you mean 'diameter'?");
  EXPECT_EQ(error_of(over_time, "metric = \"height\"\nagainst = \"diameter\"\ntime_s = 1"),
            "figure.toml:31: chart.1.time_s: the chart shows the end");
}

TEST_F(FigureFile, RefusesClaimsWithoutOneCondition) {
  const std::string one = "allowed: one condition: expected with tolerance; at_least, at_most or both; greater_than; or order";
  EXPECT_EQ(error_of("greater_than = \"plain\"\nfactor = 1.5\n", ""), "figure.toml:32: claim.0: " + one);
  EXPECT_EQ(error_of("expected = 2", "at_least = 2\nexpected = 2"), "figure.toml:41: claim.1: " + one);
  EXPECT_EQ(error_of("tolerance = 0\n", ""), "figure.toml:44: claim.1.expected: needs a tolerance beside it, and a tolerance needs it");
  EXPECT_EQ(error_of("greater_than = \"plain\"\nfactor = 1.5\n", "order = \"rising\"\n"),
            "figure.toml:37: claim.0.order: needs a list `of` at least two");
  EXPECT_EQ(error_of("kind = \"published\"\nwhy = \"slits open\"", "kind = \"published\"\nwhy = \"\""),
            "figure.toml:40: claim.0.why: found \"\", allowed: the reason");
  EXPECT_EQ(error_of("expected = 2\ntolerance = 0\nkind = \"published\"", "at_least = 2\nkind = \"regression\""),
            "figure.toml:45: claim.1.kind: found a regression without an expected value");
  EXPECT_EQ(error_of("tolerance = 0\nkind = \"published\"", "tolerance = 0\nkind = \"regression\""),
            "figure.toml:46: claim.1.kind: found a regression without the quality that it holds for");
}

TEST_F(FigureFile, RefusesClaimsThatCannotBeMissed) {
  EXPECT_EQ(error_of("of = \"slit\"\nfrom_m", "of = []\nfrom_m"),
            "figure.toml:34: claim.0.of: found [], allowed: a run or surface, or a list of them");
  EXPECT_EQ(error_of("of = \"slit\"\nfrom_m", "of = [\"slit\", \"slit\"]\nfrom_m"),
            "figure.toml:34: claim.0.of: found 'slit' again, allowed: each once");
  EXPECT_EQ(error_of("greater_than = \"plain\"\nfactor = 1.5", "greater_than = \"slit\"\nfactor = 0.5"),
            "figure.toml:37: claim.0.greater_than: found 'slit', which is measured itself, allowed: another");
  EXPECT_EQ(error_of("greater_than = \"plain\"\nfactor = 1.5", "at_least = 0"),
            "figure.toml:37: claim.0.at_least: found 0, allowed: above 0: no distance_gain is below it");
  EXPECT_EQ(error_of("greater_than = \"plain\"\nfactor = 1.5", "at_least = inf"),
            "figure.toml:37: claim.0.at_least: found inf, allowed: any finite number");
  EXPECT_EQ(error_of("greater_than = \"plain\"\nfactor = 1.5", "at_most = inf"),
            "figure.toml:37: claim.0.at_most: found inf, allowed: any finite number");
  EXPECT_EQ(error_of("greater_than = \"plain\"\nfactor = 1.5", "expected = 1\ntolerance = inf"),
            "figure.toml:38: claim.0.tolerance: found inf, allowed: a number of at least 0");
  EXPECT_EQ(
      error_of("metric = \"pieces\"\nof = \"torn\"\nexpected = 2\ntolerance = 0", "metric = \"two_pieces\"\nof = \"torn\"\nat_most = 1"),
      "figure.toml:44: claim.1.at_most: found 1, allowed: below 1: no two_pieces is above it");
  EXPECT_EQ(error_of("metric = \"pieces\"\nof = \"torn\"\nexpected = 2\ntolerance = 0",
                     "metric = \"two_pieces\"\nof = \"torn\"\nexpected = 0.5\ntolerance = 0.5"),
            "figure.toml:45: claim.1.tolerance: found 0.5, allowed: less: every two_pieces is within it");
}

TEST_F(FigureFile, RefusesClaimsOfAnEmptyBox) {
  EXPECT_EQ(error_of("metric = \"distance_gain\"\nof = \"slit\"\nfrom_m = [0, 0, 0]\nto_m = [1, 0, 0]",
                     "metric = \"share_in_box\"\nof = \"slit\"\nlow_m = [0, 0, 0]\nhigh_m = [1, 0, 2]"),
            "figure.toml:36: claim.0.high_m: found 0 along y, allowed: above low_m, 0");
}

TEST_F(FigureFile, RefusesClaimsOfASurfaceBeforeAnythingCanBreak) {
  EXPECT_EQ(error_of("of = \"torn\"\nexpected", "of = \"torn\"\ntime_s = 25\nexpected"),
            "figure.toml:44: claim.1.time_s: found 25, allowed: a time of surface 'torn': 20, 30");
  EXPECT_EQ(
      error_of("of = \"torn\"\nexpected", "of = \"torn\"\ntime_s = 20\nexpected"),
      "figure.toml:44: claim.1.time_s: found surface 'torn' at 20 s, allowed: after its reference time, 20 s, at which nothing is broken");
  EXPECT_EQ(
      error_of("times_s = [20, 30]", "times_s = [20]"),
      "figure.toml:43: claim.1.of: found surface 'torn' at 20 s, allowed: after its reference time, 20 s, at which nothing is broken");
}

TEST_F(FigureFile, RefusesBoundsOfAComputedNumberThatItCannotMiss) {
  const std::string text =
      "title = \"Curves\"\nshows = \"s\"\n[[claim]]\nmetric = \"viscosity\"\nat_least = 0\nkind = \"analytic\"\nwhy = \"w\"\n";
  EXPECT_EQ(read(text, {{}, {{"viscosity"}}}).claims.size(), 1u) << "it may be negative for all that is known";
  const std::string line = message_of<InputError>([&] { read(text, {{}, {{"viscosity", non_negative}}}); });
  EXPECT_EQ(line.substr(line.find("figure.toml")), "figure.toml:5: claim.0.at_least: found 0, allowed: above 0: no viscosity is below it");
}

TEST_F(FigureFile, RefersToWhatTheItemsFunctionGives) {
  const std::string text =
      "title = \"Curves\"\nshows = \"s\"\n[[chart]]\nname = \"curve\"\nshows = \"s\"\n[[claim]]\nmetric = \"distance\"\nat_most = 1\n"
      "kind = \"analytic\"\nwhy = \"w\"\n";
  EXPECT_EQ(read(text, {{"curve"}, {{"distance"}}}).claims.size(), 1u);
  EXPECT_THROW(read(text, {{"curve"}, {{"distances"}}}), InputError);
  const std::string of_another = message_of<InputError>([&] {
    read(std::string(text).replace(text.find("at_most = 1"), 11, "greater_than = \"other\""), {{"curve"}, {{"distance"}}});
  });
  EXPECT_NE(of_another.find("claim.0.greater_than: needs `of`"), std::string::npos) << of_another;
  EXPECT_THROW(read(text, {{"curves"}, {{"distance"}}}), InputError);
}

TEST_F(FigureFile, ClaimsSomething) { EXPECT_THROW(read("title = \"Curves\"\nshows = \"s\"\n"), InputError); }

}  // namespace
}  // namespace bake
