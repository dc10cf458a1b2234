// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "meshing/solid/polygon_soup.h"
#include "solver/core/errors.h"

namespace bake {
namespace {

constexpr const char* k_endings[] = {".stl", ".obj", ".ply", ".off"};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string ending(const std::filesystem::path& file) { return lower(file.extension().string()); }

/// Throws what is wrong; the caller knows the file.
[[noreturn]] void refuse(const std::string& what) { throw InputError(what); }

using Words = std::vector<std::string_view>;

Words words_of(std::string_view line) {
  constexpr std::string_view k_blanks = " \t\r\v\f";
  Words words;
  for (std::size_t at = line.find_first_not_of(k_blanks); at != line.npos; at = line.find_first_not_of(k_blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(k_blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

/// The words of a text, line by line.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// The next line that has words, without what stands behind a '#'; false at the end. `continued`: a line that ends with a backslash goes
  /// on in the next.
  bool next(Words& words, bool continued = false) {
    while (!rest_.empty()) {
      joined_.clear();
      std::string_view line = take();
      for (; continued && !rest_.empty() && ends_with_backslash(line); line = take())
        joined_ += line.substr(0, line.rfind('\\')), joined_ += ' ';
      if (!joined_.empty()) joined_ += line, line = joined_;
      words = words_of(line.substr(0, line.find('#')));
      if (!words.empty()) return true;
    }
    return false;
  }

  std::size_t number() const { return number_; }  ///< of the line that `next` gave, from 1
  std::string_view rest() const { return rest_; }

  [[noreturn]] void refuse(const std::string& what) const { bake::refuse(fmt::format("line {}: {}", number_, what)); }

  double real(const Words& words, std::size_t i) const {
    double value = 0;
    if (i >= words.size() || !read(words[i], value))
      refuse(fmt::format("found {}, allowed: a number", i < words.size() ? words[i] : "the end of the line"));
    return value;
  }
  std::int64_t whole(std::string_view word) const {
    std::int64_t value = 0;
    if (!read(word, value)) refuse(fmt::format("found {}, allowed: a whole number", word));
    return value;
  }
  Point point(const Words& words, std::size_t first) const { return {real(words, first), real(words, first + 1), real(words, first + 2)}; }

 private:
  template <class T>
  static bool read(std::string_view word, T& value) {
    if (!word.empty() && word[0] == '+') word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    // too large or too small for a double: not finite, which is found out later, or nothing
    if constexpr (std::is_floating_point_v<T>)
      if (error == std::errc::result_out_of_range) value = HUGE_VAL;
    return (error == std::errc() || error == std::errc::result_out_of_range) && end == word.data() + word.size();
  }
  static bool ends_with_backslash(std::string_view line) {
    const std::size_t last = line.find_last_not_of(" \t\r");
    return last != line.npos && line[last] == '\\';
  }
  std::string_view take() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return line;
  }

  std::string_view rest_;
  std::string joined_;
  std::size_t number_ = 0;
};

PolygonSoup read_obj(std::string_view text) {
  PolygonSoup soup;
  Lines lines(text);
  for (Words words; lines.next(words, true);) {
    if (words[0] == "v") soup.points.push_back(lines.point(words, 1));
    if (words[0] != "f") continue;
    const auto count = static_cast<std::int64_t>(soup.points.size());
    auto& face = soup.faces.emplace_back();
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::int64_t v = lines.whole(words[i].substr(0, words[i].find('/')));
      if (v == 0 || v > count || v < -count) lines.refuse(fmt::format("found vertex {}, allowed: 1 to {}, or -1 to -{}", v, count, count));
      face.push_back(v > 0 ? v - 1 : count + v);
    }
  }
  return soup;
}

PolygonSoup read_off(std::string_view text) {
  PolygonSoup soup;
  Lines lines(text);
  Words words;
  if (!lines.next(words) || !lower(words[0]).ends_with("off")) refuse("is damaged: it does not begin with OFF");
  if (words.size() == 2 && lower(words[1]) == "binary") refuse("is a binary OFF file, allowed: text");
  if (words.size() > 1)
    words.erase(words.begin());
  else if (!lines.next(words))
    refuse("is damaged: it ends before its numbers of vertices and faces");
  if (words.size() < 2) lines.refuse("found one word, allowed: the numbers of vertices, faces and edges");
  const std::int64_t points = lines.whole(words[0]), faces = lines.whole(words[1]);
  const auto expect = [&](const char* what, std::int64_t i, std::int64_t count) {
    if (!lines.next(words)) refuse(fmt::format("is damaged: it ends behind {} of its {} {}", i, count, what));
  };
  for (std::int64_t i = 0; i < points; ++i) {
    expect("vertices", i, points);
    soup.points.push_back(lines.point(words, 0));
  }
  for (std::int64_t i = 0; i < faces; ++i) {
    expect("faces", i, faces);
    const std::int64_t corners = lines.whole(words[0]);
    if (corners < 0 || corners >= static_cast<std::int64_t>(words.size()))
      lines.refuse(
          fmt::format("found a face of {} corners and {} words behind, allowed: as many words as corners", corners, words.size() - 1));
    auto& face = soup.faces.emplace_back();
    for (std::int64_t k = 1; k <= corners; ++k) face.push_back(lines.whole(words[k]));
  }
  return soup;
}

PolygonSoup read_text_stl(std::string_view text) {
  PolygonSoup soup;
  Lines lines(text);
  std::optional<std::vector<std::int64_t>> loop;
  for (Words words; lines.next(words);) {
    const std::string first = lower(words[0]);
    if (first == "outer") loop.emplace();
    if (first == "vertex") {
      if (!loop) lines.refuse("found a vertex, allowed: only between 'outer loop' and 'endloop'");
      loop->push_back(static_cast<std::int64_t>(soup.points.size()));
      soup.points.push_back(lines.point(words, 1));
    }
    if (first == "endloop") {
      if (!loop) lines.refuse("found 'endloop' without an 'outer loop'");
      soup.faces.push_back(*loop);
      loop.reset();
    }
  }
  if (loop) refuse("is damaged: it ends within a facet");
  return soup;
}

/// Numbers of a binary file, one after the other.
class Bytes {
 public:
  Bytes(std::string_view bytes, bool swapped) : rest_(bytes), swapped_(swapped) {}
  template <class T>
  T take() {
    if (rest_.size() < sizeof(T)) refuse("is damaged: it ends too early");
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), rest_.data(), sizeof(T));
    if (swapped_) std::reverse(bytes.begin(), bytes.end());
    rest_.remove_prefix(sizeof(T));
    return std::bit_cast<T>(bytes);
  }
  std::size_t left() const { return rest_.size(); }

 private:
  std::string_view rest_;
  bool swapped_;
};

constexpr std::size_t k_stl_head = 84, k_stl_facet = 50;

std::size_t binary_stl_count(std::string_view bytes) {
  return bytes.size() < k_stl_head ? 0 : Bytes(bytes.substr(80), std::endian::native == std::endian::big).take<std::uint32_t>();
}

PolygonSoup read_binary_stl(std::string_view bytes) {
  PolygonSoup soup;
  const std::size_t count = binary_stl_count(bytes), room = (bytes.size() - k_stl_head) / k_stl_facet;
  if (count > room) refuse(fmt::format("is cut off: it announces {} facets and has {}", count, room));
  for (std::size_t f = 0; f < count; ++f) {
    Bytes facet(bytes.substr(k_stl_head + f * k_stl_facet + 12), std::endian::native == std::endian::big);
    auto& face = soup.faces.emplace_back();
    for (int k = 0; k < 3; ++k) {
      face.push_back(static_cast<std::int64_t>(soup.points.size()));
      const double x = facet.take<float>(), y = facet.take<float>(), z = facet.take<float>();
      soup.points.push_back({x, y, z});
    }
  }
  return soup;
}

PolygonSoup read_stl(std::string_view bytes) {
  // Some binary files begin with "solid", too; their length tells.
  const bool fits = bytes.size() >= k_stl_head && bytes.size() == k_stl_head + k_stl_facet * binary_stl_count(bytes);
  const Words first = words_of(bytes.substr(0, std::min(bytes.find('\n'), bytes.size())));
  const bool is_text = !fits && !first.empty() && lower(first[0]) == "solid" && bytes.find('\0') == bytes.npos;
  if (!is_text && bytes.size() < k_stl_head) refuse("is no STL file: it does not begin with 'solid' and is too short for a binary one");
  PolygonSoup soup = is_text ? read_text_stl(bytes) : read_binary_stl(bytes);
  soup.repeats_corners = true;
  return soup;
}

/// Takes a number of one of PLY's types from a binary file.
using PlyType = double (*)(Bytes&);

template <class T>
double taken(Bytes& bytes) {
  return static_cast<double>(bytes.take<T>());
}

PlyType ply_type(const Lines& lines, std::string_view name) {
  constexpr std::pair<const char*, PlyType> k_types[] = {
      {"char", taken<std::int8_t>},   {"int8", taken<std::int8_t>},   {"uchar", taken<std::uint8_t>},   {"uint8", taken<std::uint8_t>},
      {"short", taken<std::int16_t>}, {"int16", taken<std::int16_t>}, {"ushort", taken<std::uint16_t>}, {"uint16", taken<std::uint16_t>},
      {"int", taken<std::int32_t>},   {"int32", taken<std::int32_t>}, {"uint", taken<std::uint32_t>},   {"uint32", taken<std::uint32_t>},
      {"float", taken<float>},        {"float32", taken<float>},      {"double", taken<double>},        {"float64", taken<double>}};
  for (const auto& [known, type] : k_types)
    if (name == known) return type;
  lines.refuse(fmt::format("found the type {}, allowed: char, uchar, short, ushort, int, uint, float, double", name));
}

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::int64_t rows = 0;
  std::vector<PlyProperty> properties;
};

/// The numbers behind the header, of text or binary.
class PlyNumbers {
 public:
  PlyNumbers(std::string_view body, std::string_view format)
      : is_text_(format == "ascii"),
        text_(is_text_ ? body : std::string_view()),
        bytes_(is_text_ ? std::string_view() : body, (format == "binary_big_endian") != (std::endian::native == std::endian::big)),
        size_(body.size()) {}

  double take(PlyType type) { return is_text_ ? take_word() : type(bytes_); }
  /// A number of things that each take a byte at least.
  std::int64_t take_count(PlyType type) {
    const double count = take(type);
    if (!(count >= 0 && count <= static_cast<double>(size_))) refuse(fmt::format("is damaged: a list of {} numbers", count));
    return static_cast<std::int64_t>(count);
  }

 private:
  double take_word() {
    while (at_ == words_.size()) {
      at_ = 0;
      if (!text_.next(words_)) refuse("is damaged: it ends too early");
    }
    return text_.real(words_, at_++);
  }

  bool is_text_;
  Lines text_;
  Words words_;
  std::size_t at_ = 0;
  Bytes bytes_;
  std::size_t size_;
};

void read_ply_row(PlyNumbers& numbers, const PlyElement& element, PolygonSoup& soup) {
  Point x{};
  const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
  for (const PlyProperty& property : element.properties) {
    if (!property.count) {
      const double value = numbers.take(property.type);
      for (int i = 0; i < 3; ++i)
        if (is_vertex && property.name == std::string(1, "xyz"[i])) x[i] = value;
      continue;
    }
    const std::int64_t count = numbers.take_count(*property.count);
    const bool corners = is_face && (property.name == "vertex_indices" || property.name == "vertex_index");
    std::vector<std::int64_t> face;
    for (std::int64_t k = 0; k < count; ++k) {
      const double value = numbers.take(property.type);
      if (corners) face.push_back(std::abs(value) < 1e15 ? static_cast<std::int64_t>(value) : -1);
    }
    if (corners) soup.faces.push_back(std::move(face));
  }
  if (is_vertex) soup.points.push_back(x);
}

PolygonSoup read_ply(std::string_view text) {
  Lines lines(text);
  Words words;
  if (!lines.next(words) || words[0] != "ply") refuse("is damaged: it does not begin with ply");
  std::string format;
  std::vector<PlyElement> elements;
  for (;;) {
    if (!lines.next(words)) refuse("is damaged: its heading has no end");
    if (words[0] == "end_header") break;
    if (words[0] == "format" && words.size() > 1) format = words[1];
    if (words[0] == "element") {
      if (words.size() != 3) lines.refuse("allowed: element <name> <count>");
      elements.push_back({std::string(words[1]), lines.whole(words[2]), {}});
    }
    if (words[0] == "property") {
      const bool is_list = words.size() == 5 && words[1] == "list";
      if (elements.empty() || (!is_list && words.size() != 3))
        lines.refuse("allowed: property <type> <name>, or property list <type> <type> <name>");
      if (is_list)
        elements.back().properties.push_back({std::string(words[4]), ply_type(lines, words[3]), ply_type(lines, words[2])});
      else
        elements.back().properties.push_back({std::string(words[2]), ply_type(lines, words[1]), std::nullopt});
    }
  }
  if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
    refuse(fmt::format("found format {}, allowed: ascii, binary_little_endian, binary_big_endian", format));
  PlyNumbers numbers(lines.rest(), format);
  PolygonSoup soup;
  for (const PlyElement& element : elements)
    if (!element.properties.empty())
      for (std::int64_t row = 0; row < element.rows; ++row) read_ply_row(numbers, element, soup);
  return soup;
}

std::string contents(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) refuse("is a folder, allowed: a file");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream.is_open() || stream.bad()) refuse("cannot open");
  return bytes;
}

PolygonSoup parse(const std::filesystem::path& file) {
  const std::string bytes = contents(file);
  std::string_view text = bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // byte-order mark
  const std::string kind = ending(file);
  PolygonSoup soup = kind == ".stl" ? read_stl(text) : kind == ".obj" ? read_obj(text) : kind == ".ply" ? read_ply(text) : read_off(text);
  for (std::size_t f = 0; f < soup.faces.size(); ++f)
    for (const std::int64_t v : soup.faces[f])
      if (v < 0 || v >= static_cast<std::int64_t>(soup.points.size()))
        refuse(soup.points.empty() ? fmt::format("face {}: found vertex {}, the file has none", f, v)
                                   : fmt::format("face {}: found vertex {}, allowed: 0 to {}", f, v, soup.points.size() - 1));
  return soup;
}

}  // namespace

bool is_surface_file(const std::filesystem::path& file) {
  return std::find(std::begin(k_endings), std::end(k_endings), ending(file)) != std::end(k_endings);
}

PolygonSoup read_polygon_soup(const std::filesystem::path& file) {
  try {
    return parse(file);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace bake
