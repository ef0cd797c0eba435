// SPDX-License-Identifier: GPL-2.0-or-later
// A log of measured motion (CSV), read as a stream: memory does not grow with its length.
#pragma once

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "identify/log_layout.hpp"

namespace flatdyn {

// The lines of a file, by blocks; a line is a view that holds until the next one.
class LineReader {
 public:
  // Throws Failure(io) if the file cannot be read, or is no file that can be read twice.
  explicit LineReader(const std::filesystem::path& path);

  // False at the end. Without the line's end (\n or \r\n).
  bool next(std::string_view& line);
  // Of the line last read, counted from 1.
  int number() const { return number_; }

 private:
  bool refill();

  std::ifstream file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  int number_ = 0;
};

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
  // error: entries missing or too many, no numbers, time that does not grow.
  bool next(double* channels);
  // Passes over up to `count` samples without reading their numbers; how many there were.
  long skip(long count);

 private:
  bool next_line(std::string_view& line);
  bool parse(std::string_view line, double* channels);
  void complain_about(std::string_view entry, const LogColumn& column);
  bool complain(const std::string& message, const std::string& hint = {});

  std::string path_;
  LineReader lines_;
  Diagnostics& diagnostics_;
  LogHeading heading_;
  int errors_ = 0;
  double last_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace flatdyn
