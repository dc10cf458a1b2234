// SPDX-License-Identifier: MIT
// The study of accuracy: what an error costs, for every setting that can be chosen.
#include <fmt/format.h>

#include <map>
#include <optional>

#include "experiments/accuracy/result.h"
#include "experiments/common/study.h"
#include "solver/core/errors.h"
#include "solver/core/tell.h"
#include "solver/io/atomic_file.h"
#include "solver/io/provenance.h"
#include "solver/scene/scene.h"

namespace bake::studies {

namespace accuracy {

namespace {

constexpr int k_quick_repeats = 2;

Effort effort_of(const StudyOptions& options) { return options.quick ? Effort::quick : options.full ? Effort::full : Effort::usual; }

std::vector<const Case*> chosen(const StudyOptions& options) {
  std::vector<const Case*> cases;
  for (const std::string& name : options.cases) cases.push_back(&find_case(name));
  if (!cases.empty()) return cases;
  for (const Case& c : all_cases())
    if (c.from <= effort_of(options)) cases.push_back(&c);
  return cases;
}

/// A variant that is to be measured.
struct Task {
  const Case* of;
  RawData* raw;
  Variant variant;
  Scene scene;
  Identity identity;

  /// A run that fails fails again.
  bool needed(int pass) const {
    const auto& done = raw->of(identity);
    if (static_cast<int>(done.size()) > pass) return false;
    return done.empty() || done.front().at("found").at("failure").get<std::string>().empty();
  }
};

/// In passes over all variants, so that whatever else the machine does meets all alike; its own speed is measured before each pass.
/// Returns how many were measured.
int measure(std::vector<Task>& tasks, int repeats) {
  int measured = 0;
  for (int pass = 0; pass < repeats; ++pass) {
    std::optional<bench::Speed> speed;
    for (Task& t : tasks) {
      if (!t.needed(pass)) continue;
      if (!speed) speed = bench::measure_speed(1);
      const Found found = t.of->measure(t.scene, t.variant.by);
      t.raw->append(t.identity, found, *speed);
      ++measured;
      tell_user("{}, {}, {} cells, {} of {}: {}; {:.2g} particle-steps, {:.2g} s", t.of->name, t.variant.label, t.variant.cells, pass + 1,
                repeats, found.failure.empty() ? "error " + percent(found.error) : found.failure, static_cast<double>(found.particle_steps),
                found.wall_s);
    }
  }
  return measured;
}

void write(const std::vector<CaseResult>& results, const std::filesystem::path& out) {
  nlohmann::json cases = nlohmann::json::array();
  for (const CaseResult& r : results) cases.push_back(as_json(r));
  const nlohmann::json made = provenance();
  std::filesystem::create_directories(out);
  write_text_atomically(
      out / "accuracy.json",
      nlohmann::json{{"study", "accuracy"}, {"provenance", made}, {"speed", as_json(speed_of(results))}, {"cases", cases}}.dump(1) + "\n");
  write_text_atomically(out / "accuracy.md", as_markdown(results, made));
  try {
    for (const CaseResult& r : results) write_charts(r, out / "accuracy");
  } catch (const InputError& error) {  // without gnuplot the tables are as good
    tell_user("charts are left out: {}", error.what());
  }
}

bool judge(const CaseResult& r) {
  fmt::print("{}\n", r.of().name);
  for (const std::string& sentence : conclusions(r)) fmt::print("  {}\n", sentence);
  if (!r.same_errors()) fmt::print("  MISSED: a repeat found another error\n");
  if (!r.falls()) fmt::print("  MISSED: the default's error does not fall with dx\n");
  return r.same_errors() && r.falls();
}

}  // namespace

}  // namespace accuracy

bool run_accuracy(const StudyOptions& options) {
  using namespace accuracy;
  const auto folder = options.out / "accuracy";
  if (!options.reference.empty()) {
    const Case& c = find_case(options.reference);
    if (!c.make_reference) throw InputError(fmt::format("--reference: found \"{}\", allowed: a case without an exact solution", c.name));
    c.make_reference(folder);
    return true;
  }
  std::map<std::string, RawData> raw;
  const std::vector<const Case*> cases = chosen(options);
  for (const Case* c : cases) raw.try_emplace(c->name, folder, c->name);
  std::vector<Task> tasks;
  for (const Case* c : cases) {
    if (const std::string why = c->missing(); !why.empty()) {
      tell_user("{}: left out: {}", c->name, why);
      continue;
    }
    for (const Variant& v : variants_of(*c, effort_of(options))) {
      Scene scene = c->scene_of(v);
      const Identity identity = identity_of(*c, v, scene);
      tasks.push_back({c, &raw.at(c->name), v, std::move(scene), identity});
    }
  }
  const int measured = measure(tasks, options.quick ? k_quick_repeats : k_repeats);
  if (options.measure_only) {
    fmt::print("{} measured now; the page is left to a call without --measure-only\n", measured);
    return true;
  }
  std::vector<CaseResult> results;
  for (const Case& c : all_cases()) {
    raw.try_emplace(c.name, folder, c.name);  // those that were not chosen are in the page, too
    if (CaseResult r(c, raw.at(c.name)); !r.empty()) results.push_back(std::move(r));
  }
  write(results, options.out);
  bool held = true;
  for (const CaseResult& r : results) held &= judge(r);
  fmt::print("{}; {} measured now; written to {}\n", held ? "errors are the same in every repeat and fall with dx" : "NOT all holds",
             measured, options.out.string());
  return held;
}

}  // namespace bake::studies
