// SPDX-License-Identifier: MIT
#include "experiments/report/object_figure.h"

#include <fmt/format.h>

#include "experiments/report/body.h"
#include "experiments/report/time_chart.h"

namespace bake::report {
namespace {

using nlohmann::json;

/// The anchors of an object's bodies: the first has the object's own.
std::vector<std::string> anchors_of(const json& object, const std::string& place) {
  std::vector<std::string> anchors;
  for (std::size_t i = 0; i < object.at("of").size(); ++i)
    anchors.push_back(object_anchor(object, place) + (i == 0 ? "" : fmt::format("-{}", i + 1)));
  return anchors;
}

std::vector<std::string> titles_of(const json& object) {
  const auto names = object.at("of").get<std::vector<std::string>>();
  std::vector<std::string> titles;
  for (const std::string& name : names) titles.push_back(short_name(name, common_start(names)));
  return titles;
}

Html data_of(const PackedBody& body, const std::string& id) {
  const std::string_view bytes(reinterpret_cast<const char*>(body.bytes.data()), body.bytes.size());
  std::string head = body.head.dump();
  for (std::size_t at; (at = head.find('<')) != std::string::npos;) head.replace(at, 1, "\\u003c");  // nothing ends the script
  return join({element("script", {head}, fmt::format("type=\"application/json\" id=\"{}-head\"", id)),
               element("script", {base64(bytes)}, fmt::format("type=\"text/plain\" id=\"{}-bytes\"", id))});
}

/// A choice of colours, as buttons of which one is pressed.
Html colours(const json& fields, const std::string& id) {
  std::string code = "<legend>colour</legend>";
  for (const auto& [name, words] :
       {std::pair{"browning", "as baked"}, {"temperature", "temperature"}, {"saturation", "water"}, {"porosity", "gas"}})
    for (const json& field : fields)
      if (field.at("name") == name)
        code += fmt::format("<label><input type=\"radio\" name=\"by-{}\" value=\"{}\"><span>{}</span></label>", id, name, words);
  return element("fieldset", {code}, "class=\"pills\"");
}

Html controls(const PackedBody& body, const std::string& id) {
  std::string marks;
  for (const json& frame : body.head.at("frames")) marks += fmt::format("<option value=\"{}\"></option>", frame.at("time").get<double>());
  const double first = body.head.at("frames").front().at("time"), last = body.head.at("frames").back().at("time");
  const std::string shape = body.head.at("particles") == 0
                                ? ""
                                : "<label>shape <select class=\"shape\"><option value=\"surface\">surface</option>"
                                  "<option value=\"particles\">particles</option></select></label>";
  return element("div",
                 join({{fmt::format("<button type=\"button\" class=\"play\" aria-label=\"play\">▶</button>"
                                    "<input class=\"time\" type=\"range\" aria-label=\"time\" min=\"{0}\" max=\"{1}\" step=\"any\" "
                                    "value=\"{1}\" list=\"{2}-marks\">"
                                    "<datalist id=\"{2}-marks\">{3}</datalist><output class=\"now\"></output>",
                                    first, last, id, marks)},
                       colours(body.head.at("fields"), id),
                       {"<label class=\"cutting\"><input class=\"cut\" type=\"checkbox\"> cut open</label>"
                        "<input class=\"place\" type=\"range\" min=\"0\" max=\"1\" step=\"0.005\" aria-label=\"where it is cut\">"
                        "<select class=\"axis\" aria-label=\"which way it is cut\"><option value=\"x\">across</option><option "
                        "value=\"y\">along</option>"
                        "<option value=\"z\">flat</option></select>"
                        "<label><input class=\"zoomed\" type=\"checkbox\"> colours over this moment’s range</label>"},
                       {shape}}),
                 "class=\"controls\"");
}

}  // namespace

json objects_of(const json& made) { return made.value("objects", json::array()); }

std::string object_anchor(const json& object, const std::string& place) { return place + "-" + object.at("name").get<std::string>(); }

Html object_figure(const json& object, const std::string& place, const std::filesystem::path& folder, std::vector<Html>& data) {
  std::vector<std::filesystem::path> folders;
  for (const json& name : object.at("of")) folders.push_back(folder / object.at("name").get<std::string>() / name.get<std::string>());
  const std::vector<PackedBody> bodies = packed_bodies(folders, object.at("particles"));
  const std::vector<std::string> ids = anchors_of(object, place), titles = titles_of(object);
  for (std::size_t i = 0; i < bodies.size(); ++i) data.push_back(data_of(bodies[i], ids[i]));
  const std::string shows = object.at("shows");
  Html poster = picture(folder / (object.at("picture").get<std::string>() + ".png"), shows);
  poster.code.replace(poster.code.find("photo"), 5, "poster");
  const Html stage = element(
      "div",
      join({poster, element("canvas", {}, "tabindex=\"0\" role=\"img\""), element("output", {}, "class=\"reading\" aria-live=\"off\"")}),
      "class=\"stage\"");
  const Html legend = {"<div class=\"legend\" hidden><div class=\"what\"></div><div class=\"bar\"></div><div class=\"ticks\"></div></div>"};
  const Html hints = {
      "<span class=\"touch\">Drag sideways to turn it, with two fingers to zoom; tap to read values.</span>"
      "<span class=\"keys\">Drag to turn it, <kbd>+</kbd> <kbd>−</kbd> to zoom, <kbd>,</kbd> <kbd>.</kbd> to step, <kbd>space</kbd> to "
      "play, "
      "<kbd>c</kbd> to cut; point at it to read its values.</span> “As baked” is a look, not a claim."};
  const std::string caption = bodies.size() > 1 ? fmt::format("{}. Here: {}. ", shows, titles.front()) : shows + ". ";
  return element("figure",
                 join({element("div", join({stage, legend}), "class=\"show\""), controls(bodies.front(), ids.front()),
                       element("figcaption", join({text(caption), hints}))}),
                 fmt::format("class=\"body\" id=\"{}\" data-title=\"{}\"", ids.front(), text(titles.front()).code));
}

Html followers(const json& object, const std::string& place) {
  const std::vector<std::string> ids = anchors_of(object, place), titles = titles_of(object);
  std::vector<Html> parts;
  for (std::size_t i = 1; i < ids.size(); ++i)
    parts.push_back(element(
        "figure", join({element("div", element("canvas", {}, "role=\"img\""), "class=\"stage\""), element("figcaption", text(titles[i]))}),
        fmt::format("class=\"body\" id=\"{}\" data-leader=\"{}\" data-title=\"{}\"", ids[i], ids.front(), text(titles[i]).code)));
  return parts.empty() ? Html{} : element("div", join(parts), "class=\"beside\"");
}

}  // namespace bake::report
