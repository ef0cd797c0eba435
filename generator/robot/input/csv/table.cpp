// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/table.hpp"

#include <fmt/format.h>

#include "base/diagnostics/utf8.hpp"
#include "robot/input/csv/text.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kMostMessages = 20;
constexpr const char* kOneMark = "write all numbers with one of them, and none between thousands";

// A decimal that is a finite double.
bool is_finite_decimal(const std::string& text) {
  static const GiNaC::numeric kLargest = magnitude(exact_decimal("1.7e308"));
  try {
    return magnitude(exact_decimal(text)) < kLargest;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

class TableReader {
 public:
  TableReader(const std::filesystem::path& path, Diagnostics& diagnostics)
      : file_(path.string()), lines_(path, LineReader::Reading::once), diagnostics_(diagnostics) {}

  CsvTable read() {
    CsvTable table;
    std::string_view line;
    if (!lines_.next_row(line)) return table;
    table.heading_line = lines_.number();
    if (!is_csv_heading(line, place(), diagnostics_)) return table;
    const char separator = separator_of(line);
    table.columns = csv_entries(line, separator);
    table.marks = DecimalMarks(separator);
    while (diagnostics_.all().size() < kMostMessages && lines_.next_row(line)) {
      std::vector<std::string> entries = csv_entries(line, separator);
      if (!is_good(line, entries.size(), table.columns.size())) continue;
      table.rows.push_back(std::move(entries));
      table.lines.push_back(lines_.number());
    }
    return table;
  }

 private:
  Place place() const { return {file_, lines_.number()}; }

  bool is_good(std::string_view line, std::size_t entries, std::size_t columns) {
    if (entries != columns) {
      diagnostics_.error(place(), fmt::format("{} entries, but the heading has {} columns", entries, columns));
      return false;
    }
    if (is_utf8(line)) return true;
    diagnostics_.error(place(), "the line is not UTF-8",
                       "convert the file first: iconv -f WINDOWS-1252 -t UTF-8 FILE > FILE.csv");
    return false;
  }

  std::string file_;
  LineReader lines_;
  Diagnostics& diagnostics_;
};

}  // namespace

CsvHeading CsvTable::heading(const std::string& file, const Mechanism& mechanism, Diagnostics& diagnostics) const {
  std::vector<std::string> first_row = rows.empty() ? std::vector<std::string>() : rows.front();
  for (std::string& entry : first_row) DecimalMarks(marks).normalise(entry);
  return {columns, std::move(first_row), {file, heading_line}, mechanism, diagnostics};
}

CsvTable read_csv(const std::filesystem::path& path, Diagnostics& diagnostics) {
  CsvTable table = TableReader(path, diagnostics).read();
  if (table.rows.empty() && !diagnostics.has_errors()) {
    diagnostics.error({path.string(), 0}, "no states in the file",
                      "a heading such as q1,q2,qd1,qd2 and a line for each state");
  }
  return table;
}

void check_entries(CsvTable& table, const std::vector<CsvSource>& sources, const CsvHeading& heading,
                   const std::string& file, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.all().size();
  for (std::size_t row = 0; row < table.rows.size() && diagnostics.all().size() < before + kMostMessages; ++row) {
    const Place place{file, table.lines[row]};
    for (const CsvSource& source : sources) {
      std::string& entry = table.rows[row][source.column];
      const bool is_marked_well = table.marks.normalise(entry);
      if (is_marked_well && is_finite_decimal(entry)) continue;
      diagnostics.error(
          place,
          fmt::format("column \"{}\": \"{}\"{}", heading.name(source.column), entry,
                      is_marked_well ? " is not a finite number" : ": decimal commas and decimal points in one file"),
          is_marked_well ? "" : kOneMark);
    }
    for (const auto& [column, text] : heading.fixed_texts()) {
      const std::string& entry = table.rows[row][column];
      if (entry == text) continue;
      diagnostics.error(
          place,
          fmt::format("column \"{}\": \"{}\" is not \"{}\", as in the first row", heading.name(column), entry, text),
          "the joints change their order, or these are messages of several senders: keep one of them");
    }
  }
}

std::vector<double> times_of(CsvTable& table, const CsvTime& time, const std::string& file, Diagnostics& diagnostics) {
  std::vector<double> times;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::string& text = table.rows[row][time.column];
    const bool is_marked_well = table.marks.normalise(text);
    const std::optional<double> seconds =
        time.nanoseconds ? time.clock.seconds(text, table.rows[row][*time.nanoseconds]) : time.clock.seconds(text);
    times.push_back(seconds.value_or(0));
    if (seconds && is_marked_well) continue;
    diagnostics.error({file, table.lines[row]},
                      fmt::format("column \"{}\": \"{}\" is no time", table.columns[time.column], text),
                      is_marked_well ? "" : kOneMark);
    if (diagnostics.all().size() >= kMostMessages) break;
  }
  return times;
}

Number exact_value(const CsvTable& table, std::size_t row, const CsvSource& source) {
  return exact_decimal(table.rows[row][source.column]) * source.factor;
}

}  // namespace flatdyn
