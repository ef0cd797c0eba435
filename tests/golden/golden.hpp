// SPDX-License-Identifier: GPL-2.0-or-later
// Compares checked-in output with what the program writes now, byte for byte. `cmake --build … --target regenerate`
// updates it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace flatdyn::testing {

// A line of generated/robots.txt: "robots/panda.urdf --functions inverse_dynamics".
struct GoldenCase {
  std::string robot;    // relative to the source folder
  std::string options;  // options of `flatdyn generate`
};

// Reads the cases; comments (#) and empty lines are skipped.
std::vector<GoldenCase> read_cases(const std::filesystem::path& table);

// Runs `program` generate robot -o output options in `source_dir`. Returns what it printed if it fails, else nothing.
std::string generate(const std::string& program, const std::filesystem::path& source_dir, const GoldenCase& golden,
                     const std::filesystem::path& output);

// A sentence for each file of code in `produced` that is missing in `expected` or differs from it, with the first
// different line; and one if nothing was produced.
std::vector<std::string> differences(const std::filesystem::path& expected, const std::filesystem::path& produced);

// The names of all robot files in robots/, sorted: "panda.urdf".
std::vector<std::string> robot_files();

std::string content_of(const std::filesystem::path& file);
void write(const std::filesystem::path& file, const std::string& text);

// The output of a shell command run in `folder`, where it is also kept as `log`; preceded by "failed: " if the command
// does not end with 0.
std::string output_of(const std::filesystem::path& folder, const std::string& command);

// A new empty folder, removed at the end of scope.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace flatdyn::testing
