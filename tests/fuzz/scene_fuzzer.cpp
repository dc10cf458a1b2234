// SPDX-License-Identifier: MIT
// Any text must give a scene or an InputError of one line. Lines `# --set key=value` in it are applied as overrides.
// Run: scene_fuzzer -max_total_time=60 <a scratch folder> tests/fuzz/corpus_scene
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "solver/scene/reader.h"
#include "solver/scene/resolved.h"

namespace {

constexpr std::string_view k_mark = "# --set ";

std::vector<std::string> overrides_in(std::string_view text) {
  std::vector<std::string> overrides;
  for (std::size_t at = text.find(k_mark); at != std::string_view::npos; at = text.find(k_mark, at)) {
    at += k_mark.size();
    overrides.emplace_back(text.substr(at, text.find('\n', at) - at));
  }
  return overrides;
}

void use(const bake::Scene& scene) {
  (void)bake::toml_text(bake::resolved(scene));
  (void)bake::scene_fingerprint(scene);
  (void)scene.oven.temperature_C(1.5);
  for (const bake::Collider& collider : scene.colliders) (void)collider.shape->distance({0.1, 0.2, 0.3});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  try {
    use(bake::parse_scene(text, "fuzz.toml", {bake::Quality::draft, overrides_in(text)}));
  } catch (const bake::InputError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
