// SPDX-License-Identifier: GPL-2.0-or-later
// A log of measured motion (CSV), read as a stream: memory does not grow with its length.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "identify/log_layout.hpp"
#include "input/csv/text.hpp"

namespace flatdyn {

class LogReader {
 public:
  // Reads the heading; `torques`: it must have them. Throws Failure(io); what is wrong with the heading goes into
  // `diagnostics`.
  LogReader(const std::filesystem::path& path, const Mechanism& mechanism, bool torques, Diagnostics& diagnostics);
  // Once more, with the heading that was read before.
  LogReader(const std::filesystem::path& path, LogHeading heading, Diagnostics& diagnostics);

  const LogHeading& heading() const { return heading_; }
  const LogLayout& layout() const { return heading_.layout; }
  Place place() const { return {path_, lines_.number()}; }

  // The next sample's channels (layout().channels() numbers, SI) into `channels`. False at the end, and after the 20th
  // error: entries missing or too many, no numbers, names of joints that change, time that does not grow.
  bool next(double* channels);
  // Passes over up to `count` samples without reading their numbers; how many there were.
  long skip(long count);

 private:
  bool parse(std::string_view line, double* channels);
  // One entry, from `at` on; where it ends, or null after an error.
  const char* parse_entry(const LogColumn& column, const char* at, const char* end, double* channels);
  const char* parse_number(const LogColumn& column, const char* at, const char* end, double* channels);
  bool read_marked_number(std::string_view entry, double& value);
  bool set_time(double* channels);
  void complain_about(std::string_view entry, const LogColumn& column);
  bool complain(const std::string& message, const std::string& hint = {});

  std::string path_;
  LineReader lines_;
  Diagnostics& diagnostics_;
  LogHeading heading_;
  DecimalMarks marks_{','};
  std::string time_, nanoseconds_;  // of the line, where the clock reads text
  int errors_ = 0;
  double last_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace flatdyn
