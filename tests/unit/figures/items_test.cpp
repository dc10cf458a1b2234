// SPDX-License-Identifier: MIT
#include "experiments/make/items.h"

#include <gtest/gtest.h>

#include "solver/core/errors.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

constexpr const char* k_items = R"([[item]]
number = "figure 3"
name = "cookies"
shows = "cookies"
experiment = "fig03_cookies"
status = "scene only"
scenes = ["cookie"]
claims = ["they spread"]

[[item]]
number = "table 3"
name = "costs"
shows = "costs"
status = "not there yet"
claims = ["cheap"]

[[other]]
experiment = "teaching"
purpose = "to learn from"
)";

/// A paper of two items.
class ItemsFile : public testing::Test {
 protected:
  ItemsFile() {
    for (const char* folder : {"paper", "experiments/fig03_cookies", "experiments/teaching"})
      std::filesystem::create_directories(folder_ / folder);
    write("experiments/fig03_cookies/cookie.toml", "");
    write("paper/items.toml", k_items);
  }
  void write(const char* file, const std::string& text) const { std::ofstream(folder_ / file) << text; }
  Items read() const { return read_items(folder_.path()); }
  /// What is said of the file with `from` replaced by `to`, without the folder's name.
  std::string error_of(const std::string& from = "", const std::string& to = "") const {
    std::string text = k_items;
    text.replace(text.find(from), from.size(), to);
    write("paper/items.toml", text);
    return message_of<InputError>([&] { read(); }).substr((folder_ / "paper/").string().size());
  }
  const TemporaryFolder folder_;
};

TEST_F(ItemsFile, FindsAnItemByNumberNameOrFolder) {
  const Items items = read();
  for (const char* words : {"3", "figure 3", "cookies", "fig03_cookies"}) EXPECT_EQ(find_item(items, words).name, "cookies") << words;
  EXPECT_EQ(find_item(items, "3", "table").name, "costs");
  EXPECT_THROW(find_item(items, "cokies"), InputError);
  EXPECT_THROW(find_item(items, ""), InputError);
}

TEST_F(ItemsFile, RefusesLinksThatLeadNowhere) {
  EXPECT_NO_THROW(read());
  EXPECT_EQ(error_of("fig03_cookies", "fig03_cookie"),
            "items.toml:5: item.0.experiment: found 'fig03_cookie', allowed: a folder in experiments");
  EXPECT_EQ(error_of("[\"cookie\"]", "[\"biscuit\"]"),
            "items.toml:7: item.0.scenes: found 'biscuit', allowed: a scene in experiments/fig03_cookies");
  EXPECT_EQ(error_of("scene only", "done"), "items.toml:6: item.0.status: found done without experiments/fig03_cookies/figure.toml");
  EXPECT_EQ(error_of("\"teaching\"", "\"training\""),
            "items.toml:18: other.0.experiment: found 'training', allowed: a folder in experiments");
}

TEST_F(ItemsFile, RefusesAnExperimentThatNobodyNames) {
  std::filesystem::create_directories(folder_ / "experiments/fig99_pie");
  EXPECT_NO_THROW(read()) << "a folder of sources is no experiment";
  write("experiments/fig99_pie/pie.toml", "");
  EXPECT_NE(error_of().find("found experiments/fig99_pie, which no [[item]] or [[other]] names"), std::string::npos);
}

TEST_F(ItemsFile, RefusesWhatIsWrittenWrong) {
  EXPECT_EQ(error_of("shows", "show"), "items.toml:4: item.0: unknown key 'show', did you mean 'shows'?");
  EXPECT_EQ(error_of("table 3", "tabel 3"), "items.toml:11: item.1.number: found 'tabel 3', allowed: figure N, table N or experiment N");
  EXPECT_EQ(error_of("table 3", "figure 3"), "items.toml:11: item.1.number: found 'figure 3' again");
  EXPECT_EQ(error_of("costs", "cookies"), "items.toml:12: item.1.name: found 'cookies' again");
  EXPECT_EQ(error_of("claims = [\"they spread\"]\n", ""),
            "items.toml:1: item.0.claims: missing, allowed: what must be measured to call it reproduced");
  EXPECT_EQ(error_of("not there yet", "soon"),
            "items.toml:14: item.1.status: unknown name 'soon', allowed: done, scene only, not there yet");
}

TEST_F(ItemsFile, OfAnItemThatIsDoneLeavesScenesAndClaimsToItsFigure) {
  write("experiments/fig03_cookies/figure.toml", "");
  EXPECT_EQ(error_of(), "items.toml:6: item.0.status: found a figure.toml of an item that is not done");
  EXPECT_EQ(error_of("scene only", "done"),
            "items.toml:1: item.0: found scenes or claims of an item that is done: its figure.toml names them");
}

}  // namespace
}  // namespace bake
