// SPDX-License-Identifier: MIT
// The report as a user makes it: complete, in one file, without a link to anywhere, and safe against what stands in its sources.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <regex>

#include "tests/cli/program.h"

namespace bake::test {
namespace {

namespace fs = std::filesystem;

class AReport : public testing::Test {
 protected:
  AReport() {
    place.write("paper/items.toml", R"([[item]]
number = "figure 1"
name = "dough"
shows = "dough <at> rest & \"quiet\""
experiment = "fig01_dough"
status = "done"
[[item]]
number = "figure 2"
name = "pie"
shows = "a pie"
status = "not there yet"
claims = ["its <crust> is hard"]
)");
    place.write("experiments/fig01_dough/figure.toml", R"(title = "Dough <b>at</b> rest"
shows = "it rests & 'waits'"
[[run]]
name = "soft"
scene = "dough"
[[chart]]
name = "height"
shows = "the \"height\" <over> time"
column = "height_m"
of = "soft"
[[claim]]
metric = "volume_gain"
of = "soft"
at_least = 0.5
kind = "analytic"
why = "0.5 < 1 & so on"
)");
  }
  std::string page() const { return contents(place.folder() / "report.html"); }
  bool page_has(const std::string& words) const { return page().find(words) != std::string::npos; }
  const Workplace place;
};

TEST_F(AReport, ShowsWhatEffectsCostAndChange) {
  place.write("paper/effects.json", R"({"points": [{"scene": "bun <1>", "effects": "water", "added_cpu_ns": 12.34, "run_cpu_share": 0.25,
"largest_change_over_error": 17, "of": "water lost"}], "provenance": {"date": "2019-07-01T00:00:00Z", "program": {"commit": "0123456789ab"},
"machine": {"cpu": "Abacus"}}})");
  ASSERT_EQ(place.bake("report").exit_code, 0);
  for (const char* words : {"What each effect costs", "bun &lt;1&gt;", "12.3", "25 %", "water lost", "Abacus"})
    EXPECT_TRUE(page_has(words)) << words;
}

TEST_F(AReport, ShowsWhatWasMadeAndWhatWasNot) {
  EXPECT_EQ(place.bake("report").out, "report.html: 0 reproduced, 0 not reproduced, 1 not run, 1 not there yet\n");
  EXPECT_TRUE(page_has("./bake figure dough"));
  ASSERT_EQ(place.bake("figure 1 --quiet").exit_code, 0);
  EXPECT_EQ(place.bake("report").out, "report.html: 1 reproduced, 0 not reproduced, 0 not run, 1 not there yet\n");
  EXPECT_TRUE(page_has("volume gain"));
  EXPECT_TRUE(page_has("<svg class=\"plot\""));
  EXPECT_TRUE(page_has("download=\"height.csv\" href=\"data:text/csv;base64,"));
  place.write("experiments/fig01_dough/figure.toml", std::regex_replace(contents(place.folder() / "experiments/fig01_dough/figure.toml"),
                                                                        std::regex("at_least = 0.5"), "at_least = 5"));
  ASSERT_EQ(place.bake("figure 1 --quiet").exit_code, 1);
  EXPECT_EQ(place.bake("report").out, "report.html: 0 reproduced, 1 not reproduced, 0 not run, 1 not there yet\n");
}

TEST_F(AReport, EscapesEveryText) {
  ASSERT_EQ(place.bake("figure 1 --quiet").exit_code, 0);
  ASSERT_EQ(place.bake("report").exit_code, 0);
  for (const char* words :
       {"Dough &lt;b&gt;at&lt;/b&gt; rest", "it rests &amp; &#39;waits&#39;", "aria-label=\"the &quot;height&quot; &lt;over&gt; time\"",
        "its &lt;crust&gt; is hard", "0.5 &lt; 1 &amp; so on"})
    EXPECT_TRUE(page_has(words)) << words;
  EXPECT_FALSE(page_has("<over>") || page_has("<crust>") || page_has("<b>"));
}

TEST_F(AReport, LoadsNothingFromAnywhere) {
  ASSERT_EQ(place.bake("figure 1 --quiet").exit_code, 0);
  ASSERT_EQ(place.bake("report").exit_code, 0);
  std::string text = page();
  const std::regex loads(R"re((src|href|srcset|action|data|poster)\s*=\s*"(?!#|data:)|url\(|@import|<script src|<link|<iframe)re");
  EXPECT_TRUE(page_has("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"));
  text = std::regex_replace(text, std::regex("<link rel=\"icon\" href=\"data:,\">"), "");
  EXPECT_FALSE(std::regex_search(std::regex_replace(text, std::regex("base64,[A-Za-z0-9+/=]*"), "base64,"), loads));
  const std::regex image("<img [^>]*>"), described("alt=\"[^\"]+\"");
  text = std::regex_replace(text, std::regex("base64,[A-Za-z0-9+/=]*"), "base64,");
  for (auto at = std::sregex_iterator(text.begin(), text.end(), image); at != std::sregex_iterator(); ++at)
    EXPECT_TRUE(std::regex_search(at->str(), described)) << at->str();
}

TEST_F(AReport, RefusesDamagedClaimsAndPlacesThatCannotBeWritten) {
  place.write("results/items/dough-draft/claims.json", "{\"claims\": ");
  expect_refused(place, "report", "claims.json: ");
  place.write("results/items/dough-draft/claims.json", "{\"claims\": []}");
  expect_refused(place, "report", "claims.json: not what bake figure writes");
  EXPECT_FALSE(fs::exists(place.folder() / "report.html"));
  fs::remove_all(place.folder() / "results");
  expect_refused(place, "report --out no/such/folder/report.html", "no/such/folder");
  expect_refused(place, "report --quality drfat", "--quality: drfat not in");
}

}  // namespace
}  // namespace bake::test
