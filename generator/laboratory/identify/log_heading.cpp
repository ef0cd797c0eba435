// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <utility>

#include "laboratory/identify/log_layout.hpp"
#include "robot/input/csv/heading.hpp"
#include "robot/input/csv/text.hpp"

namespace flatdyn {
namespace {

class LayoutReader {
 public:
  LayoutReader(CsvHeading& columns, const Mechanism& mechanism, Place place, LogHeading& heading, Diagnostics& found)
      : columns_(columns), mechanism_(mechanism), place_(std::move(place)), heading_(heading), diagnostics_(found) {}

  void read(const LogNeeds& needs) {
    const bool torques = needs.torques;
    set_sizes(torques);
    LogLayout& layout = heading_.layout;
    const CsvEntries joints{layout.base};
    const std::optional<CsvTime> time = find_time();
    const std::vector<CsvSource> q = columns_.require(CsvQuantity::q, "positions");
    std::vector<CsvSource> tau;
    if (torques) {
      tau = columns_.require(CsvQuantity::tau, "torques", joints);
    } else {
      columns_.allow_unused(CsvQuantity::tau);
    }
    const std::vector<CsvSource> qd = columns_.all_or_none(CsvQuantity::qd, joints),
                                 qdd = columns_.all_or_none(CsvQuantity::qdd, joints),
                                 h_e = columns_.all_or_none(CsvQuantity::h_e);
    layout.has_rates = !qd.empty() || layout.joints == 0;
    layout.has_accelerations = !qdd.empty() || layout.joints == 0;
    layout.has_tip_force = !h_e.empty();
    const auto currents = std::count_if(tau.begin(), tau.end(), [](const CsvSource& each) { return each.is_current; });
    layout.has_currents = currents > 0 && currents == static_cast<std::ptrdiff_t>(tau.size());
    layout.has_mixed_currents = currents > 0 && !layout.has_currents;
    std::vector<CsvSource> temperatures;
    if (needs.temperatures) temperatures = columns_.require(CsvQuantity::temperature, "temperatures", joints);
    layout.has_temperatures = needs.temperatures;
    const BaseColumns base = layout.base > 0 ? base_columns(torques) : BaseColumns{};
    columns_.finish();
    if (diagnostics_.has_errors()) return;
    if (time) place_time(*time);
    place(q, LogLayout::q());
    place(base.force, layout.tau());
    place(tau, layout.tau() + layout.base);
    place(qd, layout.qd());
    place(qdd, layout.qdd());
    place(h_e, layout.h_e());
    place(base.place, layout.base_reading());
    const bool is_pose = layout.base_motion == BaseMotion::pose;
    place(base.readings, layout.base_reading() + (is_pose ? LogLayout::kQuaternionInPose : 0));
    place(base.twist, layout.twist());
    place(base.twist_rates, layout.twist_rates());
    place(temperatures, layout.temperatures());
    for (const auto& [column, text] : columns_.fixed_texts()) {
      heading_.columns[column].role = LogColumn::Role::fixed_text;
      heading_.columns[column].text = text;
    }
  }

 private:
  // The column of times; none where the rate is given.
  std::optional<CsvTime> find_time() {
    if (heading_.rate == 0) return columns_.require_time();
    if (columns_.find_time()) {
      diagnostics_.note(place_, "the column of times is not used, as --rate gives them", {},
                        "headings with columns that are not used");
    }
    return std::nullopt;
  }

  // The columns about a floating base.
  struct BaseColumns {
    std::vector<CsvSource> force, place, readings, twist, twist_rates;
  };

  void set_sizes(bool torques) {
    LogLayout& layout = heading_.layout;
    layout.base = mechanism_.base_bodies();
    layout.joints = mechanism_.size() - layout.base;
    layout.positions = mechanism_.position_count();
    for (int i = 0; i < mechanism_.size(); ++i) {
      layout.position_of.push_back(i < layout.base ? -1 : mechanism_.position_of(i));
    }
    for (const int first : mechanism_.quaternions()) {
      layout.spherical_positions.push_back(first);
      layout.spherical.push_back(mechanism_.body_at(first));
    }
    layout.has_torques = torques;
  }

  // An inertial measurement unit comes first, as nothing of it has to be differentiated twice.
  BaseColumns base_columns(bool torques) {
    LogLayout& layout = heading_.layout;
    const CsvEntries entries{0, layout.base};
    BaseColumns found;
    if (torques) found.force = columns_.all_or_none(CsvQuantity::tau, entries);
    layout.has_base_force = !found.force.empty();
    found.readings = columns_.all_or_none(CsvQuantity::imu);
    if (!found.readings.empty()) {
      layout.base_motion = BaseMotion::imu;
      note_unused_twist(entries);
      return found;
    }
    found.twist = columns_.all_or_none(CsvQuantity::qd, entries);
    found.twist_rates = columns_.all_or_none(CsvQuantity::qdd, entries);
    found.place = columns_.all_or_none(CsvQuantity::pose, {0, LogLayout::kQuaternionInPose});
    found.readings = columns_.all_or_none(CsvQuantity::pose, {LogLayout::kQuaternionInPose});
    layout.base_motion = BaseMotion::pose;
    if (found.readings.empty()) {
      found.readings = columns_.all_or_none(CsvQuantity::g_b);
      found.place.clear();  // gravity in base axes does not determine the world's axes
      layout.base_motion = BaseMotion::gravity;
    }
    layout.has_twist = !found.twist.empty();
    layout.has_twist_rates = !found.twist_rates.empty();
    layout.has_place = !found.place.empty();
    const bool is_told = layout.has_twist || !found.place.empty();
    if (found.readings.empty() || !is_told || (layout.has_twist_rates && !layout.has_twist)) refuse_base();
    return found;
  }

  void note_unused_twist(const CsvEntries& entries) {
    const bool is_there = !columns_.all_or_none(CsvQuantity::qd, entries).empty();
    if (!is_there) return;
    diagnostics_.note(place_, "columns that are not used: the base's twist, as a measurement unit tells its motion", {},
                      "headings with columns that are not used");
  }

  void refuse_base() {
    diagnostics_.error(place_, "no columns that tell the motion of the floating base",
                       "give imu_ax to imu_wz of an inertial measurement unit; or base_x to base_qz, its pose; or its "
                       "twist, base_vx to base_wz and perhaps base_dvx to base_dwz, with its quaternion, base_qw to "
                       "base_qz, or gravity in base axes, base_gx to base_gz");
  }

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
  Place place_;
  LogHeading& heading_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::vector<std::string> LogHeading::channel_names() const {
  std::vector<std::string> names(static_cast<std::size_t>(layout.channels()));
  if (rate > 0) names[static_cast<std::size_t>(LogLayout::time())] = "--rate";
  for (const LogColumn& column : columns) {
    if (column.channel >= 0) names[static_cast<std::size_t>(column.channel)] = column.name;
  }
  return names;
}

LogHeading read_heading(const std::string& line, const std::string& first_row, const Place& place,
                        const Mechanism& mechanism, const LogNeeds& needs, double rate, Diagnostics& diagnostics) {
  LogHeading heading;
  heading.rate = rate;
  heading.separator = separator_of(line);
  const std::vector<std::string> names = csv_entries(line, heading.separator);
  std::vector<std::string> entries = csv_entries(first_row, heading.separator);
  for (std::string& entry : entries) DecimalMarks(heading.separator).normalise(entry);
  Diagnostics found;
  CsvHeading columns(names, std::move(entries), place, mechanism, found);
  for (std::size_t c = 0; c < names.size(); ++c) heading.columns.push_back({.name = columns.name(c)});
  LayoutReader(columns, mechanism, place, heading, found).read(needs);
  for (const Diagnostic& each : found.all()) diagnostics.add(each);
  return heading;
}

}  // namespace flatdyn
