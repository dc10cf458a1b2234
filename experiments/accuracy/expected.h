// SPDX-License-Identifier: MIT
// What the study has found of a scene, for those who are about to run it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bake {
struct Scene;
}

namespace bake::studies::accuracy {

/// One line for each quality that was measured of a scene of experiments/, from accuracy.json in `stored`: "draft: error 3.1 %, ...",
/// and for paper, where it was not measured, what draft and standard let expect. None if the file is not there or does not know the
/// scene; a line that says so if it was measured of another version of the scene.
/// Throws InputError if the file is damaged.
std::vector<std::string> expected_of(const Scene& scene, const std::filesystem::path& stored);

}  // namespace bake::studies::accuracy
