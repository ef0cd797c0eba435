// SPDX-License-Identifier: GPL-2.0-or-later
// Which column of a CSV file is which of the robot's quantities: the one place that every command takes headings from.
// docs/csv.md describes what is read.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/input/csv/clock.hpp"
#include "robot/input/csv/names.hpp"

namespace flatdyn {

// A column, and what makes its numbers SI (pi/180 of degrees, the gain of the joint's drive of a current).
struct CsvSource {
  std::size_t column = 0;
  Number factor = 1;
  bool is_current = false;
};

// Some entries of a quantity, as the base's six of q̇, q̈ and τ, or those of the joints behind them.
struct CsvEntries {
  int first = 0;
  std::optional<int> count{};  // none: all from the first on
};

struct CsvTime {
  std::size_t column = 0;
  std::optional<std::size_t> nanoseconds{};  // the column of what is left of a second
  CsvClock clock{};
};

// Quantities are asked for one by one, and what is wrong with the columns of a quantity is said when it is: a file may
// have others that nobody needs.
class CsvHeading {
 public:
  // `entries` as the heading has them; `first_row`: those of the line below it (none in a file without rows), which
  // show clocks and names of joints. `place` is the heading's.
  CsvHeading(const std::vector<std::string>& entries, std::vector<std::string> first_row, Place place,
             const Mechanism& mechanism, Diagnostics& diagnostics);

  // The columns of a quantity's entries, in the robot's order; nullopt where there is no column. Sets that are counted
  // neither from 0 nor from 1, columns that say the same, and unknown units are errors.
  std::vector<std::optional<CsvSource>> find(CsvQuantity quantity);
  std::vector<std::optional<CsvSource>> find(CsvQuantity quantity, int length);
  // Columns that are missing are errors too; `what` is "positions". After an error the result is empty.
  std::vector<CsvSource> require(CsvQuantity quantity, const std::string& what, CsvEntries entries = {});
  // Empty if no column is there. It is an error if only some are there.
  std::vector<CsvSource> all_or_none(CsvQuantity quantity, CsvEntries entries = {});
  // Seconds; large times count from the first row's.
  std::optional<CsvTime> find_time();
  std::optional<CsvTime> require_time();
  // Columns of this quantity need not be used.
  void allow_unused(CsvQuantity quantity);

  // Columns of text that say which joint is meant: their entries must stay what they are in the first row.
  const std::map<std::size_t, std::string>& fixed_texts() const { return fixed_texts_; }
  // As written, without unit.
  const std::string& name(std::size_t column) const { return columns_[column].name; }

  // Says how columns were counted, and which ones nobody asked for.
  void finish();

 private:
  using Entries = std::map<std::size_t, int>;  // column → entry of its quantity
  using Sources = std::vector<std::optional<CsvSource>>;

  std::vector<std::size_t> columns_of(CsvQuantity quantity) const;
  Entries entries_of(CsvQuantity quantity, int length);
  void place_numbered(CsvQuantity quantity, const std::vector<std::size_t>& columns, int length, Entries& entries);
  bool is_counted_well(CsvQuantity quantity, const std::vector<std::size_t>& columns, int length);
  void warn_of_numbering(CsvQuantity quantity, int length);
  void count_from_zero(const std::vector<std::size_t>& columns);
  void leave_out(CsvQuantity quantity, std::size_t column, int length);
  void place_by_joint_names(CsvQuantity quantity, const std::vector<std::size_t>& columns, Entries& entries);
  bool has_joint_names(const std::vector<std::size_t>& columns) const;
  std::optional<std::size_t> joint_name_of(std::size_t column) const;
  CsvSource source_of(std::size_t column, CsvQuantity quantity, int entry);
  CsvSource source_of_current(std::size_t column, int entry, const Number& amperes);
  std::string number_name(CsvQuantity quantity, int entry) const;
  Sources part_of(CsvQuantity quantity, CsvEntries entries);
  bool is_missing_some(CsvQuantity quantity, const Sources& found, int first, const std::string& message,
                       const std::string& hint);
  std::optional<std::size_t> only_column(CsvQuantity quantity);
  CsvTime time_of(std::size_t column);
  std::optional<CsvTime> time_in_two_columns(std::size_t seconds);
  void note_origin(CsvTime& time, const std::string& explanation);
  std::string first_text(std::size_t column) const;
  std::string names_of(const std::vector<std::size_t>& columns) const;

  std::vector<CsvName> columns_;
  std::vector<std::string> first_row_;
  Place place_;
  const Mechanism& mechanism_;
  Diagnostics& diagnostics_;
  std::set<std::size_t> used_;
  std::map<CsvQuantity, Sources> found_;
  std::set<CsvQuantity> wrong_;  // errors of their columns are said
  std::map<std::size_t, std::string> fixed_texts_;
  std::vector<std::string> from_zero_;
  std::vector<std::size_t> in_file_order_, of_other_joints_;
  std::vector<std::string> perhaps_from_zero_;  // sets that may lack their 0, as they lack their last one
};

// The first ten names, and how many there are besides.
std::string some_of(const std::vector<std::string>& names);

}  // namespace flatdyn
