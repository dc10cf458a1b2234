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

/// results/<run>-<quality> and results/items/<item>-<quality>, in the working folder.
struct FigurePaths {
  const Item& item;
  const Figure& figure;
  const MakeOptions& options;

  std::string quality() const { return word_of(options.quality); }
  std::filesystem::path run(const std::string& name) const { return std::filesystem::path("results") / (name + "-" + quality()); }
  std::filesystem::path item_folder() const { return bake::item_folder(item, options.quality); }
  std::filesystem::path surface(const std::string& name) const { return item_folder() / name; }
};

/// Prints one line on standard error about what is being made, unless quiet.
void say(const MakeOptions& options, const std::string& line);

}  // namespace bake
