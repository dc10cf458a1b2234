// SPDX-License-Identifier: MIT
// A body that turns: its place on the page, controls and data, for viewer.js.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/report/html.h"

namespace bake::report {

/// The objects in claims.json; none if it was written before there were any.
nlohmann::json objects_of(const nlohmann::json& made);

/// The anchor of an object of the item at `place`: "figure-15-loaf".
std::string object_anchor(const nlohmann::json& object, const std::string& place);

/// The object's first body with its controls and the picture that stands for it; data of all its bodies are added to `data`.
/// Throws InputError if a file in `folder` is missing or damaged.
Html object_figure(const nlohmann::json& object, const std::string& place, const std::filesystem::path& folder, std::vector<Html>& data);

/// The object's other bodies, which follow the first; nothing if there are none.
Html followers(const nlohmann::json& object, const std::string& place);

}  // namespace bake::report
