// SPDX-License-Identifier: MIT
// Technical pictures, and pictures side by side.
#include "analysis/slices/slice.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "analysis/image/montage.h"
#include "analysis/slices/draw.h"
#include "solver/core/errors.h"
#include "tests/unit/analysis/runs.h"

namespace bake {
namespace {

/// A square of 2 m in the plane y = 0, seen from -y.
Mesh square() {
  Mesh mesh;
  mesh.points = {-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1};
  mesh.cells = {0, 1, 2, 0, 2, 3};
  return mesh;
}

const Projection k_from_front{{0, 0, 0}, {0, -1, 0}, {0, 0, 1}, 2};

/// Share of the pixels that are not white.
double covered(const Image& image) {
  double count = 0;
  for (const auto& p : image.pixels) count += p != pixel(Colour::Ones());
  return count / static_cast<double>(image.pixels.size());
}

TEST(Drawing, NeedsNoDisplayAndIsTrueToScale) {
  unsetenv("DISPLAY");
  const Mesh mesh = square();
  EXPECT_NEAR(covered(draw({{&mesh, {}, false, false}}, k_from_front, 80, 60)), 2.0 * 2 / (4 * 4 * 80.0 / 60), 0.02);
}

TEST(Drawing, ShowsTheColoursAsTheyAre) {
  const Mesh mesh = square();
  const Colour red(0.8f, 0.2f, 0.1f);
  const Image image = draw({{&mesh, std::vector<Colour>(4, red), false, false}}, k_from_front, 40, 40);
  EXPECT_EQ(image.at(20, 20), pixel(red));
  EXPECT_EQ(image.at(2, 2), pixel(Colour::Ones()));
}

TEST(Drawing, EdgesAreDark) {
  const Mesh mesh = square();
  const std::vector<Colour> white(4, Colour::Ones());
  EXPECT_EQ(covered(draw({{&mesh, white, false, false}}, k_from_front, 80, 60)), 0);
  EXPECT_GT(covered(draw({{&mesh, white, false, true}}, k_from_front, 80, 60)), 0.01);
}

/// A ball that is warm on the right.
class Slices : public testing::Test {
 protected:
  Slices() {
    write_run(folder / "run", ball, 2, [](const float* p, double) { return State{p[0] > 0 ? 100.0f : 20.0f, 1}; });
  }
  std::string refusal(const std::string& text) const {
    return message_of<InputError>([&] { take(text); });
  }
  Image take(const std::string& text, std::size_t files = 1) const {
    const std::vector<std::filesystem::path> frames(files, folder / "run/frames/0001.hdf");
    return take_slices(parse_view("[picture]\nwidth_px = 400\nheight_px = 300\n" + text, "slice.toml"), frames,
                       std::vector<std::filesystem::path>(files), 1);
  }
  TemporaryFolder folder;
  const Ball ball{0.1f, 0.02f};
};

TEST_F(Slices, ShowTheFieldInside) {
  const Image image = take("[[panel]]\nfield = \"temperature\"\nrange_low = 20\nrange_high = 100\n");
  EXPECT_EQ(image.at(240, 130), pixel(map_colour(ColourMap::viridis, 1)));
  EXPECT_EQ(image.at(160, 130), pixel(map_colour(ColourMap::viridis, 0)));
}

TEST_F(Slices, AreDrawnWithWhatIsAskedForUpwards) {
  const Image image = take("[slice]\nup = [0, 0.5, -1]\n[[panel]]\nfield = \"temperature\"\nrange_low = 20\nrange_high = 100\n");
  EXPECT_EQ(image.at(240, 130), pixel(map_colour(ColourMap::viridis, 0))) << "upside down, the right is on the left";
  EXPECT_EQ(image.at(160, 130), pixel(map_colour(ColourMap::viridis, 1)));
}

TEST_F(Slices, StandSideBySide) {
  EXPECT_NO_THROW(take("[[panel]]\nfield = \"temperature\"\n[[panel]]\nfield = \"water_mass\"\nmap = \"cividis\"\n", 2));
  EXPECT_NO_THROW(take("[slice]\ncut = false\nedges = true\n[[panel]]\nfield = \"temperature\"\n", 2));
}

TEST_F(Slices, WhatCannotBeShownIsRefusedInOneLine) {
  EXPECT_TRUE(has(refusal(""), "slice.toml: found no [[panel]]"));
  EXPECT_TRUE(has(refusal("[[panel]]\nfield = \"porosty\""), "has no field 'porosty'"));
  EXPECT_TRUE(has(refusal("[[panel]]"), "panel.0.field: missing"));
  EXPECT_TRUE(has(refusal("[slice]\npoint_m = [0, 3, 0]\n[[panel]]\nfield = \"temperature\""), "the plane does not meet"));
  EXPECT_TRUE(has(refusal("[slice]\nnormal = [0, 0, 0]\n[[panel]]\nfield = \"temperature\""), "slice.normal: found no direction"));
  EXPECT_TRUE(
      has(refusal("[slice]\nup = [0, 2, 0]\n[[panel]]\nfield = \"temperature\""), "slice.up: found no direction across the normal"));
}

TEST(Montage, PutsPicturesSideBySide) {
  const Image red(40, 30, Colour(1, 0, 0)), blue(80, 60, Colour(0, 0, 1));
  const Image row = montage({red, blue}, {}, 2), column = montage({red, blue}, {"red", "blue"}, 1);
  EXPECT_GT(row.width, 80);
  EXPECT_LT(row.height, 40);
  EXPECT_GT(column.height, 80);
  EXPECT_LT(column.width, 50);
  EXPECT_EQ(row.at(20, 15), pixel(Colour(1, 0, 0)));
  EXPECT_EQ(row.at(row.width - 20, 15), pixel(Colour(0, 0, 1)));
  EXPECT_THROW(montage({}, {}, 1), std::invalid_argument);
  EXPECT_THROW(montage({red}, {"a", "b"}, 1), std::invalid_argument);
}

TEST(Tiles, FillTheCellsThatHaveTheirName) {
  const Layout layout = layout_of({"red blue  blue", "grey  blue blue"});
  ASSERT_EQ(layout.problem, "");
  ASSERT_EQ(layout.places.size(), 3u);
  EXPECT_EQ(layout.places[1].name, "blue");
  EXPECT_EQ(layout.places[1].columns, 2);
  EXPECT_EQ(layout.places[1].rows, 2);
  const Image red(40, 30, Colour(1, 0, 0)), blue(80, 60, Colour(0, 0, 1)), grey(7, 90, Colour::Constant(0.5f));
  const Image tiles = tiled({red, blue, grey}, layout, 40, 30);
  EXPECT_EQ(tiles.width, 3 * 40 + 2 * 2);
  EXPECT_EQ(tiles.height, 2 * 30 + 2);
  EXPECT_EQ(tiles.at(0, 0), pixel(Colour(1, 0, 0)));
  EXPECT_EQ(tiles.at(39, 29), pixel(Colour(1, 0, 0)));
  EXPECT_EQ(tiles.at(40, 0), pixel(Colour::Ones())) << "a gap";
  EXPECT_EQ(tiles.at(42, 0), pixel(Colour(0, 0, 1)));
  EXPECT_EQ(tiles.at(83, 31), pixel(Colour(0, 0, 1))) << "no gap inside";
  EXPECT_EQ(tiles.at(123, 61), pixel(Colour(0, 0, 1)));
  EXPECT_EQ(tiles.at(0, 32), pixel(Colour::Constant(0.5f))) << "a picture of another shape covers its cell, too";
  EXPECT_EQ(tiles.at(39, 61), pixel(Colour::Constant(0.5f)));
  EXPECT_THROW(tiled({red}, layout, 40, 30), std::invalid_argument);
}

TEST(Tiles, ShowTheMiddleOfAPictureThatIsTooWide) {
  Image wide(90, 30, Colour(1, 0, 0));
  paste(wide, Image(30, 30, Colour(0, 0, 1)), 30, 0);
  const Image cell = tiled({wide}, layout_of({"wide"}), 30, 30);
  for (const auto& p : cell.pixels) EXPECT_EQ(p, pixel(Colour(0, 0, 1)));
}

TEST(Tiles, RefuseWhatIsNoGrid) {
  EXPECT_EQ(layout_of({}).problem, "found no cell, allowed: rows of names");
  EXPECT_EQ(layout_of({" "}).problem, "found no cell, allowed: rows of names");
  EXPECT_EQ(layout_of({"a b", "a"}).problem, "found rows of 2 and 1 cells, allowed: as many in each");
  for (const std::vector<std::string>& rows : {std::vector<std::string>{"a b a"}, {"a b", "b b"}, {"a b", "b a"}})
    EXPECT_TRUE(layout_of(rows).problem.ends_with("that are no rectangle, allowed: cells that fill one")) << rows.front();
}

TEST(Images, MadeSmallerKeepTheirMean) {
  Image image(64, 48, Colour::Zero());
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) image.at(x, y) = pixel(Colour::Constant(static_cast<float>((x + y) % 2)));
  for (const auto& p : scaled(image, 16, 12).pixels) EXPECT_NEAR(p[0], 127.5, 1);
}

}  // namespace
}  // namespace bake
