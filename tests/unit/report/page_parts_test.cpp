// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/report/html.h"
#include "experiments/report/statements.h"
#include "experiments/report/time_chart.h"
#include "solver/core/errors.h"
#include "tests/unit/io/files.h"

namespace bake::report {
namespace {

bool has(const Html& html, std::string_view words) { return html.code.find(words) != std::string::npos; }

TEST(Numbers, OfPeopleHaveSignsAndDoNotBreak) {
  EXPECT_EQ(number(5.551e-16), "5.551\u00a0×\u00a010⁻¹⁶");
  EXPECT_EQ(number(0.0231), "0.0231");
  EXPECT_EQ(number(620000), "620\u202f000");
  EXPECT_EQ(number(std::nan("")), "none");
  EXPECT_EQ(with_signs(">= 1.5"), "≥ 1.5");
  EXPECT_EQ(with_signs("1.7837 +- 1e-03"), "1.7837 ± 1\u00a0×\u00a010⁻³");
  EXPECT_EQ(with_signs("no number, one e-mail"), "no number, one e-mail");
}

TEST(Tables, PutColumnsOfNumbersAtTheRight) {
  const Html made = table({"name", "value", "mixed"}, {{text("a"), text("1.5"), text("2")}, {text("b"), text("-3 s"), text("none")}});
  EXPECT_TRUE(has(made, "data-head=\"value\" class=\"number\">1.5<"));
  EXPECT_TRUE(has(made, "data-head=\"mixed\" class=\"whole\">2<"));
  EXPECT_TRUE(has(made, "data-head=\"mixed\">none<"));
  EXPECT_TRUE(has(made, "data-head=\"name\">a<"));
}

TEST(Pictures, AreTheSmallOnesWhereThereAreAny) {
  const TemporaryFolder place;
  put(place / "a.png", "large");
  EXPECT_TRUE(has(picture(place / "a.png", "it"), "src=\"data:image/png;base64,bGFyZ2U=\""));
  put(place / "a.jpg", "small");
  EXPECT_TRUE(has(picture(place / "a.png", "it"), "src=\"data:image/jpeg;base64,c21hbGw=\""));
}

TEST(Statements, AreTheClaimsOfTheSameWords) {
  const nlohmann::json claims = nlohmann::json::parse(R"([
    {"metric": "volume_gain", "of": "bun_a", "why": "figure 1: a", "says": "it grows", "holds": true, "measured": 2, "unit": "1",
     "condition": ">= 1.2", "low": 1.2, "high": null, "kind": "published", "meaning": "m"},
    {"metric": "volume_gain", "of": "bun_b", "why": "figure 1: a", "says": "it grows", "holds": false, "measured": null, "unit": "1",
     "condition": ">= 1.2", "low": 1.2, "high": null, "kind": "published", "meaning": "m", "problem": "NaN at row 3"},
    {"metric": "height", "of": "", "why": "it <is> high", "holds": true, "measured": 1e-6, "unit": "m", "condition": "<= 2e-06",
     "low": null, "high": 2e-6, "kind": "analytic", "meaning": "m"}])");
  const std::vector<Statement> statements = statements_of(claims);
  ASSERT_EQ(statements.size(), 2u);
  EXPECT_EQ(statements[0].claims.size(), 2u);
  EXPECT_TRUE(statements[0].is_quoted && !statements[0].holds());
  EXPECT_TRUE(!statements[1].is_quoted && statements[1].holds());
  const Html made = cards(statements, "figure-1");
  for (const char* words :
       {"“it grows”", "✗ missed", "✓ holds", "id=\"figure-1-1-volume-gain\"", ">a</span>", ">b</span>", "NaN at row 3",
        "it &lt;is&gt; high", "1\u00a0×\u00a010⁻⁶\u00a0m", "≤ 2\u00a0×\u00a010⁻⁶", "Evidence: analytic.", "figure 1: a"})
    EXPECT_TRUE(has(made, words)) << words;
  // the bar of 2 is met beyond its bound at 1.2, on a scale to 2.24
  EXPECT_TRUE(has(made, "class=\"met\" x=\"0.0\" y=\"7\" width=\"178.6\""));
  EXPECT_TRUE(has(made, "class=\"bound\" x1=\"107.1\""));
}

TEST(Statements, BelowZeroHaveBarsToTheLeft) {
  nlohmann::json claim{{"metric", "lead"},    {"of", "x"}, {"why", "w"},      {"holds", false},      {"measured", -3}, {"unit", "K"},
                       {"condition", ">= 1"}, {"low", 1},  {"high", nullptr}, {"kind", "published"}, {"meaning", "m"}};
  const Html made = cards(statements_of(nlohmann::json::array({claim})), "figure-1");
  EXPECT_TRUE(has(made, "class=\"unmet\" x=\"19.4\" y=\"7\" width=\"121.0\"")) << made.code;  // of -3.48 to 1.48, up to zero
}

class TimeCharts : public testing::Test {
 protected:
  const TemporaryFolder place;
  std::optional<TimeChart> read(std::string_view csv) {
    put(place / "chart.csv", csv);
    return read_time_chart(place / "chart.csv");
  }
};

TEST_F(TimeCharts, AreReadFromTheirNumbers) {
  const auto chart = read("one <a>: time [s],one <a>: volume [m^3],two: time [s],two: volume [m^3]\n0,1,0,2\n1,1.5,1,\n,,2,4\n");
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->label, "volume");
  EXPECT_EQ(chart->unit, "m^3");
  ASSERT_EQ(chart->lines.size(), 2u);
  EXPECT_EQ(chart->lines[0].time_s, (std::vector<double>{0, 1}));
  EXPECT_EQ(chart->lines[1].time_s, (std::vector<double>{0, 1, 2}));
  EXPECT_TRUE(std::isnan(chart->lines[1].value[1]));
  const Html made = drawn(*chart, "what \"it\" shows", "figure-1-body");
  for (const char* words :
       {"aria-label=\"what &quot;it&quot; shows\"", "data-follows=\"figure-1-body\"", "volume [m^3]", "one &lt;a&gt;", "class=\"cursor\""})
    EXPECT_TRUE(has(made, words)) << words;
  EXPECT_FALSE(has(made, "nan")) << made.code;
  EXPECT_FALSE(has(drawn(*chart, "it", ""), "cursor"));
}

TEST_F(TimeCharts, AreNotMadeOfOtherCharts) {
  EXPECT_FALSE(read("a: temperature [C],a: heat [J]\n1,2\n"));
  EXPECT_FALSE(read("a: time [s],a: volume [m^3],b: time [s],b: height [m]\n1,2,3,4\n"));
  EXPECT_FALSE(read("a: time [s]\n1\n"));
  EXPECT_THROW(read_time_chart(place / "none.csv"), InputError);
}

TEST_F(TimeCharts, OfAConstantAndOfOneMomentAreFinite) {
  for (const char* csv : {"a: time [s],a: x\n0,5\n1,5\n", "a: time [s],a: x\n0,0\n", "a: time [s],a: x\n0,\n"}) {
    const auto chart = read(csv);
    ASSERT_TRUE(chart);
    const Html made = drawn(*chart, "it", "b");
    EXPECT_FALSE(has(made, "nan") || has(made, "inf")) << made.code;
  }
}

TEST(RoundNumbers, AreAboutFourFromLowToHigh) {
  EXPECT_EQ(round_numbers(0, 20), (std::vector<double>{0, 5, 10, 15, 20}));
  EXPECT_EQ(round_numbers(0, 1), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  for (const double high : {0.0031, 7.0, 99.0, 12345.0}) {
    const auto numbers = round_numbers(-high / 3, high);
    EXPECT_TRUE(numbers.size() >= 4 && numbers.size() <= 9) << high;
    EXPECT_TRUE(numbers.front() >= -high / 3 && numbers.back() <= high * (1 + 1e-12));
  }
}

TEST(Names, LoseWhatTheyHaveInCommon) {
  EXPECT_EQ(common_start({"bread_no_slit", "bread_one_slit"}), "bread_");
  EXPECT_EQ(common_start({"bread"}), "");
  EXPECT_EQ(common_start({"bread", "breadth"}), "");
  EXPECT_EQ(short_name("bread_no_slit", "bread_"), "no slit");
  EXPECT_EQ(short_name("bread", ""), "bread");
}

}  // namespace
}  // namespace bake::report
