// SPDX-License-Identifier: MIT
// Writes a report with bodies that turn, for a browser: page_of_balls <folder> makes <folder>/report.html.
#include <filesystem>

#include "experiments/report/report.h"
#include "tests/unit/report/ball.h"

namespace {

constexpr const char* k_claims =
    R"({"number": "figure 1", "name": "ball", "quality": "draft", "title": "A ball that grows", "shows": "it grows",
"claims": [
 {"metric": "volume_gain", "meaning": "volume at the end over that at the start", "of": "ball_soft", "measured": 3.4, "unit": "1",
  "condition": ">= 1.2", "kind": "published", "why": "figure 1: it grows, by a fifth at least", "says": "the ball grows", "low": 1.2,
  "high": null, "holds": true, "problem": ""},
 {"metric": "volume_gain", "meaning": "volume at the end over that at the start", "of": "ball_hard", "measured": 3.4, "unit": "1",
  "condition": "<= 1.1", "kind": "published", "why": "figure 1: a hard one does not", "says": "", "low": null, "high": 1.1,
  "holds": false, "problem": ""}],
"runs": [], "numbers": [], "tables": [],
"pictures": [{"file": "ball.png", "shows": "a ball", "kind": "picture"}],
"objects": [{"name": "turning", "shows": "a soft ball and a hard one", "picture": "ball", "of": ["ball_soft", "ball_hard"], "particles": true}],
"charts": [{"file": "radius.svg", "shows": "the radius over time"}],
"provenance": {"date": "2019-07-01T00:00:00Z", "program": {"commit": "0123456789ab"}, "machine": {"cpu": "Abacus"}}})";

/// A PNG of one brown pixel.
constexpr unsigned char k_pixel[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
                                     0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00,
                                     0x00, 0x90, 0x77, 0x53, 0xde, 0x00, 0x00, 0x00, 0x0c, 0x49, 0x44, 0x41, 0x54, 0x78,
                                     0xda, 0x63, 0xb8, 0x36, 0xc5, 0x09, 0x00, 0x03, 0xf0, 0x01, 0xad, 0xa0, 0xe3, 0xf5,
                                     0xf8, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

}  // namespace

int main(int count, char** words) {
  using namespace bake;
  if (count != 2) return 2;
  std::filesystem::current_path(words[1]);
  for (const char* folder : {"paper", "experiments/fig01_ball"}) std::filesystem::create_directories(folder);
  put("paper/items.toml", R"([[item]]
number = "figure 1"
name = "ball"
shows = "a ball that grows"
experiment = "fig01_ball"
status = "done"
[[item]]
number = "figure 2"
name = "pie"
shows = "a pie"
status = "not there yet"
claims = ["its crust is hard"]
)");
  put("experiments/fig01_ball/figure.toml", "");
  const std::filesystem::path made = "results/items/ball-draft";
  for (const char* body : {"ball_soft", "ball_hard"}) report::write_ball(made / "turning" / body);
  put(made / "claims.json", k_claims);
  put(made / "ball.png", std::string(std::begin(k_pixel), std::end(k_pixel)));
  put(made / "radius.csv", "soft: time [s],soft: radius [m],hard: time [s],hard: radius [m]\n0,0.2,0,0.2\n1,0.25,1,0.21\n2,0.3,2,0.22\n");
  put(made / "radius.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
  put("report.html", report::make_report(read_items("."), Quality::draft).page);
}
