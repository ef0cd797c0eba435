// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/log_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace flatdyn {
namespace {

constexpr std::size_t kBlock = 1 << 20;
constexpr int kMostErrors = 20;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

bool is_comment_or_empty(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  return first == std::string_view::npos || line[first] == '#';
}

// What from_chars() takes, and what other programs write besides: a plus sign, and numbers too small for a double.
// Where the number ends; null if there is none.
const char* read_unquoted(const char* at, const char* end, double& value) {
  if (end - at > 1 && *at == '+' && at[1] != '-') ++at;
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error == std::errc::result_out_of_range) {
    value = std::strtod(std::string(at, stop).c_str(), nullptr);
  } else if (error != std::errc()) {
    return nullptr;
  }
  return std::isfinite(value) ? stop : nullptr;
}

// Also in quotation marks.
const char* read_number(const char* at, const char* end, double& value) {
  if (at == end || *at != '"') return read_unquoted(at, end, value);
  const char* stop = read_unquoted(at + 1, end, value);
  return stop != nullptr && stop < end && *stop == '"' ? stop + 1 : nullptr;
}

}  // namespace

LineReader::LineReader(const std::filesystem::path& path) : file_(path, std::ios::binary), buffer_(kBlock) {
  if (!file_ || std::filesystem::is_directory(path)) {
    throw Failure(ExitCode::io, fmt::format("{}: cannot be read", path.string()));
  }
  if (!std::filesystem::is_regular_file(path)) {
    throw Failure(ExitCode::io, fmt::format("{}: cannot be read: it is no regular file", path.string()),
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
  ++number_;
  return true;
}

LogReader::LogReader(const std::filesystem::path& path, const Mechanism& mechanism, bool torques,
                     Diagnostics& diagnostics)
    : path_(path.string()), lines_(path), diagnostics_(diagnostics) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF", kGzip = "\x1F\x8B";
  std::string_view line;
  if (!next_line(line)) {
    complain("no samples in the file", "a heading such as t,q1,q2,tau1,tau2 and a line for each sample");
    return;
  }
  if (line.substr(0, kGzip.size()) == kGzip) {
    complain("the log is compressed", "unpack it first: gunzip -k FILE");
    return;
  }
  if (line.substr(0, kByteOrderMark.size()) == kByteOrderMark) line.remove_prefix(kByteOrderMark.size());
  heading_ = read_heading(std::string(line), place(), mechanism, torques, diagnostics);
}

LogReader::LogReader(const std::filesystem::path& path, LogHeading heading, Diagnostics& diagnostics)
    : path_(path.string()), lines_(path), diagnostics_(diagnostics), heading_(std::move(heading)) {
  std::string_view line;
  next_line(line);
}

bool LogReader::complain(const std::string& message, const std::string& hint) {
  diagnostics_.error(place(), message, hint);
  return ++errors_ < kMostErrors;
}

bool LogReader::next_line(std::string_view& line) {
  while (lines_.next(line)) {
    if (!is_comment_or_empty(line)) return true;
  }
  return false;
}

long LogReader::skip(long count) {
  std::string_view line;
  long done = 0;
  while (done < count && next_line(line)) ++done;
  return done;
}

bool LogReader::next(double* channels) {
  std::string_view line;
  while (errors_ < kMostErrors && next_line(line)) {
    if (!parse(line, channels)) continue;
    const double time = channels[LogLayout::time()];
    if (time > last_time_) {
      last_time_ = time;
      return true;
    }
    complain(fmt::format("time does not grow: {} s after {} s", time, last_time_),
             "sort the log by time, and give each run a file of its own");
    last_time_ = time;
  }
  return false;
}

// What is wrong with an entry that is no number.
void LogReader::complain_about(std::string_view entry, const LogColumn& column) {
  if (entry.empty()) {
    complain(fmt::format("column \"{}\": missing value", column.name), "leave out lines that are not complete");
  } else {
    complain(fmt::format("column \"{}\": \"{}\" is not a finite number", column.name, entry),
             "numbers have a decimal point, columns are separated by commas");
  }
}

bool LogReader::parse(std::string_view line, double* channels) {
  const std::vector<LogColumn>& columns = heading_.columns;
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (at > end) {
      complain(fmt::format("{} entries, but the heading has {} columns", k, columns.size()),
               "leave out lines that are not complete");
      return false;
    }
    while (at < end && is_blank(*at)) ++at;
    double value = 0;
    const char* const stop = read_number(at, end, value);
    const char* last = stop != nullptr ? stop : at;
    while (last < end && is_blank(*last)) ++last;
    const bool is_number = stop != nullptr && (last == end || *last == ',');
    if (!is_number) last = std::find(at, end, ',');
    if (columns[k].channel >= 0) {
      if (!is_number) {
        complain_about({at, static_cast<std::size_t>(last - at)}, columns[k]);
        return false;
      }
      channels[columns[k].channel] = value * columns[k].factor;
    }
    at = last + 1;
  }
  if (at <= end)
    complain(fmt::format("more than the {} entries that the heading has", columns.size()),
             "numbers have a decimal point, columns are separated by commas");
  return at > end;
}

}  // namespace flatdyn
