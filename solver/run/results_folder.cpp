// SPDX-License-Identifier: MIT
#include "solver/run/results_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "solver/io/frames.h"
#include "solver/io/ledger_file.h"
#include "solver/run/frame_times.h"
#include "solver/scene/resolved.h"
#include "solver/scene/scene.h"

namespace bake {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// run.json; null if it is missing or was not written by a run.
json read_run(const fs::path& description) {
  std::ifstream in(description);
  json run = json::parse(in, nullptr, false);
  return run.is_object() && run.contains("/scene/run"_json_pointer) && run.contains("/provenance/program"_json_pointer) ? run : json();
}

double number_at(const json& run, const char* place) {
  const json::json_pointer at(place);
  return run.is_object() && run.contains(at) && run[at].is_number() ? run[at].get<double>() : 0;
}

std::string text_at(const json& run, const char* place) {
  const json::json_pointer at(place);
  return run.is_object() && run.contains(at) && run[at].is_string() ? run[at].get<std::string>() : std::string();
}

/// The scene without what may differ between a run and the one that goes on with it (as scene_fingerprint).
json what_decides(json scene) {
  scene.erase("file");
  scene["run"].erase("end_s");
  scene["run"].erase("checkpoint_every_frames");
  return scene;
}

/// A member of a list by its name, if it has one: material.dough.
std::string place_of(const std::string& list, std::size_t index, const json& member) {
  const auto name = member.is_object() ? member.find("name") : member.end();
  const bool named = name != member.end() && name->is_string();
  return fmt::format("{}{}{}", list, list.empty() ? "" : ".", named ? name->get<std::string>() : std::to_string(index));
}

/// The first key whose values differ, in the order of the alphabet; empty if none does.
std::string first_difference(const json& now, const json& then, const std::string& key = {}) {
  if (now == then) return {};
  const auto within = [&](const std::string& name) { return key.empty() ? name : fmt::format("{}.{}", key, name); };
  if (now.is_object() && then.is_object()) {
    for (const auto& [name, value] : now.items()) {
      std::string found = first_difference(value, then.value(name, json()), within(name));
      if (!found.empty()) return found;
    }
    for (const auto& [name, value] : then.items())
      if (!now.contains(name)) return first_difference(json(), value, within(name));
  }
  const bool lists = now.is_array() && then.is_array() && now.size() == then.size();
  for (std::size_t i = 0; lists && i < now.size() && now[i].is_object(); ++i) {
    std::string found = first_difference(now[i], then[i], place_of(key, i, now[i]));
    if (!found.empty()) return found;
  }
  const auto words = [](const json& value) {
    const std::string text = default_text(value);
    return text.size() <= 80 ? text : text.substr(0, 77) + "...";
  };
  return fmt::format("{}: found {}, there {}", key, words(now), words(then));
}

/// The number of a frame's file, or of what is left of one that was being written: 42 of "0042.hdf".
std::optional<int> frame_number(const fs::path& file) {
  const std::string name = file.filename().string();
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (error != std::errc() || number < 0) return {};
  if (name != frame_name(number) && name != frame_name(number) + ".part") return {};
  return number;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InputError(folder.string() + ": cannot make this folder: " + error.message() + ", allowed: a place that can be written (--out)");
}

void remove_frames_from(const fs::path& folder, int first) {
  std::error_code ignored;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (frame_number(entry.path()).value_or(-1) >= first) files.push_back(entry.path());
  for (const fs::path& file : files)
    if (!fs::is_directory(file, ignored)) fs::remove(file, ignored);
}

}  // namespace

fs::path ResultsFolder::frame(int number) const { return frames() / frame_name(number); }

fs::path ResultsFolder::skin(int number) const { return skins() / frame_name(number); }

bool ResultsFolder::has_checkpoint() const {
  std::error_code ignored;
  return fs::exists(checkpoint(), ignored);
}

bool ResultsFolder::is_done() const { return text_at(read_run(description()), "/summary/state") == "done"; }

std::string ResultsFolder::difference(const Scene& scene) const {
  const json run = read_run(description());
  if (run.is_null()) return {};
  const json now = what_decides(resolved(scene)), then = what_decides(run["scene"]);
  return under_former_names(now) == under_former_names(then) ? std::string() : first_difference(now, then);
}

bool ResultsFolder::is_marked() const {
  std::error_code ignored;
  return fs::exists(mark(), ignored) || !read_run(description()).is_null();  // versions up to 0.2 left no other mark
}

void ResultsFolder::refuse_what_no_run_made() const {
  std::error_code ignored;
  for (const fs::path& path : {frames(), series(), skins(), skin_series(), ledger(), checkpoint(), description()}) {
    if (!fs::exists(path, ignored) || (fs::is_directory(path, ignored) && fs::is_empty(path, ignored))) continue;
    throw InputError(path.string() + ": is there already, and not from a run of Bake, allowed: another folder (--out)");
  }
}

void ResultsFolder::refuse_to_replace(const Scene& scene, double end_s, Replace replace) const {
  const json run = read_run(description());
  const bool done = is_done();
  if (run.is_null() || replace == Replace::any_run || !(done || has_checkpoint())) return;
  const std::string file = fs::path(text_at(run, "/scene/file")).filename().string();
  const bool same_file = file == scene.file.filename().string();
  if (same_file && replace == Replace::same_file) return;
  std::string other = difference(scene);
  if (const double reached = number_at(run, "/summary/time_s"); other.empty() && done && end_s < (1 - 1e-9) * reached)
    other = fmt::format("its end: found {:g} s, there {:g} s", end_s, reached);
  if (other.empty()) return;
  throw InputError(fmt::format("{}: here are the results of {} ({}), allowed: another --out, or bake run --overwrite", folder_.string(),
                               same_file ? "other values of the scene" : file, other));
}

void ResultsFolder::take(const Scene& scene, double end_s, Replace replace) {
  if (!is_marked()) refuse_what_no_run_made();
  make_folder(folder_);
  lock_.emplace(mark());
  refuse_to_replace(scene, end_s, replace);
}

void ResultsFolder::take_to_resume() { lock_.emplace(mark()); }

void ResultsFolder::clear() const {
  std::error_code ignored;
  for (const fs::path& file : {series(), skin_series(), ledger(), checkpoint(), description()})
    if (!fs::is_directory(file, ignored)) fs::remove(file, ignored);
  remove_frames_from(frames(), 0);
  make_folder(frames());
  remove_frames_from(skins(), 0);
  fs::remove(skins(), ignored);  // if it is empty
}

void ResultsFolder::make_skins() const { make_folder(skins()); }

void ResultsFolder::remove_frames_behind(int last) const {
  remove_frames_from(frames(), last + 1);
  remove_frames_from(skins(), last + 1);
}

void ResultsFolder::expect_whole(const FrameTimes& times, int last) const {
  const Ledger ledger = read_ledger(this->ledger());
  const auto same = [&](double time, int frame) { return std::abs(time - times(frame)) <= 1e-6 * times(1); };
  for (int f = 0; f <= last; ++f) {
    const auto row = static_cast<std::size_t>(f);
    if (row >= ledger.rows.size())
      throw InputError(
          fmt::format("{}: found {} rows, allowed: one for each of the frames 0 to {}", this->ledger().string(), ledger.rows.size(), last));
    if (const double time = ledger.rows[row].front(); !same(time, f))
      throw InputError(fmt::format("{}:{}: found the time {:g} s, allowed: {:g} s, that of frame {}", this->ledger().string(), row + 2,
                                   time, times(f), f));
    for (std::size_t c = 0; c < ledger.columns.size(); ++c)
      if (!std::isfinite(ledger.rows[row][c]))
        throw InputError(fmt::format("{}:{}: found {} for {}, allowed: a number", this->ledger().string(), row + 2, ledger.rows[row][c],
                                     ledger.columns[c]));
    std::error_code ignored;
    if (!fs::is_regular_file(frame(f), ignored))
      throw InputError(fmt::format("{}: is missing, allowed: all of the frames 0 to {}", frame(f).string(), last));
    if (const double time = FrameReader(frame(f)).time_s(); !same(time, f))
      throw InputError(fmt::format("{}: found the time {:g} s, allowed: {:g} s", frame(f).string(), time, times(f)));
  }
}

}  // namespace bake
