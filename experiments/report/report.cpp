// SPDX-License-Identifier: MIT
#include "experiments/report/report.h"

#include <fmt/format.h>

#include "experiments/make/figure_paths.h"
#include "experiments/report/sections.h"
#include "experiments/report/style.h"
#include "solver/core/errors.h"
#include "solver/io/json_fault.h"
#include "solver/io/provenance.h"

namespace bake::report {
namespace {

using nlohmann::json;

ReportedItem reported(const Item& item, Quality quality) {
  const auto folder = item_folder(item, quality);
  return {&item, folder, item.status == ItemStatus::done ? read_json(folder / "claims.json") : std::nullopt};
}

int& count_of(ReportPage& report, ItemVerdict verdict) {
  if (verdict == ItemVerdict::reproduced) return report.reproduced;
  if (verdict == ItemVerdict::not_reproduced) return report.not_reproduced;
  return verdict == ItemVerdict::not_run ? report.not_run : report.not_there_yet;
}

Html counts(const ReportPage& report) {
  const auto one = [](ItemVerdict verdict, int count) {
    return element("li", join({element("strong", text(std::to_string(count))), text(" "), badge(verdict)}));
  };
  return element("ul",
                 join({one(ItemVerdict::reproduced, report.reproduced), one(ItemVerdict::not_reproduced, report.not_reproduced),
                       one(ItemVerdict::not_run, report.not_run), one(ItemVerdict::not_there_yet, report.not_there_yet)}),
                 "class=\"counts\"");
}

Html overview(const std::vector<ReportedItem>& items, const ReportPage& report) {
  std::vector<std::vector<Html>> rows;
  rows.reserve(items.size());
  for (const ReportedItem& one : items)
    rows.push_back({element("a", text(one.item->number), fmt::format("href=\"#{}\"", anchor(*one.item))), text(one.item->shows),
                    badge(one.verdict())});
  return element("section", join({element("h2", text("The paper's figures and tables, and experiments beside them")), counts(report),
                                  table({"item", "what it shows", "verdict"}, rows)}));
}

Html heading(Quality quality) {
  const json made = provenance();
  const std::string date = made["date"], commit = made["program"]["commit"], cpu = made["machine"]["cpu"], os = made["machine"]["os"];
  return element(
      "header",
      join(
          {element("h1", text("Baking and cooking, reproduced")),
           element(
               "p",
               join({text("This page shows how far Bake, an open implementation of M. Ding, X. Han, S. Wang, T. F. Gast and J. M. Teran, "),
                     element("cite", text("A thermomechanical material point method for baking and cooking")),
                     text(" (ACM Transactions on Graphics 38 (6), 2019), reproduces the paper: each of its figures and tables with "
                          "what the paper claims, what was measured, and the verdict.")})),
           element("p",
                   text(fmt::format("Quality {}; written {} by commit {} on {}, {} threads, {}.", word_of(quality), date.substr(0, 10),
                                    commit.substr(0, 10), cpu, made["machine"]["logical_cores"].get<int>(), os)),
                   "class=\"soft\"")}));
}

Html page(const std::vector<Html>& main) {
  const Html head = join({{"<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"},
                          element("title", text("Bake: the report")),
                          element("style", {k_style})});
  const Html foot =
      element("footer", element("p",
                                text("Evidence is analytic, published or measured; a regression only tells that a number changed. "
                                     "Made by ./bake report."),
                                "class=\"soft\""));
  std::vector<Html> rest(main.begin() + 1, main.end());
  const Html body = join({main.front(), element("main", join(rest)), foot});
  return {"<!DOCTYPE html>\n" + element("html", join({element("head", head), element("body", body)}), "lang=\"en\"").code};
}

/// Turns errors about JSON that bake did not write into InputError.
Html section_of(const ReportedItem& item) {
  try {
    return item_section(item);
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: not what bake figure writes: {}", (item.folder / "claims.json").string(), json_fault(error)));
  }
}

}  // namespace

ReportPage make_report(const Items& items, Quality quality) {
  ReportPage report;
  std::vector<ReportedItem> all, missing;
  std::vector<Html> sections;
  for (const Item& item : items.items) {
    all.push_back(reported(item, quality));
    const ItemVerdict verdict = all.back().verdict();
    ++count_of(report, verdict);
    if (verdict == ItemVerdict::not_there_yet)
      missing.push_back(all.back());
    else
      sections.push_back(section_of(all.back()));
  }
  std::vector<Html> parts{heading(quality), overview(all, report)};
  parts.insert(parts.end(), sections.begin(), sections.end());
  for (const auto& section : {orders_section, accuracy_section, departures_section, stability_section, effects_section})
    parts.push_back(section(items.root));
  parts.push_back(missing_section(missing));
  report.page = page(parts).code;
  return report;
}

}  // namespace bake::report
