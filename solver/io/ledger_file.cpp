// SPDX-License-Identifier: MIT
#include "solver/io/ledger_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "solver/core/errors.h"
#include "solver/core/tell.h"
#include "solver/io/atomic_file.h"

namespace bake {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

std::string line_of(const std::vector<std::string>& names) { return fmt::format("{}\n", fmt::join(names, ",")); }

std::string line_of(std::span<const double> row) { return fmt::format("{:.17g}\n", fmt::join(row.begin(), row.end(), ",")); }

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

/// The next whole line; false at the end of the file and for a last line without an end.
bool next_line(std::istream& in, std::string& line) { return std::getline(in, line) && !in.eof(); }

std::vector<double> numbers(const std::vector<std::string>& words, const std::string& place) {
  std::vector<double> values(words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto* end = words[i].data() + words[i].size();
    const auto [stop, error] = std::from_chars(words[i].data(), end, values[i]);
    if (error != std::errc{} || stop != end) throw InputError(fmt::format("{}: '{}' is not a number", place, words[i]));
  }
  return values;
}

/// A column's name began like the first until 0.1, and begins like the second now.
constexpr std::pair<std::string_view, std::string_view> k_renamed[] = {
    {"twist_", "angular_impulse_"},
    {"retired_solid_kg", "retired_solid_mass_kg"},
    {"retired_water_kg", "retired_water_mass_kg"},
    {"retired_heat_J", "retired_heat_content_J"},
    {"emitted_solid_kg", "emitted_solid_mass_kg"},
    {"emitted_water_kg", "emitted_water_mass_kg"},
    {"emitted_heat_J", "emitted_heat_content_J"},
};

}  // namespace

std::string present_column(const std::string& name) {
  for (const auto& [former, present] : k_renamed)
    if (name.starts_with(former)) return std::string(present) + name.substr(former.size());
  return name;
}

Ledger read_ledger(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw InputError(fmt::format("{}: cannot open: {}", path.string(), reason(errno)));
  Ledger ledger;
  std::string line;
  if (!next_line(in, line)) throw InputError(fmt::format("{}: not a ledger: it has no heading line", path.string()));
  const std::vector<std::string> named = split(line);
  for (const std::string& name : named) ledger.columns.push_back(present_column(name));
  const auto [old, present] = std::mismatch(named.begin(), named.end(), ledger.columns.begin());
  if (old != named.end())
    tell_user("bake: {}: {} and other columns have other names now ({}); the old ones are read until 1.0", path.string(), *old, *present);
  while (next_line(in, line)) {
    const auto place = fmt::format("{}:{}", path.string(), ledger.rows.size() + 2);
    const auto words = split(line);
    if (words.size() != ledger.columns.size()) {
      throw InputError(fmt::format("{}: {} values, the heading has {} columns", place, words.size(), ledger.columns.size()));
    }
    ledger.rows.push_back(numbers(words, place));
  }
  return ledger;
}

LedgerFile::LedgerFile(std::filesystem::path path, std::size_t columns) : path_(std::move(path)), columns_(columns) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0) throw OutputError(fmt::format("{}: cannot open: {}", path_.string(), reason(errno)));
}

LedgerFile::LedgerFile(LedgerFile&& other) noexcept
    : path_(std::move(other.path_)), columns_(other.columns_), descriptor_(std::exchange(other.descriptor_, -1)) {}

LedgerFile::~LedgerFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

LedgerFile LedgerFile::create(const std::filesystem::path& path, const std::vector<std::string>& columns) {
  write_text_atomically(path, line_of(columns));
  return LedgerFile(path, columns.size());
}

LedgerFile LedgerFile::resume(const std::filesystem::path& path, const std::vector<std::string>& columns, double last) {
  const auto old = read_ledger(path);
  if (old.columns != columns) {
    throw InputError(fmt::format("{}: its columns are not those of this run; it belongs to another scene or version", path.string()));
  }
  auto text = line_of(columns);
  for (const auto& row : old.rows) {
    if (row.front() <= last) text += line_of(row);
  }
  write_text_atomically(path, text);
  return LedgerFile(path, columns.size());
}

void LedgerFile::append(std::span<const double> row) {
  if (row.size() != columns_) throw std::invalid_argument(fmt::format("a ledger row of {} values for {} columns", row.size(), columns_));
  struct stat there {
  }, ours{};
  if (::stat(path_.c_str(), &there) != 0 || ::fstat(descriptor_, &ours) != 0 || there.st_ino != ours.st_ino || there.st_dev != ours.st_dev)
    throw OutputError(fmt::format("{}: cannot append: the file was removed or replaced meanwhile", path_.string()));
  const auto text = line_of(row);
  const auto before = ::lseek(descriptor_, 0, SEEK_END);
  errno = ENOSPC;  // a write that stops half way sets no error: there was no room for the rest
  if (::write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size())) return;
  const int error = errno;
  const bool whole = ::ftruncate(descriptor_, before) == 0;
  throw OutputError(fmt::format("{}: cannot append{}: {}", path_.string(), whole ? "" : " (its last row is torn)", reason(error)));
}
void LedgerFile::flush() {
  if (::fsync(descriptor_) != 0) throw OutputError(fmt::format("{}: cannot flush to disk: {}", path_.string(), reason(errno)));
}

}  // namespace bake
