// SPDX-License-Identifier: GPL-2.0-or-later
// CSV as the table that eval reads and as the stream that identify reads: if both accept it, they read the same.
#include <cmath>

#include "base/diagnostics/utf8.hpp"
#include "fuzz/byte_files.hpp"
#include "fuzz/readers.hpp"
#include "laboratory/identify/log_reader.hpp"
#include "robot/input/csv/table.hpp"
#include "robot/input/reader.hpp"

namespace flatdyn::testing {
namespace {

using Samples = std::vector<std::vector<double>>;  // time, q1, q2

constexpr std::size_t kMostRows = 64;

const Mechanism& arm() {
  static const Mechanism mechanism = [] {
    Diagnostics none;
    return make_mechanism(read_robot(file_of(kArm, "arm.toml"), {}, none).value());
  }();
  return mechanism;
}

void require_messages(const Diagnostics& diagnostics) {
  for (const Diagnostic& found : diagnostics.all()) {
    require(!found.message.empty() && is_utf8(found.message), "a diagnostic without a message, or with other bytes");
  }
}

// The samples; empty after an error.
Samples read_table(const std::string& file) {
  Diagnostics found;
  Samples rows;
  CsvTable table = read_csv(file, found);
  CsvHeading heading = table.heading(file, arm(), found);
  const std::optional<CsvTime> time = heading.require_time();
  const std::vector<CsvSource> q = heading.require(CsvQuantity::q, "positions");
  for (const CsvQuantity quantity : {CsvQuantity::qd, CsvQuantity::qdd, CsvQuantity::h_e})
    heading.all_or_none(quantity);
  heading.find(CsvQuantity::pi_b, 3);
  heading.finish();
  check_entries(table, q, heading, file, found);
  const std::vector<double> times = time ? times_of(table, *time, file, found) : std::vector<double>();
  require_messages(found);
  if (found.has_errors()) return rows;
  require(q.size() == 2, "accepted without positions");
  for (std::size_t row = 0; row < std::min(table.rows.size(), kMostRows); ++row) {
    rows.push_back({times[row]});
    for (const CsvSource& source : q) rows.back().push_back(nearest_double(exact_value(table, row, source)));
  }
  return rows;
}

Samples read_log(const std::string& file) {
  Diagnostics found;
  Samples rows;
  LogReader reader(file, arm(), {.torques = false}, found);
  require_messages(found);
  if (found.has_errors()) return rows;
  std::vector<double> channels(static_cast<std::size_t>(reader.layout().channels()));
  while (rows.size() < kMostRows && reader.next(channels.data()))
    rows.emplace_back(channels.begin(), channels.begin() + 3);
  LogReader again(file, reader.heading(), found);
  again.skip(static_cast<long>(kMostRows));
  require_messages(found);
  return found.has_errors() ? Samples() : rows;
}

bool is_near(double a, double b) { return !(std::abs(a - b) > 1e-9 * (1 + std::abs(a))); }

}  // namespace

void read_csv_bytes(std::string_view bytes) {
  const std::string file = file_of(bytes, "log.csv");
  const Samples table = read_table(file), log = read_log(file);
  for (std::size_t row = 0; row < std::min(table.size(), log.size()); ++row) {
    for (std::size_t k = 0; k < 3; ++k) {
      require(std::isfinite(log[row][k]), "a number is not finite");
      require(is_near(table[row][k], log[row][k]), "the table and the stream have different numbers");
    }
  }
}

}  // namespace flatdyn::testing
