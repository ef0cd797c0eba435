// SPDX-License-Identifier: GPL-2.0-or-later
// Reads a log of measured motion (CSV) as a stream: memory does not grow with its length.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "laboratory/identify/log_layout.hpp"
#include "robot/input/csv/text.hpp"

namespace flatdyn {

class LogReader {
 public:
  // Reads the heading, which must have what is needed. rate: LogHeading::rate. Throws Failure(io); errors
  // of the heading go into `diagnostics`.
  LogReader(const std::filesystem::path& path, const Mechanism& mechanism, const LogNeeds& needs,
            Diagnostics& diagnostics, double rate = 0);
  // Opens the log again with a heading that was read before.
  LogReader(const std::filesystem::path& path, LogHeading heading, Diagnostics& diagnostics);

  const LogHeading& heading() const { return heading_; }
  const LogLayout& layout() const { return heading_.layout; }
  Place place() const { return {path_, line()}; }
  int line() const { return lines_.number(); }  // of the file, counted from 1

  // Reads the next sample into `channels`: layout().channels() numbers, SI. Returns false at the end and after the 20th
  // error: missing or extra entries, entries that are not numbers, a joint's name that changes, time that does not
  // grow.
  bool next(double* channels);
  // Skips up to `count` samples without reading their numbers; returns how many there were.
  long skip(long count);
  // Goes to the sample behind a place in the file, 0 … 1 of its bytes; place() is meaningless from there on, and times
  // by LogHeading::rate are those of rows that are as long as the ones before.
  void jump(double share);

 private:
  bool parse(std::string_view line, double* channels);
  // Reads the entry at `at`. Returns its end, or null after an error.
  const char* parse_entry(const LogColumn& column, const char* at, const char* end, double* channels);
  const char* parse_number(const LogColumn& column, const char* at, const char* end, double* channels);
  bool read_marked_number(std::string_view entry, double& value);
  bool set_time(double* channels);
  void find_quaternions();
  bool set_quaternions(double* channels);
  void report_bad_entry(std::string_view entry, const LogColumn& column);
  bool report_error(const std::string& message, const std::string& hint = {});

  std::string path_;
  LineReader lines_;
  Diagnostics& diagnostics_;
  LogHeading heading_;
  DecimalMarks marks_{','};
  std::string time_, nanoseconds_;  // texts of the current line, where the clock is read as text
  int errors_ = 0;
  long rows_ = 0;  // that were read or skipped, where they give the time
  double last_time_ = -std::numeric_limits<double>::infinity();
  std::vector<int> quaternions_;  // LogLayout::quaternions()
  std::vector<Eigen::Vector4d> last_quaternions_;
};

}  // namespace flatdyn
