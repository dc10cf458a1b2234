// SPDX-License-Identifier: MIT
// Makes shapes with colours at their vertices from a file (the particles of a frame, or a mesh).
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/browning/browning.h"
#include "analysis/image/colour_bar.h"
#include "analysis/pictures/path_tracer.h"
#include "analysis/pictures/view.h"

namespace bake {

/// The histories of browning of runs, kept from picture to picture so that a movie reads each frame once.
class Histories {
 public:
  /// The history of a run up to `frame`. Throws InputError as BrowningHistory does.
  const BrowningHistory& at(const std::filesystem::path& results, const BrowningLaw& law, int frame);

 private:
  struct Entry {
    std::unique_ptr<BrowningHistory> history;
    int frame = 0;
  };
  std::map<std::filesystem::path, Entry> entries_;
};

/// Shapes as the path tracer takes them, turned and shifted.
struct PictureObject {
  std::vector<TriangleObject> meshes;
  std::vector<SphereObject> spheres;
  std::optional<ColourBar> bar;  ///< what its colours stand for, if a field paints it
  double time_s = 0;             ///< of the file
};

/// Reads `file` and makes it what `settings` say. `results`: folder of the run that the file shows; empty: found from a frame's own
/// place. Throws InputError: unreadable file, missing field, browning or a cut face without a run, frames of another run.
PictureObject load_object(const std::filesystem::path& file, const std::filesystem::path& results, const View& view,
                          const ObjectSettings& settings, Histories& histories, int threads);

}  // namespace bake
