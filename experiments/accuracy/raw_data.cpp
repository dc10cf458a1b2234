// SPDX-License-Identifier: MIT
#include "experiments/accuracy/raw_data.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstring>

#include "solver/core/errors.h"
#include "solver/core/tell.h"
#include "solver/io/provenance.h"
#include "solver/scene/entry.h"
#include "solver/scene/resolved.h"

namespace bake::studies::accuracy {

namespace {

using nlohmann::json;

std::string key_of(const json& what, const json& by) { return what.dump() + by.dump(); }

[[noreturn]] void cannot_write(const std::filesystem::path& file) {
  throw OutputError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
}

/// Processes that wait for a processor, over the last minute.
double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

json number_or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

}  // namespace

Identity identity_of(const Case& c, const Variant& v, const Scene& scene) {
  static const json made = provenance();
  const json& program = made.at("program");
  json what{{"case", c.name},         {"version", c.version},     {"cells", v.cells},
            {"per_cell", v.per_cell}, {"overrides", v.overrides}, {"scene", scene_fingerprint(scene)}};
  if (v.by == By::textbook) what["by"] = "textbook";
  return {what,
          {{"solver", program.at("solver")},
           {"compiler", program.at("compiler")},
           {"flags", program.at("flags")},
           {"cpu", made.at("machine").at("cpu")}}};
}

RawData::RawData(const std::filesystem::path& folder, const std::string& name) : file_(folder / (name + ".jsonl")) {
  if (!std::filesystem::exists(file_)) return;
  const std::string text = read_text_file(file_);
  const std::size_t whole = text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1;
  if (whole < text.size()) {
    tell_user("{}: its last line is half-written and left out", file_.string());
    std::filesystem::resize_file(file_, whole);
  }
  int number = 0;
  for (std::size_t at = 0; at < whole;) {
    const std::size_t end = text.find('\n', at);
    ++number;
    try {
      json line = json::parse(text.substr(at, end - at));
      const std::string key = key_of(line.at("what"), line.at("by"));
      line.at("found").at("particle_steps").get<std::int64_t>();
      lines_[key].push_back(std::move(line));
    } catch (const json::exception&) {
      throw InputError(
          fmt::format("{}:{}: found a damaged line, allowed: lines that bake study accuracy has written (remove it, and it is "
                      "measured again)",
                      file_.string(), number));
    }
    at = end + 1;
  }
}

const std::vector<json>& RawData::of(const Identity& identity) const {
  static const std::vector<json> none;
  const auto at = lines_.find(key_of(identity.what, identity.by));
  return at == lines_.end() ? none : at->second;
}

void RawData::append(const Identity& identity, const Found& found, const bench::Speed& speed) {
  const json line{
      {"what", identity.what},
      {"by", identity.by},
      {"found",
       {{"error", number_or_null(found.error)},
        {"parts", found.parts},
        {"failure", found.failure},
        {"particles", found.particles},
        {"steps", found.steps},
        {"particle_steps", found.particle_steps},
        {"wall_s", found.wall_s},
        {"cpu_s", found.cpu_s}}},
      {"when",
       {{"date", provenance().at("date")},
        {"load_average", load_average()},
        {"speed",
         {{"triad_GB_per_s", speed.triad_GB_per_s}, {"single_GFLOPs", speed.single_GFLOPs}, {"double_GFLOPs", speed.double_GFLOPs}}}}}};
  std::filesystem::create_directories(file_.parent_path());
  const int file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) cannot_write(file_);
  const std::string text = line.dump() + "\n";
  const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()) && ::fsync(file) == 0;
  ::close(file);
  if (!written) cannot_write(file_);
  lines_[key_of(identity.what, identity.by)].push_back(line);
}

}  // namespace bake::studies::accuracy
