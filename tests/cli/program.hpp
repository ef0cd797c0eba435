// SPDX-License-Identifier: GPL-2.0-or-later
// Runs the built program as a user does: it passes arguments and collects exit code, stdout and stderr.
#pragma once

#include <filesystem>
#include <string>

namespace flatdyn::testing {

struct Outcome {
  int code = -1;
  std::string out, err;
};

// Runs flatdyn in the project's folder; `arguments` as a shell takes them.
Outcome run_flatdyn(const std::string& arguments);

// A folder for one test, which is removed at its end.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path(const std::string& name = "") const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  bool is_empty() const { return std::filesystem::is_empty(folder_); }

 private:
  std::filesystem::path folder_;
};

}  // namespace flatdyn::testing
