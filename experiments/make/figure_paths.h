// SPDX-License-Identifier: MIT
// The paths of an item's results, and the options with which it is made.
#pragma once

#include "experiments/make/figure_file.h"
#include "solver/scene/describe.h"
#include "solver/scene/settings.h"

namespace bake {

/// results/items/<item>-<quality>, in the working folder.
inline std::filesystem::path item_folder(const Item& item, Quality quality) {
  return std::filesystem::path("results/items") / (item.name + "-" + word_of(quality));
}

struct MakeOptions {
  Quality quality = Quality::draft;
  int threads = 0;       ///< 0: all cores
  std::string only_run;  ///< make only this run; empty: make everything
  bool pictures = true;
  std::string size;  ///< of pictures, "640x480"; empty: as the view says
  int samples = 0;   ///< paths of light per pixel; 0: as the view says
  bool quiet = false;
};

/// How many of the programs that make surfaces, pictures and bodies work at the same time: two, since each has stretches that keep a single
/// core busy. One where one thread was asked for, and at paper, where one takes up to 4 GB.
inline int programs_at_once(const MakeOptions& options) { return options.threads == 1 || options.quality == Quality::paper ? 1 : 2; }

/// results/<run>-<quality> and results/items/<item>-<quality>, in the working folder.
struct FigurePaths {
  const Item& item;
  const Figure& figure;
  const MakeOptions& options;
  std::string part = {};  ///< of another figure, whose name it is: its surfaces stand in a folder of that name

  std::string quality() const { return word_of(options.quality); }
  std::filesystem::path run(const std::string& name) const { return std::filesystem::path("results") / (name + "-" + quality()); }
  std::filesystem::path item_folder() const { return bake::item_folder(item, options.quality); }
  std::filesystem::path surface(const std::string& name) const { return item_folder() / part / name; }
};

/// What the picture shows: this figure, or its part of another one.
inline FigurePaths shown_by(const FigurePicture& picture, const FigurePaths& paths) {
  return picture.part ? FigurePaths{paths.item, *picture.part, paths.options, picture.figure} : paths;
}

/// This figure, and the parts of others that its pictures show.
inline std::vector<FigurePaths> with_parts(const FigurePaths& paths) {
  std::vector<FigurePaths> all{paths};
  for (const FigurePicture& picture : paths.figure.pictures)
    if (picture.part) all.push_back(shown_by(picture, paths));
  return all;
}

/// Prints one line on standard error about what is being made, unless quiet.
void say(const MakeOptions& options, const std::string& line);

}  // namespace bake
