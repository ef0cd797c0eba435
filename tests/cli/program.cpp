// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "base/system/process.hpp"

namespace flatdyn::testing {

namespace fs = std::filesystem;

Outcome run_flatdyn(const std::string& arguments) {
  const Scratch scratch;
  const std::string command = fmt::format("cd '{}' && '{}' {} > '{}' 2> '{}'", FLATDYN_SOURCE_DIR, FLATDYN_PROGRAM,
                                          arguments, scratch.path("out"), scratch.path("err"));
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of_file(scratch.path("out")),
          content_of_file(scratch.path("err"))};
}

Scratch::Scratch() {
  static int count = 0;
  folder_ = fs::path(::testing::TempDir()) / fmt::format("flatdyn-cli-{}-{}", ::getpid(), count++);
  fs::remove_all(folder_);  // left by a program that was killed, with the same number
  fs::create_directories(folder_);
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Scratch::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string Scratch::read(const std::string& name) const { return content_of_file(folder_ / name); }

}  // namespace flatdyn::testing
