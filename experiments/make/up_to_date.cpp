// SPDX-License-Identifier: MIT
#include "experiments/make/up_to_date.h"

#include <fstream>

#include "solver/io/atomic_file.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

fs::path note_of(const fs::path& output) { return output.string() + ".from.json"; }

}  // namespace

bool is_up_to_date(const fs::path& output, const nlohmann::json& from) {
  std::ifstream in(note_of(output));
  return fs::exists(output) && in && nlohmann::json::parse(in, nullptr, false) == from;
}

void record_sources(const fs::path& output, const nlohmann::json& from) { write_text_atomically(note_of(output), from.dump(2) + "\n"); }

nlohmann::json stamp(const fs::path& file) {
  std::error_code error;
  const auto changed = fs::last_write_time(file, error).time_since_epoch().count();
  if (error) return {file.string(), nullptr};
  return {file.string(), fs::file_size(file), changed};
}

}  // namespace bake
