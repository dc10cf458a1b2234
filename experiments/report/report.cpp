// SPDX-License-Identifier: MIT
#include "experiments/report/report.h"

#include <fmt/format.h>

#include "experiments/make/figure_paths.h"
#include "experiments/report/object_figure.h"
#include "experiments/report/sections.h"
#include "experiments/report/sources.h"
#include "experiments/report/statements.h"
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

Html link_of(const ReportedItem& one, const Html& words) { return {fmt::format("<a href=\"#{}\">{}</a>", anchor(*one.item), words.code)}; }

/// What was made, in order of its verdict: item and verdict on one line, below it what it shows.
Html overview(const std::vector<ReportedItem>& items, const ReportPage& report) {
  std::vector<Html> lines;
  for (const ItemVerdict verdict : {ItemVerdict::reproduced, ItemVerdict::not_reproduced, ItemVerdict::not_run})
    for (const ReportedItem& one : items)
      if (one.verdict() == verdict)
        lines.push_back(element("li", join({element("div", join({link_of(one, text(heading_of(one))), text(" "), badge(one)})),
                                            element("p", text(one.item->shows), "class=\"soft\"")})));
  std::vector<Html> rest;
  for (const ReportedItem& one : items)
    if (one.verdict() == ItemVerdict::not_there_yet) {
      if (!rest.empty()) rest.push_back(text(", "));
      rest.push_back(link_of(one, text(one.item->number)));
    }
  const Html missing = rest.empty() ? Html{} : element("p", join({text("Not there yet: "), join(rest), text(".")}), "class=\"soft\"");
  return element("section",
                 join({element("h2", text("The paper's figures and tables, and experiments beside them")), counts(report),
                       element("ul", join(lines), "class=\"items\""), missing}),
                 "id=\"overview\"");
}

/// A line of links that stays in sight.
Html way_about(const std::vector<ReportedItem>& items) {
  std::vector<Html> links{element("a", text("overview"), "href=\"#overview\"")};
  constexpr std::array k_signs{"✓", "✗", "○", "○"};
  for (const ReportedItem& one : items)
    if (one.verdict() != ItemVerdict::not_there_yet)
      links.push_back(link_of(one, text(fmt::format("{}\u00a0{}", one.item->number, k_signs[static_cast<std::size_t>(one.verdict())]))));
  return element("nav", join(links), "aria-label=\"figures and tables\"");
}

/// What a reader sees first: one picture and one sentence.
Html first_sight(const std::vector<ReportedItem>& items) {
  std::size_t held = 0, all = 0;
  Html shown;
  for (const ReportedItem& one : items) {
    if (!one.made) continue;
    for (const Statement& statement : statements_of(one.made->at("claims"))) {
      ++all;
      held += statement.holds();
    }
    const json& pictures = one.made->at("pictures");
    if (pictures.empty() || !shown.code.empty()) continue;
    const json objects = objects_of(*one.made);
    const std::string file =
        objects.empty() ? pictures.front().at("file").get<std::string>() : objects.front().at("picture").get<std::string>() + ".png";
    shown = link_of(one, picture(one.folder / file, heading_of(one)));
  }
  if (all == 0) return {};
  const std::string words =
      fmt::format("{} of {} statements hold: what the paper says of its figures, and what follows from it.", held, all);
  return element("div", join({shown, element("p", text(words), "class=\"lead\"")}), "class=\"first\"");
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

/// The browser itself refuses any request: what is not in the page is not there.
constexpr const char* k_policy =
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'; "
    "script-src 'unsafe-inline'; base-uri 'none'; form-action 'none'\">\n<link rel=\"icon\" href=\"data:,\">\n";

/// `data`: of bodies; they stand behind what is seen, and the viewer behind them.
Html page(const Html& header, const Html& nav, const std::vector<Html>& main, const std::vector<Html>& data) {
  const Html head = join({{"<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"},
                          {k_policy},
                          {"<meta name=\"color-scheme\" content=\"light dark\">\n"},
                          element("title", text("Bake: the report")),
                          element("style", {k_style}),
                          element("noscript", element("style", {"figure.body canvas, figure.body .controls { display: none; }"}))});
  const Html foot =
      element("footer", element("p",
                                text("Evidence is analytic, published or measured; a regression only tells that a number changed. "
                                     "One file; nothing is loaded from anywhere. Made by ./bake report."),
                                "class=\"soft\""));
  const Html body = join({header, nav, element("main", join(main)), foot, join(data), element("script", {k_viewer})});
  return {"<!DOCTYPE html>\n" + element("html", join({element("head", head), element("body", body)}), "lang=\"en\"").code};
}

/// Turns errors about JSON that bake did not write into InputError.
Html section_of(const ReportedItem& item, std::vector<Html>& data) {
  try {
    return item_section(item, data);
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: not what bake figure writes: {}", (item.folder / "claims.json").string(), json_fault(error)));
  }
}

}  // namespace

ReportPage make_report(const Items& items, Quality quality) {
  ReportPage report;
  std::vector<ReportedItem> all, missing;
  std::vector<Html> sections, data;
  for (const Item& item : items.items) {
    all.push_back(reported(item, quality));
    const ItemVerdict verdict = all.back().verdict();
    ++count_of(report, verdict);
    if (verdict == ItemVerdict::not_there_yet)
      missing.push_back(all.back());
    else
      sections.push_back(section_of(all.back(), data));
  }
  std::vector<Html> parts{first_sight(all), overview(all, report)};
  parts.insert(parts.end(), sections.begin(), sections.end());
  for (const auto& section : {orders_section, accuracy_section, departures_section, stability_section, effects_section})
    parts.push_back(section(items.root));
  parts.push_back(missing_section(missing));
  report.page = page(heading(quality), way_about(all), parts, data).code;
  return report;
}

}  // namespace bake::report
