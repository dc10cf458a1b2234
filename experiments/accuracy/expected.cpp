// SPDX-License-Identifier: MIT
#include "experiments/accuracy/expected.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/accuracy/result.h"
#include "solver/core/errors.h"
#include "solver/io/json_fault.h"
#include "solver/scene/entry.h"
#include "solver/scene/resolved.h"
#include "solver/scene/scene.h"

namespace bake::studies::accuracy {

namespace {

using nlohmann::json;

/// "fig15_bread/bread": of the folder and file that a scene was read from.
std::string name_of(const Scene& scene) {
  const auto file = std::filesystem::absolute(scene.file);
  return file.parent_path().filename().string() + "/" + file.stem().string();
}

std::string line_of(const json& q, const std::string& cpu) {
  return fmt::format("{}: error {}, {} million particle-steps, {} s of one core of {}", q.at("quality").get<std::string>(),
                     percent(q.at("error")), brief(q.at("particle_steps").get<double>() / 1e6), brief(q.at("cpu_s")), cpu);
}

/// Of paper, whose dx is half of standard's as standard's is half of draft's, if those two are all that was measured; else empty.
std::string outlook_of(const json& qualities) {
  if (qualities.size() != 2 || qualities[0].at("quality") != "draft" || qualities[1].at("quality") != "standard") return "";
  const double draft = qualities[0].at("error"), standard = qualities[1].at("error");
  return fmt::format("paper: not measured; error about {} if it falls on as from draft to standard", percent(standard * standard / draft));
}

}  // namespace

std::vector<std::string> expected_of(const Scene& scene, const std::filesystem::path& stored) {
  if (!std::filesystem::exists(stored)) return {};
  Scene at_paper = scene;
  at_paper.quality = Quality::paper;
  std::vector<std::string> lines;
  try {
    const json all = json::parse(read_text_file(stored));
    const std::string cpu = all.at("provenance").at("machine").at("cpu");
    for (const json& c : all.at("cases")) {
      if (c.at("scene") != name_of(scene)) continue;
      if (c.at("scene_fingerprint") != scene_fingerprint(at_paper))
        return {"measured of another version of this scene (bake study accuracy)"};
      for (const json& q : c.at("qualities")) lines.push_back(line_of(q, cpu));
      if (const std::string outlook = outlook_of(c.at("qualities")); !outlook.empty()) lines.push_back(outlook);
      if (!lines.empty()) lines.push_back("the error is that of: " + c.at("measured").get<std::string>());
    }
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: damaged, allowed: what bake study accuracy writes: {}", stored.string(), json_fault(error)));
  }
  return lines;
}

}  // namespace bake::studies::accuracy
