// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/diagnostics/characters.hpp"
#include "base/diagnostics/utf8.hpp"
#include "robot/input/common/context.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kLargestBlock = 1 << 20;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// A file of another kind is recognised by its first bytes.
struct OtherFile {
  std::string_view beginning;
  const char *what, *hint;
};

constexpr const char* kFromUtf16 = "convert it first: iconv -f UTF-16 -t UTF-8 FILE > FILE.csv";
constexpr OtherFile kOtherFiles[] = {
    {"\x1F\x8B", "the file is compressed", "unpack it first: gunzip -k FILE"},
    {"\xFF\xFE", "the text is UTF-16, not UTF-8", kFromUtf16},
    {"\xFE\xFF", "the text is UTF-16, not UTF-8", kFromUtf16},
    {"PK\x03\x04", "this is a zip archive or a spreadsheet, not CSV", "save the sheet as CSV (UTF-8)"},
    {"#ROSBAG", "this is a bag, not CSV", "write its topic as CSV: rostopic echo -p -b FILE /joint_states > log.csv"},
    {"\x89MCAP", "this is a bag, not CSV", "export its topic as CSV, for instance by PlotJuggler"},
    {kLfsPointer, kIsLfsPointer, kLfsHint},
    {"SQLite format 3", "this is a bag or another database, not CSV", "export its topic as CSV, as PlotJuggler can"},
};

bool is_strtod_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && *end == 0;
}

bool is_row_of_numbers(std::string_view line) {
  const std::vector<std::string> entries = csv_entries(line, separator_of(line));
  return std::all_of(entries.begin(), entries.end(), is_strtod_number);
}

bool has_outside_quotes(std::string_view text, char wanted) {
  bool quoted = false;
  return std::any_of(text.begin(), text.end(), [&](char c) {
    if (c == '"') quoted = !quoted;
    return c == wanted && !quoted;
  });
}

// The bytes of a file; 0 of a pipe.
std::uintmax_t size_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

// A small file needs no more than its size.
std::size_t block_for(std::uintmax_t size) {
  return size == 0 ? kLargestBlock : static_cast<std::size_t>(std::clamp<std::uintmax_t>(size + 1, 64, kLargestBlock));
}

// The entry is a number, whatever its decimal mark is.
bool looks_like_number(const std::string& entry) {
  return entry.find_first_not_of("0123456789+-.,eE") == std::string::npos;
}

}  // namespace

bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

LineReader::LineReader(const std::filesystem::path& path, Reading reading)
    : file_(path, std::ios::binary), buffer_(block_for(size_of(path))), size_(static_cast<double>(size_of(path))) {
  if (!file_ || std::filesystem::is_directory(path)) {
    throw Failure(FailureKind::io, fmt::format("{}: cannot be read", path.string()),
                  "check the path and the permissions");
  }
  if (reading == Reading::again && !std::filesystem::is_regular_file(path)) {
    throw Failure(FailureKind::io, fmt::format("{}: cannot be read: it is no regular file", path.string()),
                  "logs are read twice: write it to a file first");
  }
}

// Keeps what is left of a line and reads behind it; a line longer than the buffer makes it grow.
bool LineReader::refill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
  file_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  const auto count = static_cast<std::size_t>(file_.gcount());
  end_ += count;
  read_ += static_cast<double>(count);
  return count > 0;
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = 0;
  const char* newline = nullptr;
  while (true) {
    const char* from = buffer_.data() + begin_ + searched;
    newline = static_cast<const char*>(std::memchr(from, '\n', end_ - begin_ - searched));
    if (newline != nullptr) break;
    searched = end_ - begin_;
    if (!refill()) break;
  }
  if (newline == nullptr && begin_ == end_) return false;
  const char* first = buffer_.data() + begin_;
  const char* last = newline != nullptr ? newline : buffer_.data() + end_;
  begin_ = static_cast<std::size_t>(last - buffer_.data()) + (newline != nullptr ? 1 : 0);
  line = {first, static_cast<std::size_t>(last - first)};
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (number_++ == 0 && line.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    line.remove_prefix(kByteOrderMark.size());
  }
  return true;
}

void LineReader::jump(double share) {
  file_.clear();
  file_.seekg(0, std::ios::end);
  const auto place = static_cast<std::streamoff>(share * static_cast<double>(file_.tellg()));
  file_.seekg(place);
  read_ = static_cast<double>(place);
  begin_ = end_ = 0;
  std::string_view rest;
  next(rest);
}

double LineReader::share() const { return size_ > 0 ? (read_ - static_cast<double>(end_ - begin_)) / size_ : 0; }

bool LineReader::next_row(std::string_view& line) {
  constexpr std::string_view kBag = "#ROSBAG";       // no comment
  constexpr std::string_view kSpreadsheet = "sep=";  // which separator follows, for spreadsheets alone
  while (next(line)) {
    if (number_ == 1 && line.substr(0, kSpreadsheet.size()) == kSpreadsheet) continue;
    const auto first = line.find_first_not_of(" \t");
    if (first != std::string_view::npos && (line[first] != '#' || line.substr(0, kBag.size()) == kBag)) return true;
  }
  return false;
}

bool is_csv_heading(std::string_view line, const Place& place, Diagnostics& diagnostics) {
  for (const auto& [beginning, what, hint] : kOtherFiles) {
    if (line.substr(0, beginning.size()) != beginning) continue;
    diagnostics.error(place, what, hint);
    return false;
  }
  if (line.find('\0') != std::string_view::npos) {
    diagnostics.error(place, "the file is no text, or it is UTF-16", kFromUtf16);
  } else if (!is_utf8(line)) {
    diagnostics.error(place, "the heading is not UTF-8",
                      "convert the file first: iconv -f WINDOWS-1252 -t UTF-8 FILE > FILE.csv");
  } else if (line.find('\r') != std::string_view::npos) {
    diagnostics.error(place, "lines end with a carriage return alone", "convert the file: tr '\\r' '\\n' < FILE");
  } else if (is_row_of_numbers(line)) {
    diagnostics.error(place, "there is a row of numbers where the heading is expected",
                      "write the columns' names into the first line, such as t,q1,q2,tau1,tau2; a line that begins "
                      "with # is a comment");
  } else {
    return true;
  }
  return false;
}

char separator_of(std::string_view heading) {
  for (const char separator : {';', ',', '\t'}) {
    if (has_outside_quotes(heading, separator)) return separator;
  }
  return ',';
}

const char* end_of_entry(const char* at, const char* end, char separator) {
  const char* from = at;
  while (from < end && *from == ' ') ++from;
  if (from < end && *from == '"') {
    const char* close = std::find(from + 1, end, '"');
    while (close + 1 < end && close[1] == '"') close = std::find(close + 2, end, '"');
    if (close < end) from = close;  // a quotation mark that nothing closes is a character like others
  }
  return std::find(from, end, separator);
}

std::string unquoted(std::string_view entry) {
  entry = trimmed(entry);
  if (entry.size() < 2 || entry.front() != '"' || entry.back() != '"') return std::string(entry);
  std::string text;
  for (std::size_t k = 1; k + 1 < entry.size(); ++k) {
    text += entry[k];
    if (entry[k] == '"' && entry[k + 1] == '"' && k + 2 < entry.size()) ++k;
  }
  return std::string(trimmed(text));
}

std::vector<std::string> csv_entries(std::string_view line, char separator) {
  std::vector<std::string> entries;
  const char* at = line.data();
  const char* const end = at + line.size();
  while (true) {
    const char* last = end_of_entry(at, end, separator);
    entries.push_back(unquoted({at, static_cast<std::size_t>(last - at)}));
    if (last == end) return entries;
    at = last + 1;
  }
}

std::string csv_entry(const std::string& text) {
  const bool has_blanks = !text.empty() && trimmed(text).size() != text.size();
  if (!has_blanks && text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

bool DecimalMarks::normalise(std::string& entry) {
  if (!may_be_commas_ || !looks_like_number(entry)) return true;
  const auto at = entry.find_first_of(".,");
  if (at == std::string::npos) return true;
  const char mark = entry[at];
  if (mark_ == 0) mark_ = mark;
  if (mark != mark_ || entry.find_first_of(".,", at + 1) != std::string::npos) return false;
  entry[at] = '.';
  return true;
}

}  // namespace flatdyn
