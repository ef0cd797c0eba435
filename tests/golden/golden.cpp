// SPDX-License-Identifier: GPL-2.0-or-later
#include "golden/golden.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace flatdyn::testing {

namespace fs = std::filesystem;

namespace {

// The files of code below a folder, relative to it: not manifests, nor what the program prints.
std::vector<fs::path> code_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    const bool is_code =
        kind == ".hpp" || kind == ".cpp" || kind == ".h" || kind == ".c" || kind == ".rs" || kind == ".toml";
    if (is_code) files.push_back(entry.path().lexically_relative(folder));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string first_difference(const std::string& expected, const std::string& produced) {
  std::istringstream a(expected), b(produced);
  std::string line_a, line_b;
  for (int number = 1;; ++number) {
    const bool more_a = static_cast<bool>(std::getline(a, line_a));
    const bool more_b = static_cast<bool>(std::getline(b, line_b));
    if (!more_a && !more_b) return "differs in how it ends";
    if (more_a == more_b && line_a == line_b) continue;
    return fmt::format("differs from line {} on:\n  checked in: {}\n  now:        {}", number,
                       more_a ? line_a : "(end)", more_b ? line_b : "(end)");
  }
}

}  // namespace

std::vector<GoldenCase> read_cases(const fs::path& table) {
  std::vector<GoldenCase> cases;
  std::ifstream file(table);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    GoldenCase golden;
    if (!(words >> golden.robot) || golden.robot.front() == '#') continue;
    for (std::string word; words >> word;) golden.options += " " + word;
    cases.push_back(golden);
  }
  return cases;
}

std::string generate(const std::string& program, const fs::path& source_dir, const GoldenCase& golden,
                     const fs::path& output) {
  const fs::path log = output / "log";
  const std::string command = fmt::format("cd '{}' && '{}' generate {} -o '{}'{} > '{}' 2>&1", source_dir.string(),
                                          program, golden.robot, output.string(), golden.options, log.string());
  if (std::system(command.c_str()) == 0) return "";
  return "failed: " + command + "\n" + content_of(log);
}

std::vector<std::string> differences(const fs::path& expected, const fs::path& produced) {
  std::vector<std::string> found;
  const std::vector<fs::path> files = code_in(produced);
  if (files.empty()) found.push_back("no header was written");
  for (const fs::path& file : files) {
    if (!fs::exists(expected / file)) {
      found.push_back(file.string() + " is not checked in");
      continue;
    }
    const std::string before = content_of(expected / file), now = content_of(produced / file);
    if (before != now) found.push_back(file.string() + " " + first_difference(before, now));
  }
  return found;
}

std::vector<std::string> robot_files() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(FLATDYN_SOURCE_DIR) / "robots")) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".urdf" || extension == ".toml") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string content_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

std::string output_of(const fs::path& folder, const std::string& command) {
  const int status = std::system(fmt::format("cd '{}' && ({}) > log 2>&1", folder.string(), command).c_str());
  return (status == 0 ? "" : "failed: ") + content_of(folder / "log");
}

TemporaryFolder::TemporaryFolder() {
  static int count = 0;
  path_ = fs::path(::testing::TempDir()) / fmt::format("flatdyn-golden-{}-{}", getpid(), count++);
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace flatdyn::testing
