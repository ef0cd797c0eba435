// SPDX-License-Identifier: GPL-2.0-or-later
// Times as logs write them → seconds. Clocks that count nanoseconds since 1970 have more digits than a double: the
// first time is subtracted before they are lost.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

// A decimal as it is written, to 18 places behind its point.
struct ExactTime {
  std::int64_t whole = 0;
  std::int64_t fraction = 0;  // 1e-18, of the sign of the time

  // nullopt for what is no plain decimal ("1e9" is not one) or has more than 18 digits before its point, but for those
  // that 64 bits hold.
  static std::optional<ExactTime> read(std::string_view text);

  double minus(const ExactTime& other) const;
};

struct CsvClock {
  double per_second = 1;              // how many of the written unit
  std::optional<ExactTime> origin{};  // in the written unit; none: times are small enough as they are

  // Seconds since the origin. nullopt if the text is no finite number.
  std::optional<double> seconds(std::string_view text) const;
  // For a time in seconds and nanoseconds, both whole numbers; the origin is in nanoseconds.
  std::optional<double> seconds(std::string_view seconds, std::string_view nanoseconds) const;

  // Counts times from the first one, if they are so long ago that doubles would lose digits of them (10⁶ s).
  void start_at(const ExactTime& first);
};

// Seconds and nanoseconds → nanoseconds.
std::optional<ExactTime> joined_time(std::string_view seconds, std::string_view nanoseconds);

// The unit, "s", "ms", "us" or "ns", in which a number is a time between 2001 and 2100 counted from 1970; nullptr if it
// is not such a time in any of them.
const char* unit_since_1970(std::string_view text);

// Samples that are so far apart, s, are perhaps in another unit.
inline constexpr double kFarApart = 1;

// The unit that the time between samples, read as seconds, suggests by its size.
const char* unit_by_size(double step);

// Whether the times of a column are in this unit: a warning that asks.
void warn_of_time_unit(double step, const std::string& unit, const std::string& column, const Place& place,
                       Diagnostics& diagnostics);

}  // namespace flatdyn
