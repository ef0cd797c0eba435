// SPDX-License-Identifier: GPL-2.0-or-later
// The times of a CSV file: in which column, in which unit, since when.
#include <fmt/format.h>

#include "robot/input/csv/heading.hpp"
#include "robot/input/csv/text.hpp"
#include "robot/input/csv/units.hpp"

namespace flatdyn {
namespace {

double per_second(const std::string& unit) { return nearest_double(1 / *unit_factor(unit, CsvDimension::time)); }

// Whole numbers in these columns are nanoseconds, however small: simulated time begins with 0.
bool is_of_bag(const CsvName& column) {
  return column.style == CsvStyle::message_bag || column.name == "field.header.stamp";
}

const char* long_name(const std::string& unit) {
  if (unit == "ms") return "milliseconds";
  return unit == "us" ? "microseconds" : "nanoseconds";
}

}  // namespace

std::optional<std::size_t> CsvHeading::only_column(CsvQuantity quantity) {
  const std::vector<std::size_t> columns = columns_of(quantity);
  if (columns.empty()) return std::nullopt;
  if (columns.size() > 1) {
    diagnostics_.error(place_, fmt::format("several columns are times: {}", names_of(columns)),
                       "name the right one t, or leave the others out");
    wrong_.insert(CsvQuantity::time);
  }
  return columns.front();
}

std::optional<CsvTime> CsvHeading::find_time() {
  const std::optional<std::size_t> whole = only_column(CsvQuantity::time), seconds = only_column(CsvQuantity::seconds);
  if (wrong_.count(CsvQuantity::time) > 0) return std::nullopt;
  if (seconds && (!whole || columns_[*whole].style >= columns_[*seconds].style)) return time_in_two_columns(*seconds);
  if (!whole) return std::nullopt;
  return time_of(*whole);
}

std::optional<CsvTime> CsvHeading::require_time() {
  const std::optional<CsvTime> time = find_time();
  if (!time && wrong_.count(CsvQuantity::time) == 0) {
    diagnostics_.error(place_, "no column for the time: t",
                       "seconds, in a column t or time; other units stand in brackets: t [ms]");
  }
  return time;
}

CsvTime CsvHeading::time_of(std::size_t column) {
  const CsvName& written = columns_[column];
  used_.insert(column);
  CsvTime time{column};
  std::string explanation;
  if (!written.unit.empty()) {
    time.clock.per_second = nearest_double(1 / source_of(column, CsvQuantity::time, 0).factor);
  } else if (is_of_bag(written) && is_digits(first_text(column))) {
    time.clock.per_second = per_second("ns");
    explanation = "nanoseconds, as ROS writes them";
  } else if (const char* unit = unit_since_1970(first_text(column)); unit != nullptr && unit != std::string("s")) {
    time.clock.per_second = per_second(unit);
    explanation = fmt::format("{} since 1970, by the size of {}", long_name(unit), first_text(column));
  }
  if (const std::optional<ExactTime> first = ExactTime::read(first_text(column))) time.clock.start_at(*first);
  note_origin(time, explanation);
  return time;
}

std::optional<CsvTime> CsvHeading::time_in_two_columns(std::size_t seconds) {
  const std::optional<std::size_t> nanoseconds = only_column(CsvQuantity::nanoseconds);
  if (wrong_.count(CsvQuantity::time) > 0) return std::nullopt;
  if (!nanoseconds) {
    diagnostics_.error(place_, fmt::format("column {}: there is no column of its nanoseconds", name(seconds)),
                       "write both, as header.stamp.secs and header.stamp.nsecs");
    wrong_.insert(CsvQuantity::time);
    return std::nullopt;
  }
  used_.insert({seconds, *nanoseconds});
  CsvTime time{seconds, nanoseconds};
  time.clock.per_second = per_second("ns");
  if (const auto first = joined_time(first_text(seconds), first_text(*nanoseconds))) time.clock.start_at(*first);
  note_origin(time, fmt::format("seconds, and {} nanoseconds", name(*nanoseconds)));
  return time;
}

void CsvHeading::note_origin(CsvTime& time, const std::string& explanation) {
  const std::string counted = time.clock.origin ? "times count from the first row" : "";
  if (explanation.empty() && counted.empty()) return;
  diagnostics_.note(place_,
                    fmt::format("column \"{}\": {}{}{}", name(time.column), explanation,
                                explanation.empty() || counted.empty() ? "" : "; ", counted),
                    {}, "clocks that were converted");
}

}  // namespace flatdyn
