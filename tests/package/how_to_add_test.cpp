// SPDX-License-Identifier: GPL-2.0-or-later
// docs/how-to-add.md is followed to the letter in a copy of the sources, whose program is built and verifies the
// function that the page adds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

// The fenced blocks of a page.
std::vector<std::string> blocks_of(const std::string& page) {
  static const std::regex kBlock("```cpp\\n([^`]*)```");
  std::vector<std::string> blocks;
  for (std::sregex_iterator block(page.begin(), page.end(), kBlock), end; block != end; ++block) {
    blocks.push_back((*block)[1]);
  }
  return blocks;
}

void insert_before(std::string& text, const std::string& mark, const std::string& more) {
  const std::size_t place = text.find(mark);
  ASSERT_NE(place, std::string::npos) << mark;
  text.insert(place, more);
}

void copy_sources(const fs::path& to) {
  const fs::path from = FLATDYN_SOURCE_DIR;
  const auto recursive = fs::copy_options::recursive;
  for (const char* folder : {"generator", "runtime", "templates", "cmake", "robots"}) {
    fs::copy(from / folder, to / folder, recursive);
  }
  for (const char* file : {"CMakeLists.txt", "CMakePresets.json", "LICENSE"}) {
    if (fs::exists(from / file)) fs::copy(from / file, to / file, recursive);
  }
}

TEST(HowToAdd, AFunctionThatTheProgramThenVerifies) {
  const Scratch scratch;
  const fs::path folder = scratch.path();
  copy_sources(folder);
  const fs::path table = folder / "generator/functions/function_table.cpp";
  std::string rows = content(table);
  fs::copy(fs::path(FLATDYN_SOURCE_DIR) / "docs/examples/inertial_torque/generator", folder / "generator",
           fs::copy_options::recursive);
  for (const std::string& block : blocks_of(content(FLATDYN_SOURCE_DIR "/docs/how-to-add.md"))) {
    if (block.starts_with("#include")) insert_before(rows, "#include \"derivation/dynamics/acceleration", block);
    if (block.starts_with("    {.name")) insert_before(rows, "};\n\n}  // namespace", block);
  }
  write(table, rows);
  const std::string commands =
      "cd '" + folder.string() +
      "' && { cmake --preset release -D FLATDYN_TESTS=OFF && cmake --build build/release --target flatdyn && "
      "build/release/generator/flatdyn verify robots/scara.toml --functions inertial_torque; } > log 2>&1";
  EXPECT_EQ(std::system(commands.c_str()), 0) << scratch.read("log");
  EXPECT_NE(scratch.read("log").find("inertial_torque"), std::string::npos);
}

}  // namespace
}  // namespace flatdyn::testing
