// SPDX-License-Identifier: GPL-2.0-or-later
// The text of CSV files, before anything is known of its columns: lines, separators, entries, numbers.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

// The lines of a file, by blocks; a line is a view that holds until the next one.
class LineReader {
 public:
  enum class Reading { once, again };  // again: the file will be opened once more, so it must not be a pipe

  // Throws Failure(io) if the file cannot be read, or cannot be read again where it has to be.
  explicit LineReader(const std::filesystem::path& path, Reading reading);

  // False at the end. Without the line's end (\n or \r\n), and the first line without its byte order mark.
  bool next(std::string_view& line);
  // The same, but lines that are empty or begin with # are left out, and so is a first line "sep=;".
  bool next_row(std::string_view& line);
  // The number of the line last read, counted from 1.
  int number() const { return number_; }
  // Goes to the line that begins behind a place in the file, 0 … 1 of its bytes; numbers of lines are lost.
  void jump(double share);
  // The place behind the line last read, 0 … 1 of the bytes.
  double share() const;

 private:
  bool refill();

  std::ifstream file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  int number_ = 0;
  double size_ = 0, read_ = 0;  // bytes of the file, and up to the end of the buffer
};

// The heading is text that can be read, and not the beginning of another kind of file (compressed, UTF-16, a
// spreadsheet, a bag) nor a row of numbers. If it is not, `diagnostics` gets the error, and this returns false.
bool is_csv_heading(std::string_view line, const Place& place, Diagnostics& diagnostics);

// The separator of the entries of a file with this heading: a semicolon, else a comma, else a tab; a comma if there is
// none of them. Quotation marks hide what is between them.
char separator_of(std::string_view heading);

// The entries of a line without the blanks around them and without quotation marks, of which "" is one inside.
std::vector<std::string> csv_entries(std::string_view line, char separator);

// Without blanks around it, and without quotation marks around what is left.
std::string unquoted(std::string_view entry);

// Where the entry that begins at `at` ends: at the next separator outside quotation marks, or at `end`.
const char* end_of_entry(const char* at, const char* end, char separator);

bool is_digits(std::string_view text);  // and nothing else, and at least one

// An entry as CSV: in quotation marks where it has commas, quotation marks or blanks around it.
std::string csv_entry(const std::string& text);

// Decimal commas are read where commas do not separate columns. A file has them, or decimal points, but not both: with
// both, 1.234 may be a thousand.
class DecimalMarks {
 public:
  explicit DecimalMarks(char separator) : may_be_commas_(separator != ',') {}

  bool may_be_commas() const { return may_be_commas_; }
  // Writes a point for the comma of a number. False if this entry's mark is not that of the entries before it.
  bool normalise(std::string& entry);

 private:
  bool may_be_commas_;
  char mark_ = 0;  // of the first number that has one
};

}  // namespace flatdyn
