// SPDX-License-Identifier: MIT
// ledger.csv: the balances that a run books, one row per frame.
//
// A row is appended by one write; if that write fails, the file is cut back to its last whole row. (Rewriting
// the whole file for each row would cost time with the square of the number of frames, and programs that follow the file would lose it.)
// A row that a power cut has truncated has no end of line: readers ignore it, and a resumed run removes it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bake {

struct Ledger {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< each as long as `columns`
};

/// The present name of a column that was called `name` until 0.1; `name` itself if it was not renamed. Former names are read until 1.0.
std::string present_column(const std::string& name);

/// Reads a ledger. Throws InputError (file:line) on a missing file, a row of wrong length or a word that is no number.
/// Columns under former names get their present ones, with one line of notice on standard error.
Ledger read_ledger(const std::filesystem::path& path);

/// The ledger of a running simulation. The first column (frame or time) must rise from row to row.
class LedgerFile {
 public:
  /// Begins a new file with its heading line. Names must not hold commas or line breaks. Throws OutputError.
  static LedgerFile create(const std::filesystem::path& path, const std::vector<std::string>& columns);
  /// Continues a file behind the row whose first column is `last`; later rows are removed. Throws InputError if the file is missing,
  /// unreadable or has other columns, OutputError if it cannot be written.
  static LedgerFile resume(const std::filesystem::path& path, const std::vector<std::string>& columns, double last);
  ~LedgerFile();
  LedgerFile(LedgerFile&& other) noexcept;
  LedgerFile& operator=(LedgerFile&&) = delete;

  /// Appends a row, with 17 significant digits. Throws OutputError, the file then ends with the row before (or is no longer there);
  /// std::invalid_argument if the row is not as long as the heading.
  void append(std::span<const double> row);
  /// Makes the rows survive a power cut. Throws OutputError.
  void flush();

 private:
  LedgerFile(std::filesystem::path path, std::size_t columns);

  std::filesystem::path path_;
  std::size_t columns_;
  int descriptor_;
};

}  // namespace bake
