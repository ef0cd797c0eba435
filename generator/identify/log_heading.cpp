// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/log_layout.hpp"
#include "input/csv/heading.hpp"
#include "input/csv/text.hpp"

namespace flatdyn {
namespace {

class LayoutReader {
 public:
  LayoutReader(CsvHeading& columns, const Mechanism& mechanism, LogHeading& heading)
      : columns_(columns), mechanism_(mechanism), heading_(heading) {}

  void read(bool torques, const Diagnostics& found) {
    LogLayout& layout = heading_.layout;
    layout.joints = mechanism_.size();
    layout.positions = mechanism_.position_count();
    for (int i = 0; i < mechanism_.size(); ++i) layout.position_of.push_back(mechanism_.position_of(i));
    layout.has_torques = torques;
    const std::optional<CsvTime> time = columns_.require_time();
    const std::vector<CsvSource> q = columns_.require(CsvQuantity::q, "positions");
    std::vector<CsvSource> tau;
    if (torques) {
      tau = columns_.require(CsvQuantity::tau, "torques");
    } else {
      columns_.allow_unused(CsvQuantity::tau);
    }
    const std::vector<CsvSource> qd = columns_.all_or_none(CsvQuantity::qd),
                                 qdd = columns_.all_or_none(CsvQuantity::qdd),
                                 h_e = columns_.all_or_none(CsvQuantity::h_e);
    layout.has_rates = !qd.empty();
    layout.has_accelerations = !qdd.empty();
    layout.has_tip_force = !h_e.empty();
    columns_.finish();
    if (found.has_errors()) return;
    place_time(*time);
    place(q, LogLayout::q());
    place(tau, layout.tau());
    place(qd, layout.qd());
    place(qdd, layout.qdd());
    place(h_e, layout.h_e());
    for (const auto& [column, text] : columns_.fixed_texts()) {
      heading_.columns[column].role = LogColumn::Role::fixed_text;
      heading_.columns[column].text = text;
    }
  }

 private:
  void place(const std::vector<CsvSource>& sources, int first) {
    for (const CsvSource& source : sources) {
      LogColumn& column = heading_.columns[source.column];
      column.role = LogColumn::Role::number;
      column.channel = first++;
      column.factor = nearest_double(source.factor);
    }
  }

  void place_time(const CsvTime& time) {
    heading_.clock = time.clock;
    heading_.has_nanoseconds = time.nanoseconds.has_value();
    heading_.columns[time.column].role = heading_.has_exact_time() ? LogColumn::Role::time : LogColumn::Role::number;
    heading_.columns[time.column].channel = LogLayout::time();
    if (time.nanoseconds) heading_.columns[*time.nanoseconds].role = LogColumn::Role::nanoseconds;
  }

  CsvHeading& columns_;
  const Mechanism& mechanism_;
  LogHeading& heading_;
};

}  // namespace

std::vector<std::string> LogHeading::channel_names() const {
  std::vector<std::string> names(static_cast<std::size_t>(layout.channels()));
  for (const LogColumn& column : columns) {
    if (column.channel >= 0) names[static_cast<std::size_t>(column.channel)] = column.name;
  }
  return names;
}

LogHeading read_heading(const std::string& line, const std::string& first_row, const Place& place,
                        const Mechanism& mechanism, bool torques, Diagnostics& diagnostics) {
  LogHeading heading;
  heading.separator = separator_of(line);
  const std::vector<std::string> names = csv_entries(line, heading.separator);
  std::vector<std::string> entries = csv_entries(first_row, heading.separator);
  for (std::string& entry : entries) DecimalMarks(heading.separator).normalise(entry);
  Diagnostics found;
  CsvHeading columns(names, std::move(entries), place, mechanism, found);
  for (std::size_t c = 0; c < names.size(); ++c) heading.columns.push_back({.name = columns.name(c)});
  LayoutReader(columns, mechanism, heading).read(torques, found);
  for (const Diagnostic& each : found.all()) diagnostics.add(each);
  return heading;
}

}  // namespace flatdyn
