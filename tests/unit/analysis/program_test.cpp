// SPDX-License-Identifier: MIT
// `bake-render` as a user calls it.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "solver/io/mesh_file.h"
#include "tests/unit/analysis/runs.h"

namespace bake {
namespace {

class RenderProgram : public testing::Test {
 protected:
  RenderProgram() {
    write_run(folder / "run", Ball(0.1f, 0.03f), 3, [](const float*, double) { return State{150, 1}; });
    put(folder / "view.toml", "[picture]\nwidth_px = 40\nheight_px = 30\nsamples = 1\n[[panel]]\nfield = \"temperature\"\n");
  }
  int call(const std::string& arguments, const std::string& before = "") {
    const std::string command =
        fmt::format("cd '{}' && {} '{}' {} >.out 2>.err", folder.path().string(), before, BAKE_RENDER_PROGRAM, arguments);
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  void expect_refused(const std::string& arguments, const std::string& reason) {
    SCOPED_TRACE("bake-render " + arguments);
    EXPECT_EQ(call(arguments), 2);
    const std::string error = contents(folder / ".err");
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
    EXPECT_EQ(error.substr(0, 13), "bake-render: ");
    EXPECT_NE(error.find(reason), std::string::npos) << error;
  }
  TemporaryFolder folder;
};

TEST_F(RenderProgram, MakesPicturesSlicesSurfacesAndMontages) {
  EXPECT_EQ(call("picture view.toml run/frames/0002.hdf --out a.png --size 32x24 --threads 2"), 0) << contents(folder / ".err");
  EXPECT_EQ(call("slice view.toml run/frames/0002.hdf --out b.png --size 400x300 --results run"), 0) << contents(folder / ".err");
  EXPECT_EQ(call("surface run/frames/0002.hdf --out c.hdf"), 0) << contents(folder / ".err");
  EXPECT_EQ(call("picture view.toml c.hdf --results run --out d.png --set camera.margin=0.2"), 0) << contents(folder / ".err");
  EXPECT_EQ(call("montage a.png d.png --label one --label two --out e.png"), 0) << contents(folder / ".err");
  EXPECT_EQ(call("montage a.png d.png --row 'a d d' --row 'a d d' --cell 64x48 --out f.png"), 0) << contents(folder / ".err");
  EXPECT_EQ(read_png(folder / "f.png").width, 3 * 64 + 2 * 2);
  for (const char* file : {"a.png", "b.png", "c.hdf", "d.png", "e.png"}) EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
}

TEST_F(RenderProgram, MakesModelsAndJpegsForAPage) {
  write_run(folder / "fine", Ball(0.1f, 0.01f), 3, [](const float*, double) { return State{150, 1}; });
  ASSERT_EQ(call("model view.toml fine --frames 0,2 --out small --triangles 3000 --particles 1000"), 0) << contents(folder / ".err");
  for (const char* name : {"0000.hdf", "0002.hdf"}) {
    const Mesh mesh = read_mesh(folder / "small" / (std::string("surface_") + name));
    EXPECT_GT(mesh.cell_count(), 1500u);
    EXPECT_LT(mesh.cell_count(), 3000u);
    EXPECT_TRUE(mesh.find("temperature") && mesh.find("browning"));
    const FrameReader particles(folder / "small" / (std::string("particles_") + name));
    EXPECT_NEAR(static_cast<double>(particles.particles()), 1000, 100);
    EXPECT_TRUE(particles.has("browning"));
  }
  const auto ids = [&](const char* name) { return FrameReader(folder / "small" / name).identities(); };
  EXPECT_EQ(ids("particles_0000.hdf"), ids("particles_0002.hdf")) << "the same ones in all frames";
  EXPECT_NE(contents(folder / "small/look.json").find("\"skin\":[[0.0,\"edd9ad\"]"), std::string::npos);

  put(folder / "half.toml", "[[object]]\nmirrored = \"z\"\n");
  ASSERT_EQ(call("model half.toml fine --frames 0,2 --out whole --triangles 3000 --particles 1000000"), 0) << contents(folder / ".err");
  const FrameReader once(folder / "fine/frames/0002.hdf"), twice(folder / "whole/particles_0002.hdf");
  EXPECT_EQ(twice.particles(), 2 * once.particles()) << "what was run beside a mirror is completed";
  const std::vector<std::int64_t> all = twice.identities();
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size());
  const std::vector<double> x = twice.positions();
  for (std::size_t i = 0; i < once.particles(); ++i) {
    EXPECT_EQ(x[3 * (i + once.particles())], x[3 * i]);
    EXPECT_EQ(x[3 * (i + once.particles()) + 2], -x[3 * i + 2]);
  }

  put(folder / "turned.toml", "[[object]]\nmirrored = \"z\"\nrotate_deg = [0, 90, 0]\n");
  ASSERT_EQ(call("model turned.toml fine --frames 2 --out turned --triangles 3000 --particles 1000000"), 0) << contents(folder / ".err");
  const std::vector<double> y = FrameReader(folder / "turned/particles_0002.hdf").positions();
  ASSERT_EQ(y.size(), x.size());
  for (std::size_t i = 0; i < y.size(); i += 3) {  // x goes to -z, z to x
    EXPECT_NEAR(y[i], x[i + 2], 1e-7);
    EXPECT_NEAR(y[i + 1], x[i + 1], 1e-7);
    EXPECT_NEAR(y[i + 2], -x[i], 1e-7);
  }

  ASSERT_EQ(call("picture view.toml run/frames/0002.hdf --out a.png --size 64x48"), 0) << contents(folder / ".err");
  ASSERT_EQ(call("jpeg a.png --out a.jpg --width 32"), 0) << contents(folder / ".err");
  EXPECT_EQ(contents(folder / "a.jpg").substr(0, 3), "\xff\xd8\xff");
  expect_refused("jpeg a.png --out b.png", "--out: found b.png, allowed: a name that ends in .jpg");
  expect_refused("jpeg none.png --out b.jpg", "none.png: no such file");
  expect_refused("model view.toml nowhere --frames 0 --out small", "nowhere");
}

TEST_F(RenderProgram, ShowsAFrameByAnyFieldWholeOrCutWithoutAView) {
  const std::string frame = "run/frames/0002.hdf --size 400x300";
  for (const auto& [options, file] : {std::pair{"--by temperature", "whole.png"}, {"--by water_mass --cut y=0", "cut.png"}})
    EXPECT_EQ(call(fmt::format("slice {} {} --out {}", frame, options, file)), 0) << contents(folder / ".err");
  EXPECT_EQ(call(fmt::format("slice view.toml {} --by water_mass --cut y=0 --out same.png", frame)), 0) << contents(folder / ".err");
  EXPECT_EQ(contents(folder / "same.png"), contents(folder / "cut.png"));
  EXPECT_NE(contents(folder / "whole.png"), contents(folder / "cut.png"));
  expect_refused("slice run/frames/0002.hdf --by temprature --out a.png", "did you mean 'temperature'");
  expect_refused("slice run/frames/0002.hdf --out a.png", "found no [[panel]]");
  expect_refused("slice run/frames/0002.hdf --by temperature --cut 0 --out a.png", "--cut: found '0', allowed: x=, y= or z=");
  expect_refused("slice run/frames/0002.hdf --by temperature --cut y=1 --out a.png", "the plane does not meet");
  expect_refused("slice view.toml --out a.png", "files: missing");
}

TEST_F(RenderProgram, MakesAMovieOfNumberedPicturesAndCallsFfmpegIfItIsThere) {
  EXPECT_EQ(call("movie view.toml run --out film --every 2", "env PATH=/nowhere"), 0) << contents(folder / ".err");
  EXPECT_NE(contents(folder / ".out").find("2 pictures in film; to get an mp4, apt-get install ffmpeg"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "film/0001.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "film/0002.png"));

  std::filesystem::create_directory(folder / "bin");
  put(folder / "bin/ffmpeg", "#!/bin/sh\necho \"$@\" >arguments\n");
  std::filesystem::permissions(folder / "bin/ffmpeg", std::filesystem::perms::owner_all);
  EXPECT_EQ(call("movie view.toml run --out film --rate 12", "env PATH=bin:$PATH"), 0) << contents(folder / ".err");
  const std::string arguments = contents(folder / "arguments");
  EXPECT_NE(arguments.find("-framerate 12 -i file:film/%04d.png -frames:v 3 "), std::string::npos) << arguments;
  EXPECT_NE(contents(folder / ".out").find("film/movie.mp4"), std::string::npos);

  put(folder / "bin/ffmpeg", "#!/bin/sh\nexit 1\n");
  std::filesystem::remove(folder / "film/movie.mp4");
  EXPECT_EQ(call("movie view.toml run --out film", "env PATH=bin:$PATH"), 3);
  EXPECT_EQ(contents(folder / ".err"), "bake-render: ffmpeg failed; the pictures are in film\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "film/movie.mp4"));
  EXPECT_FALSE(std::filesystem::exists(folder / "film/movie.mp4.part"));
}

TEST_F(RenderProgram, MakesAMovieThatHasThePicturesOfThisRunAndTheirColours) {
  if (std::system("command -v ffmpeg >/dev/null") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const std::filesystem::path film = folder / "a:b 100%d";
  std::filesystem::create_directory(film);
  put(film / "0003.png", "left by a longer run");
  ASSERT_EQ(call("movie view.toml run --out 'a:b 100%d' --size 41x31 --set ground.show=false --set sky.backdrop=[0.9,0.1,0.1]"), 0)
      << contents(folder / ".err");
  // back to pictures: three, of an even number of pixels, the last one as it was drawn but for what is lost by packing
  std::filesystem::rename(film / "movie.mp4", folder / "movie.mp4");
  std::filesystem::rename(film / "0002.png", folder / "last.png");
  const std::string in_folder = fmt::format("cd '{}' && ffmpeg -loglevel error </dev/null ", folder.path().string());
  ASSERT_EQ(std::system((in_folder + "-i movie.mp4 back%d.ppm").c_str()), 0);
  ASSERT_EQ(std::system((in_folder + "-i last.png -vf crop=40:30:0:0 -pix_fmt rgb24 drawn.ppm").c_str()), 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "back4.ppm"));
  const std::string back = contents(folder / "back3.ppm"), drawn = contents(folder / "drawn.ppm");
  EXPECT_EQ(back.substr(0, 9), "P6\n40 30\n");
  ASSERT_EQ(back.size(), drawn.size());
  std::array<double, 3> channel{};  // sums of differences: a wrong matrix of colours shifts them
  for (std::size_t i = 0; i < back.size(); ++i)
    channel[i % 3] += static_cast<unsigned char>(back[i]) - static_cast<unsigned char>(drawn[i]);
  for (const double sum : channel) EXPECT_LT(std::abs(sum), 5 * 40 * 30) << "of 255 a pixel";
}

TEST_F(RenderProgram, RefusesWrongUseInOneLine) {
  expect_refused("", "no command given");
  expect_refused("pictur view.toml", "unknown command 'pictur'; did you mean 'picture'?");
  expect_refused("picture view.toml run/frames/0002.hdf", "--out is required");
  expect_refused("picture view.toml run/frames/0002.hdf --out a.jpg", "allowed: a name that ends in .png");
  expect_refused("picture view.toml run/frames/0002.hdf --out a.png --size 40", "--size: found '40'");
  expect_refused("picture view.toml run/frames/0002.hdf --out a.png --size 40xyz", "--size: found '40xyz'");
  expect_refused("picture view.toml run/frames/0002.hdf --out a.png --samples 0", "--samples");
  expect_refused("picture view.toml run/frames/0002.hdf --out a.png --results a --results b", "--results: found 2 folders for 1 files");
  expect_refused("picture view.toml run/frames/0002.hdf --out a.png --set camera.margn=1", "did you mean 'margin'");
  expect_refused("picture other.toml run/frames/0002.hdf --out a.png", "other.toml: no such file");
  expect_refused("picture view.toml run/frames/0007.hdf --out a.png", "0007.hdf");
  expect_refused("surface run/frames/0002.hdf --out a.png", "allowed: a name that ends in .hdf");
  expect_refused("surface run.json --out a.hdf", "run.json");
  expect_refused("montage --out a.png", "required");
  expect_refused("montage view.toml --out a.png", "view.toml: not a picture");
  expect_refused("montage one.png two.png --row 'one' --out a.png", "--row: found 1 names for 2 pictures, allowed: one for each");
  expect_refused("montage one.png --row 'eins' --out a.png", "--row: found 'eins', allowed: names of the pictures' files, without .png");
  expect_refused("montage one.png two.png --row 'one two' --row one --out a.png", "--row: found rows of 2 and 1 cells");
  expect_refused("montage one.png --row one --cell 4 --out a.png", "one.png: no such file");
  expect_refused("montage one.png --row one --columns 2 --out a.png", "excludes");
  expect_refused("movie view.toml nowhere --out film", "nowhere: no such folder");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

}  // namespace
}  // namespace bake
