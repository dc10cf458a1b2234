// SPDX-License-Identifier: MIT
// A scene as JSON with the values of all keys, defaults included.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace bake {

struct Scene;

/// Everything the run is made from, laid out like the scene file: `toml_text` of it without "file" and "quality" is a scene
/// that resolves to the same values. Infinities are the strings "inf" and "-inf"; a key that was not given
/// and has no default is null; curves are lists of [time_s, value]; shapes are as the scene describes them, with defaults filled in.
nlohmann::json resolved(const Scene& scene);

/// The same with every key under its former name, if it has one. Scenes are compared like this, so that results which were kept before
/// a key got its present name stay those of their scene.
nlohmann::json under_former_names(nlohmann::json resolved_scene);

/// A hash (16 hexadecimal digits) of the resolved scene without the path of its file, run.end_s and run.checkpoint_every_frames. A
/// checkpoint of one scene can be resumed with another scene exactly if their fingerprints agree. It is the same on every machine.
std::string scene_fingerprint(const Scene& scene);

/// A resolved value in one line of TOML; null members are left out.
std::string toml_text(const nlohmann::json& value);
/// A default in one line for the user: "none" if it is null or an empty text.
std::string default_text(const nlohmann::json& value);

}  // namespace bake
