// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/report/object_figure.h"
#include "experiments/report/sections.h"
#include "experiments/report/statements.h"
#include "experiments/report/time_chart.h"
#include "solver/scene/entry.h"

namespace bake::report {
namespace {

using nlohmann::json;

double number_in(const json& value) { return value.is_number() ? value.get<double>() : std::nan(""); }

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

/// "loaf.svg" becomes "loaf.csv".
std::filesystem::path csv_beside(std::filesystem::path file) { return file.replace_extension(".csv"); }

/// A link that saves the numbers of a chart.
Html data_link(const std::filesystem::path& csv) {
  if (!std::filesystem::exists(csv)) return {};
  return element("a", text("numbers (CSV)"),
                 fmt::format("class=\"soft\" download=\"{}\" href=\"{}\"", text(csv.filename().string()).code,
                             data_address("text/csv", read_text_file(csv))));
}

/// A chart: over time drawn here, in the page's colours, else as gnuplot drew it.
Html chart(const std::filesystem::path& svg, const std::string& shows, const std::string& follows) {
  const std::filesystem::path csv = csv_beside(svg);
  const auto over_time = std::filesystem::exists(csv) ? read_time_chart(csv) : std::nullopt;
  return element("figure", join({over_time ? drawn(*over_time, shows, follows) : picture(svg, shows),
                                 element("figcaption", join({text(shows + " "), data_link(csv)}))}));
}

Html charts(const json& files, const std::filesystem::path& folder, const std::string& follows) {
  std::vector<Html> parts;
  for (const json& file : files)
    parts.push_back(chart(folder / file.at("file").get<std::string>(), file.at("shows").get<std::string>(), follows));
  return parts.empty() ? Html{} : element("div", join(parts), "class=\"plots\"");
}

/// The pictures but those that stand for a body. The other kinds, cuts with numbers and montages, need the whole width.
Html pictures(const json& made, const std::filesystem::path& folder) {
  std::vector<std::string> taken;
  for (const json& object : objects_of(made)) taken.push_back(object.at("picture").get<std::string>() + ".png");
  std::vector<Html> parts;
  for (const json& file : made.at("pictures")) {
    const std::string name = file.at("file"), shows = file.at("shows");
    if (std::find(taken.begin(), taken.end(), name) != taken.end()) continue;
    const bool is_wide = file.value("kind", "picture") != "picture";
    parts.push_back(element("figure", join({picture(folder / name, shows), element("figcaption", text(shows))}),
                            is_wide ? "class=\"whole-width\"" : ""));
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

/// A command, with a button that copies it where there is a script.
Html command(const std::string& words) {
  return join({element("code", text(words)), text(" "),
               element("button", text("copy"), fmt::format("class=\"copy\" type=\"button\" data-copy=\"{}\" hidden", text(words).code))});
}

/// "3 runs, 9 460 to 9 781 particles, 2.4 minutes on Abacus."
std::string cost(const json& runs) {
  double least = INFINITY, most = 0, seconds = 0;
  for (const json& run : runs) {
    least = std::min(least, number_in(run.at("particles")));
    most = std::max(most, number_in(run.at("particles")));
    seconds += number_in(run.at("seconds"));
  }
  const std::string cpu = runs.front().at("provenance").at("machine").at("cpu");
  return fmt::format("{} run{}, {} particles, {:.1f} minutes on {}.", runs.size(), runs.size() == 1 ? "" : "s",
                     least == most ? number(most) : number(least) + " to " + number(most), seconds / 60, cpu);
}

/// Who made it, of what and with which command, in one fold.
Html provenance_of(const json& made) {
  const json& by = made.at("provenance");
  std::vector<Html> parts{element("summary", text("How it was made"))};
  parts.push_back(element(
      "p", join({text("Made by "),
                 command("./bake figure " + made.at("name").get<std::string>() + " --quality " + made.at("quality").get<std::string>()),
                 text(fmt::format(" on {} with commit {}.", by.at("date").get<std::string>().substr(0, 10),
                                  by.at("program").at("commit").get<std::string>().substr(0, 10)))})));
  if (!made.at("runs").empty()) {
    parts.push_back(element("p", text(cost(made.at("runs"))), "class=\"soft\""));
    parts.push_back(runs_table(made.at("runs")));
  }
  return element("details", join(parts));
}

Html made_parts(const ReportedItem& reported, std::vector<Html>& data) {
  const json& made = *reported.made;
  const std::string place = anchor(*reported.item);
  std::vector<Html> bodies;
  for (const json& object : objects_of(made)) bodies.push_back(object_figure(object, place, reported.folder, data));
  const Html statements =
      element("div", join({element("h3", text("What is claimed, and what was measured")), cards(statements_of(made.at("claims")), place)}),
              "class=\"statements\"");
  const std::string follows = bodies.empty() ? "" : object_anchor(objects_of(made).front(), place);
  const Html top = bodies.empty() ? statements : element("div", join({element("div", join(bodies)), statements}), "class=\"side\"");
  std::vector<Html> beside;
  for (const json& object : objects_of(made)) beside.push_back(followers(object, place));
  const Html shown = pictures(made, reported.folder), drawn = charts(made.at("charts"), reported.folder, follows);
  // what moves, or else pictures, come before words; charts stand beside the time that they share
  if (bodies.empty())
    return join({the_paper(made.at("shows")), shown, drawn, computed_tables(made.at("tables")), top, provenance_of(made)});
  return join({the_paper(made.at("shows")), top, join(beside), drawn, shown, computed_tables(made.at("tables")), provenance_of(made)});
}

Html not_run_parts(const Item& item) {
  return join({the_paper(item.shows), element("p", join({text("Made by "), command("./bake figure " + item.name), text(".")}))});
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
  return element("span", text(holds ? "✓ holds" : "✗ missed"), holds ? "class=\"verdict good\"" : "class=\"verdict bad\"");
}

Html badge(ItemVerdict verdict) {
  constexpr std::pair<const char*, const char*> k_words[] = {
      {"✓ reproduced", "good"}, {"✗ not reproduced", "bad"}, {"○ not run", "none"}, {"○ not there yet", "none"}};
  const auto& [words, look] = k_words[static_cast<std::size_t>(verdict)];
  return element("span", text(words), fmt::format("class=\"verdict {}\"", look));
}

Html badge(const ReportedItem& reported) {
  if (reported.verdict() != ItemVerdict::not_reproduced) return badge(reported.verdict());
  const std::vector<Statement> statements = statements_of(reported.made->at("claims"));
  const auto held = std::count_if(statements.begin(), statements.end(), [](const Statement& s) { return s.holds(); });
  return element("span", text(fmt::format("✗ {} of {} statements", held, statements.size())), "class=\"verdict bad\"");
}

Html link_to(const std::string& anchor, std::string_view words) {
  return element("a", text("#"), fmt::format("class=\"deep\" href=\"#{}\" aria-label=\"link to {}\"", anchor, text(words).code));
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

Html item_section(const ReportedItem& reported, std::vector<Html>& data) {
  const std::string place = anchor(*reported.item);
  const Html heading = element("h2", join({text(heading_of(reported)), link_to(place, reported.item->number), badge(reported)}));
  return element("section", join({heading, reported.made ? made_parts(reported, data) : not_run_parts(*reported.item)}),
                 fmt::format("id=\"{}\"", place));
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
  const Html summary = element(
      "summary", text(fmt::format("Not there yet: {}", missing.size() == 1 ? "one item" : std::to_string(missing.size()) + " items")));
  return element("section", element("details", join({summary, table({"item", "the paper", "what is to be measured"}, rows)})),
                 "id=\"missing\"");
}

}  // namespace bake::report
