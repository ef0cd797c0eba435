// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/csv_table.hpp"

#include <fmt/format.h>

#include "diagnostics/utf8.hpp"
#include "input/csv_text.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kMostMessages = 20;

bool is_exact_decimal(const std::string& text) {
  try {
    exact_decimal(text);
    return true;
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
    DecimalMarks marks(separator);
    while (diagnostics_.all().size() < kMostMessages && lines_.next_row(line)) {
      std::vector<std::string> entries = csv_entries(line, separator);
      if (!is_good(line, entries.size(), table.columns.size())) continue;
      for (std::string& entry : entries) normalise(entry, marks);
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

  void normalise(std::string& entry, DecimalMarks& marks) {
    if (marks.normalise(entry)) return;
    diagnostics_.error(place(), fmt::format("\"{}\": decimal commas and decimal points in one file", entry),
                       "write all numbers with one of them, and none between thousands");
  }

  std::string file_;
  LineReader lines_;
  Diagnostics& diagnostics_;
};

}  // namespace

CsvHeading CsvTable::heading(const std::string& file, const Mechanism& mechanism, Diagnostics& diagnostics) const {
  return {
      columns, rows.empty() ? std::vector<std::string>() : rows.front(), {file, heading_line}, mechanism, diagnostics};
}

CsvTable read_csv(const std::filesystem::path& path, Diagnostics& diagnostics) {
  CsvTable table = TableReader(path, diagnostics).read();
  if (table.rows.empty() && !diagnostics.has_errors()) {
    diagnostics.error({path.string(), 0}, "no states in the file",
                      "a heading such as q1,q2,qd1,qd2 and a line for each state");
  }
  return table;
}

void check_entries(const CsvTable& table, const std::vector<CsvSource>& sources, const CsvHeading& heading,
                   const std::string& file, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.all().size();
  for (std::size_t row = 0; row < table.rows.size() && diagnostics.all().size() < before + kMostMessages; ++row) {
    const Place place{file, table.lines[row]};
    for (const CsvSource& source : sources) {
      const std::string& entry = table.rows[row][source.column];
      if (is_exact_decimal(entry)) continue;
      diagnostics.error(
          place, fmt::format("column \"{}\": \"{}\" is not a finite number", heading.name(source.column), entry));
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

std::vector<double> times_of(const CsvTable& table, const CsvTime& time, const std::string& file,
                             Diagnostics& diagnostics) {
  std::vector<double> times;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string& text = table.rows[row][time.column];
    const std::optional<double> seconds =
        time.nanoseconds ? time.clock.seconds(text, table.rows[row][*time.nanoseconds]) : time.clock.seconds(text);
    times.push_back(seconds.value_or(0));
    if (seconds) continue;
    diagnostics.error({file, table.lines[row]},
                      fmt::format("column \"{}\": \"{}\" is no time", table.columns[time.column], text));
    if (diagnostics.all().size() >= kMostMessages) break;
  }
  return times;
}

Number exact_value(const CsvTable& table, std::size_t row, const CsvSource& source) {
  return exact_decimal(table.rows[row][source.column]) * source.factor;
}

}  // namespace flatdyn
