// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/log_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/diagnostics/utf8.hpp"

namespace flatdyn {
namespace {

constexpr int kMostErrors = 20;

bool is_blank(char c) { return c == ' ' || c == '\t'; }

// Reads what from_chars() accepts, and what other programs also write: a plus sign, and numbers too small for a double.
// Returns the end of the number; null if there is none.
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

// Reads a number that may be in quotation marks.
const char* read_number(const char* at, const char* end, double& value) {
  if (at == end || *at != '"') return read_unquoted(at, end, value);
  const char* stop = read_unquoted(at + 1, end, value);
  return stop != nullptr && stop < end && *stop == '"' ? stop + 1 : nullptr;
}

}  // namespace

LogReader::LogReader(const std::filesystem::path& path, const Mechanism& mechanism, const LogNeeds& needs,
                     Diagnostics& diagnostics, double rate)
    : path_(path.string()), lines_(path, LineReader::Reading::again), diagnostics_(diagnostics) {
  std::string_view line;
  if (!lines_.next_row(line)) {
    report_error("no samples in the file", "a heading such as t,q1,q2,tau1,tau2 and a line for each sample");
    return;
  }
  if (!is_csv_heading(line, place(), diagnostics)) return;
  const std::string heading(line);
  LineReader again(path, LineReader::Reading::again);
  std::string_view first_row;
  again.next_row(first_row);
  if (!again.next_row(first_row)) first_row = {};
  heading_ = read_heading(heading, std::string(first_row), place(), mechanism, needs, rate, diagnostics);
  marks_ = DecimalMarks(heading_.separator);
  find_quaternions();
}

LogReader::LogReader(const std::filesystem::path& path, LogHeading heading, Diagnostics& diagnostics)
    : path_(path.string()),
      lines_(path, LineReader::Reading::again),
      diagnostics_(diagnostics),
      heading_(std::move(heading)),
      marks_(heading_.separator) {
  std::string_view line;
  lines_.next_row(line);
  find_quaternions();
}

void LogReader::find_quaternions() {
  quaternions_ = layout().quaternions();
  last_quaternions_.assign(quaternions_.size(), Eigen::Vector4d::UnitX());
}

bool LogReader::report_error(const std::string& message, const std::string& hint) {
  diagnostics_.error(place(), message, hint);
  return ++errors_ < kMostErrors;
}

long LogReader::skip(long count) {
  std::string_view line;
  long done = 0;
  while (done < count && lines_.next_row(line)) ++done;
  rows_ += done;
  return done;
}

void LogReader::jump(double share) {
  const double here = lines_.share();
  if (here > 0) rows_ = std::lround(static_cast<double>(rows_) * share / here);
  lines_.jump(share);
  last_time_ = -std::numeric_limits<double>::infinity();
}

bool LogReader::next(double* channels) {
  std::string_view line;
  while (errors_ < kMostErrors && lines_.next_row(line)) {
    if (!parse(line, channels) || !set_time(channels) || !set_quaternions(channels)) continue;
    const double time = channels[LogLayout::time()];
    if (time > last_time_) {
      last_time_ = time;
      return true;
    }
    report_error(time < last_time_ ? fmt::format("time does not grow: {} s after {} s", time, last_time_)
                                   : fmt::format("time does not grow: {} s is there twice", time),
                 "sort the log by time, leave out what is there twice, and give each run a file of its own");
    last_time_ = time;
  }
  return false;
}

// Reports an entry that is not a number.
void LogReader::report_bad_entry(std::string_view entry, const LogColumn& column) {
  if (entry.empty()) {
    report_error(fmt::format("column \"{}\": missing value", column.name), "leave out lines that are not complete");
  } else {
    report_error(fmt::format("column \"{}\": \"{}\" is not a finite number", column.name,
                             is_utf8(entry) ? entry : "(text that is not UTF-8)"),
                 marks_.may_be_commas() ? "numbers have decimal points, or all of them decimal commas"
                                        : "numbers have a decimal point, columns are separated by commas");
  }
}

bool LogReader::read_marked_number(std::string_view entry, double& value) {
  std::string text = unquoted(entry);
  if (!marks_.normalise(text)) return false;
  const char* const end = text.data() + text.size();
  return read_unquoted(text.data(), end, value) == end;
}

const char* LogReader::parse_number(const LogColumn& column, const char* at, const char* end, double* channels) {
  double value = 0;
  const char* last = at;
  bool is_number = false;
  if (marks_.may_be_commas()) {
    last = end_of_entry(at, end, heading_.separator);
    is_number = read_marked_number({at, static_cast<std::size_t>(last - at)}, value);
  } else {
    const char* const stop = read_number(at, end, value);
    last = stop != nullptr ? stop : at;
    while (last < end && is_blank(*last)) ++last;
    is_number = stop != nullptr && (last == end || *last == ',');
    if (!is_number) last = end_of_entry(at, end, ',');
  }
  if (!is_number) {
    report_bad_entry({at, static_cast<std::size_t>(last - at)}, column);
    return nullptr;
  }
  channels[column.channel] = value * column.factor;
  return last;
}

const char* LogReader::parse_entry(const LogColumn& column, const char* at, const char* end, double* channels) {
  if (column.role == LogColumn::Role::number) return parse_number(column, at, end, channels);
  const char* const last = end_of_entry(at, end, heading_.separator);
  if (column.role == LogColumn::Role::unused) return last;
  std::string text = unquoted({at, static_cast<std::size_t>(last - at)});
  if (column.role == LogColumn::Role::fixed_text) {
    if (text == column.text) return last;
    report_error(fmt::format("column \"{}\" is not \"{}\", as in the first row", column.name, column.text),
                 "the joints change their order, or these are messages of several senders: keep one of them");
    return nullptr;
  }
  if (!marks_.normalise(text)) {
    report_bad_entry(text, column);
    return nullptr;
  }
  (column.role == LogColumn::Role::time ? time_ : nanoseconds_) = std::move(text);
  return last;
}

bool LogReader::set_time(double* channels) {
  const CsvClock& clock = heading_.clock;
  double& time = channels[LogLayout::time()];
  if (heading_.rate > 0) {
    time = static_cast<double>(rows_++) / heading_.rate;
    return true;
  }
  if (!heading_.has_exact_time()) {
    time /= clock.per_second;
    return true;
  }
  const std::optional<double> seconds =
      heading_.has_nanoseconds ? clock.seconds(time_, nanoseconds_) : clock.seconds(time_);
  if (seconds) {
    time = *seconds;
    return true;
  }
  const auto column = std::find_if(heading_.columns.begin(), heading_.columns.end(),
                                   [](const LogColumn& each) { return each.role == LogColumn::Role::time; });
  const std::string text = heading_.has_nanoseconds ? fmt::format("{}, {}", time_, nanoseconds_) : time_;
  report_error(
      fmt::format("column \"{}\": \"{}\" is no time", column->name, is_utf8(text) ? text : "(text that is not UTF-8)"),
      "whole numbers of seconds and nanoseconds, or a decimal number");
  return false;
}

// Makes quaternions ones of unit length, with the sign that is nearer to the last ones'.
bool LogReader::set_quaternions(double* channels) {
  constexpr double kRoundedMost = 0.02;
  for (std::size_t k = 0; k < quaternions_.size(); ++k) {
    Eigen::Map<Eigen::Vector4d> quaternion(channels + quaternions_[k]);
    const double length = quaternion.norm();
    if (std::abs(length - 1) > kRoundedMost) {
      const std::string first = heading_.channel_names()[static_cast<std::size_t>(quaternions_[k])];
      report_error(fmt::format("the quaternion that begins with column \"{}\" has the length {:.4g}", first, length),
                   "its four columns are a unit quaternion w, x, y, z");
      return false;
    }
    quaternion /= quaternion.dot(last_quaternions_[k]) < 0 ? -length : length;
    last_quaternions_[k] = quaternion;
  }
  return true;
}

bool LogReader::parse(std::string_view line, double* channels) {
  const std::vector<LogColumn>& columns = heading_.columns;
  const bool tabs = heading_.separator == '\t';
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (at > end) {
      report_error(fmt::format("{} entries, but the heading has {} columns", k, columns.size()),
                   "leave out lines that are not complete");
      return false;
    }
    while (at < end && is_blank(*at) && !tabs) ++at;
    const char* const last = parse_entry(columns[k], at, end, channels);
    if (last == nullptr) return false;
    at = last + 1;
  }
  if (at <= end)
    report_error(fmt::format("more than the {} entries that the heading has", columns.size()),
                 "numbers have a decimal point, columns are separated by commas");
  return at > end;
}

}  // namespace flatdyn
