// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/report/sections.h"

namespace bake::report {
namespace {

using nlohmann::json;

double number_in(const json& value) { return value.is_number() ? value.get<double>() : std::nan(""); }

/// What a claim measures ("volume gain"), of which run, and what that means.
Html what_was_measured(const json& claim) {
  std::string name = claim.at("metric");
  std::replace(name.begin(), name.end(), '_', ' ');
  const std::string of = claim.at("of");
  const Html head = of.empty() ? text(name) : join({text(name + " of "), element("code", text(of))});
  return join({head, element("div", text(claim.at("meaning").get<std::string>()), "class=\"soft\"")});
}

/// Why it is claimed; before that, why there is no number.
std::string reason(const json& claim) {
  const std::string problem = claim.value("problem", ""), why = claim.at("why");
  return problem.empty() ? why : problem + "; " + why;
}

Html claims_table(const json& claims) {
  std::vector<std::vector<Html>> rows;
  for (const json& claim : claims) {
    const std::string unit = claim.at("unit");
    rows.push_back({what_was_measured(claim),
                    text(number(number_in(claim.at("measured"))) + (unit == "1" || unit.empty() ? "" : " " + unit)),
                    text(claim.at("condition").get<std::string>()), badge(claim.at("holds").get<bool>()),
                    text(claim.at("kind").get<std::string>()), text(reason(claim))});
  }
  return table({"measured", "value", "claim", "verdict", "evidence", "why"}, rows);
}

Html runs_table(const json& runs) {
  std::vector<std::vector<Html>> rows;
  for (const json& run : runs) {
    const json& made = run.at("provenance");
    const std::string commit = made.at("program").at("commit");
    rows.push_back({element("code", text(run.at("name").get<std::string>())), text(number(number_in(run.at("particles")))),
                    text(number(number_in(run.at("simulated_s"))) + " s"), text(number(number_in(run.at("steps")))),
                    text(fmt::format("{:.0f} s", number_in(run.at("seconds")))), text(std::to_string(made.value("threads", 0))),
                    text(made.at("machine").at("cpu").get<std::string>()), element("code", text(commit.substr(0, 10)))});
  }
  return table({"run", "particles", "simulated", "steps", "time", "threads", "machine", "commit"}, rows);
}

Html figures_of(const json& files, const std::filesystem::path& folder) {
  std::vector<Html> parts;
  for (const json& file : files) {
    const std::string shows = file.at("shows");
    parts.push_back(
        element("figure", join({picture(folder / file.at("file").get<std::string>(), shows), element("figcaption", text(shows))})));
  }
  return parts.empty() ? Html{} : element("div", join(parts), "class=\"pictures\"");
}

Html computed_tables(const json& tables) {
  std::vector<Html> parts;
  for (const json& one : tables) {
    std::vector<std::vector<Html>> rows;
    for (const json& row : one.at("rows")) {
      rows.emplace_back();
      for (const json& cell : row) rows.back().push_back(text(cell.get<std::string>()));
    }
    parts.push_back(table(one.at("header").get<std::vector<std::string>>(), rows, one.at("title").get<std::string>()));
  }
  return join(parts);
}

Html the_paper(const std::string& shows) { return element("p", join({element("strong", text("The paper: ")), text(shows)})); }

Html made_parts(const json& made, const std::filesystem::path& folder) {
  std::vector<Html> parts{the_paper(made.at("shows")),           figures_of(made.at("pictures"), folder),
                          figures_of(made.at("charts"), folder), computed_tables(made.at("tables")),
                          element("h3", text("Claims")),         claims_table(made.at("claims"))};
  if (!made.at("runs").empty()) {
    parts.push_back(element("h3", text(fmt::format("Runs, quality {}", made.at("quality").get<std::string>()))));
    parts.push_back(runs_table(made.at("runs")));
  }
  return join(parts);
}

Html not_run_parts(const Item& item) {
  return join(
      {the_paper(item.shows), element("p", join({text("Made by "), element("code", text("./bake figure " + item.name)), text(".")}))});
}

std::string capital(std::string words) {
  words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

}  // namespace

ItemVerdict ReportedItem::verdict() const {
  if (!made) return item->status == ItemStatus::done ? ItemVerdict::not_run : ItemVerdict::not_there_yet;
  const auto& claims = made->at("claims");
  const bool all = std::all_of(claims.begin(), claims.end(), [](const json& claim) { return claim.at("holds").get<bool>(); });
  return all && !claims.empty() ? ItemVerdict::reproduced : ItemVerdict::not_reproduced;
}

Html badge(bool holds) {
  return element("span", text(holds ? "holds" : "missed"), holds ? "class=\"verdict good\"" : "class=\"verdict bad\"");
}

Html badge(ItemVerdict verdict) {
  constexpr std::pair<const char*, const char*> k_words[] = {
      {"reproduced", "good"}, {"not reproduced", "bad"}, {"not run", "none"}, {"not there yet", "none"}};
  const auto& [words, look] = k_words[static_cast<std::size_t>(verdict)];
  return element("span", text(words), fmt::format("class=\"verdict {}\"", look));
}

std::string anchor(const Item& item) {
  std::string name = item.number;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string heading_of(const ReportedItem& reported) {
  std::string title = reported.made ? reported.made->at("title").get<std::string>() : reported.item->name;
  if (!reported.made) std::replace(title.begin(), title.end(), '_', ' ');
  return capital(reported.item->number) + ": " + title;
}

Html item_section(const ReportedItem& reported) {
  const Html heading = element("h2", join({text(heading_of(reported)), badge(reported.verdict())}));
  return element("section", join({heading, reported.made ? made_parts(*reported.made, reported.folder) : not_run_parts(*reported.item)}),
                 fmt::format("id=\"{}\"", anchor(*reported.item)));
}

Html missing_section(const std::vector<ReportedItem>& missing) {
  if (missing.empty()) return {};
  std::vector<std::vector<Html>> rows;
  for (const ReportedItem& reported : missing) {
    std::vector<Html> claims;
    for (const std::string& claim : reported.item->claims) claims.push_back(element("li", text(claim)));
    rows.push_back({element("strong", text(heading_of(reported)), fmt::format("id=\"{}\"", anchor(*reported.item))),
                    text(reported.item->shows), element("ul", join(claims))});
  }
  return element("section", join({element("h2", text("Not there yet")), table({"item", "the paper", "what is to be measured"}, rows)}));
}

}  // namespace bake::report
