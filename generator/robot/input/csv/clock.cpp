// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "robot/input/csv/text.hpp"

namespace flatdyn {
namespace {

constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
constexpr std::size_t kPlaces = 18;

std::optional<std::int64_t> whole_number(std::string_view digits) {
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || stop != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::optional<double> finite_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<ExactTime> ExactTime::read(std::string_view text) {
  const bool negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view before = text.substr(0, point), behind = text.substr(std::min(point + 1, text.size()));
  if (!is_digits(before) || (!behind.empty() && !is_digits(behind))) return std::nullopt;
  std::string places(behind.substr(0, kPlaces));
  places.resize(kPlaces, '0');
  const auto whole = whole_number(before), fraction = whole_number(places);
  if (!whole || !fraction) return std::nullopt;
  return ExactTime{negative ? -*whole : *whole, negative ? -*fraction : *fraction};
}

double ExactTime::minus(const ExactTime& other) const {
  const double wholes = (whole < 0) == (other.whole < 0)
                            ? static_cast<double>(whole - other.whole)
                            : static_cast<double>(whole) - static_cast<double>(other.whole);
  return wholes + static_cast<double>(fraction - other.fraction) / 1e18;
}

std::optional<double> CsvClock::seconds(std::string_view text) const {
  if (origin) {
    if (const std::optional<ExactTime> time = ExactTime::read(text)) return time->minus(*origin) / per_second;
  }
  const std::optional<double> value = finite_number(text);
  if (!value) return std::nullopt;
  return (*value - (origin ? static_cast<double>(origin->whole) : 0)) / per_second;
}

std::optional<double> CsvClock::seconds(std::string_view seconds, std::string_view nanoseconds) const {
  const std::optional<ExactTime> time = joined_time(seconds, nanoseconds);
  if (!time) return std::nullopt;
  return time->minus(origin.value_or(ExactTime{})) / per_second;
}

void CsvClock::start_at(const ExactTime& first) {
  constexpr double kLongAgo = 1e6;  // s
  if (std::abs(static_cast<double>(first.whole)) >= kLongAgo * per_second) origin = first;
}

std::optional<ExactTime> joined_time(std::string_view seconds, std::string_view nanoseconds) {
  constexpr std::int64_t kMostSeconds = 9'000'000'000;
  const auto whole = whole_number(seconds), rest = whole_number(nanoseconds);
  if (!whole || *whole < -kMostSeconds || *whole > kMostSeconds) return std::nullopt;
  if (!rest || *rest < 0 || *rest >= kNanosecondsPerSecond) return std::nullopt;
  return ExactTime{*whole * kNanosecondsPerSecond + *rest, 0};
}

const char* unit_since_1970(std::string_view text) {
  constexpr double kIn2001 = 1e9, kIn2100 = 4.1e9;  // s
  const std::optional<double> value = finite_number(text);
  if (!value) return nullptr;
  double unit = 1;
  for (const char* name : {"s", "ms", "us", "ns"}) {
    if (*value >= kIn2001 * unit && *value < kIn2100 * unit) return name;
    unit *= 1000;
  }
  return nullptr;
}

const char* unit_by_size(double step) { return step < 1e3 ? "ms" : step < 1e6 ? "us" : "ns"; }

void warn_of_time_unit(double step, const std::string& unit, const std::string& column, const Place& place,
                       Diagnostics& diagnostics) {
  diagnostics.warning(place, fmt::format("from one sample to the next, {:.6g} s pass", step),
                      fmt::format("is the time in {0}? Then write the column's heading as {1} [{0}]", unit, column));
}

}  // namespace flatdyn
