// SPDX-License-Identifier: MIT
#include "solver/identity/canonical_source.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

namespace bake {
namespace {

constexpr std::array k_operators{"<=>", "...", "<<=", ">>=", "->*", "::", ".*", "->", "++", "--", "<<", ">>", "<=", ">=",
                                 "==",  "!=",  "&&",  "||",  "+=",  "-=", "*=", "/=", "%=", "^=", "&=", "|=", "##"};  // longest first

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || (c & 0x80) != 0; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

/// Takes a source apart from left to right [ISO C++20, 5.2 and 5.4].
class Scanner {
 public:
  explicit Scanner(std::string_view source) : rest_(source) {}

  std::string canonical() {
    std::string directive;  // as far as it has been read; empty outside
    for (skip_blanks(); !rest_.empty(); skip_blanks()) {
      if (rest_[0] == '\n') {
        take(1);
        end(directive);
      } else if (rest_[0] == '#' || !directive.empty()) {
        directive += next_token(directive) + "\n";
      } else {
        text_ += next_token(directive) + "\n";
      }
    }
    end(directive);
    return text_;
  }

 private:
  void end(std::string& directive) {
    if (!directive.empty() && !directive.starts_with("#\ninclude\n\"")) text_ += directive + "\n";
    directive.clear();
  }

  /// Line splices vanish wherever a token is not raw: the rest of the source is looked at without those at its beginning.
  void skip_splices() {
    while (rest_.starts_with("\\\n") || rest_.starts_with("\\\r\n")) rest_.remove_prefix(rest_.find('\n') + 1);
  }

  char take(std::size_t count) {
    char c = 0;
    for (; count > 0; --count) {
      c = rest_[0];
      rest_.remove_prefix(1);
      skip_splices();
    }
    return c;
  }

  /// Whether `text` comes next, splices left out.
  bool sees(std::string_view text) const {
    Scanner ahead(rest_);
    for (const char c : text) {
      if (ahead.rest_.empty() || ahead.take(1) != c) return false;
    }
    return true;
  }

  void skip_blanks() {
    for (skip_splices(); !rest_.empty();) {
      if (is_blank(rest_[0])) {
        take(1);
      } else if (sees("//")) {
        while (!rest_.empty() && rest_[0] != '\n') take(1);
      } else if (sees("/*")) {
        take(2);
        while (!rest_.empty() && !sees("*/")) take(1);
        take(rest_.empty() ? 0 : 2);
      } else {
        return;
      }
    }
  }

  std::string next_token(const std::string& directive) {
    std::string token;
    if (is_digit(rest_[0]) || (rest_[0] == '.' && Scanner(rest_.substr(1)).starts_with_digit())) return number();
    while (!rest_.empty() && is_name(rest_[0])) token += take(1);
    if (!rest_.empty() && (rest_[0] == '"' || rest_[0] == '\'')) {
      static const std::set<std::string> prefixes{"", "u8", "u", "U", "L"};
      if (rest_[0] == '"' && token.ends_with('R') && prefixes.contains(token.substr(0, token.size() - 1))) return token + raw_string();
      if (prefixes.contains(token)) return token + quoted();
    }
    if (!token.empty()) {
      // with parameters or with a value in brackets: here a blank counts
      if (directive == "#\ndefine\n" && !rest_.empty() && rest_[0] == '(') token += take(1);
      return token;
    }
    for (const std::string_view name : k_operators) {
      if (!sees(name)) continue;
      take(name.size());
      return std::string(name);
    }
    return {take(1)};
  }

  bool starts_with_digit() {
    skip_splices();
    return !rest_.empty() && is_digit(rest_[0]);
  }

  std::string number() {
    std::string token;
    while (!rest_.empty()) {
      const bool sign = (rest_[0] == '+' || rest_[0] == '-') && !token.empty() && std::string_view("eEpP").find(token.back()) < 4;
      const bool separator = rest_[0] == '\'' && rest_.size() > 1 && is_name(rest_[1]);
      if (!is_name(rest_[0]) && rest_[0] != '.' && !sign && !separator) break;
      token += take(1);
    }
    return token;
  }

  /// A string or a character with the suffix that may follow.
  std::string quoted() {
    const char quote = rest_[0];
    std::string token{take(1)};
    while (!rest_.empty() && rest_[0] != quote && rest_[0] != '\n') {
      if (rest_[0] == '\\') token += take(1);
      if (!rest_.empty()) token += take(1);
    }
    if (!rest_.empty() && rest_[0] == quote) token += take(1);
    return token + suffix();
  }

  std::string raw_string() {
    std::string end(rest_.substr(0, rest_.find('(')));  // "delimiter, which becomes )delimiter"
    end[0] = ')';
    end += '"';
    const std::size_t size = std::min(rest_.size(), rest_.find(end) == rest_.npos ? rest_.npos : rest_.find(end) + end.size());
    std::string token(rest_.substr(0, size));
    rest_.remove_prefix(size);
    skip_splices();
    return token + suffix();
  }

  std::string suffix() {
    std::string name;
    while (!rest_.empty() && is_name(rest_[0])) name += take(1);
    return name;
  }

  std::string_view rest_;
  std::string text_;
};

std::string whole(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  return text;
}

}  // namespace

std::string canonical_source(std::string_view source) { return Scanner(source).canonical(); }

std::string canonical_sources(const std::filesystem::path& folder) {
  std::multiset<std::string> texts;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string room = entry.path().lexically_relative(folder).begin()->string();
    const std::string kind = entry.path().extension().string();
    if (room == "program" || room == "identity" || (kind != ".h" && kind != ".cpp" && kind != ".in")) continue;
    texts.insert(canonical_source(whole(entry.path())));
  }
  std::string all;
  for (const std::string& text : texts) all += text + '\f';
  return all;
}

}  // namespace bake
