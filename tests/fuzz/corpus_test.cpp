// SPDX-License-Identifier: GPL-2.0-or-later
// The corpus of the fuzz targets, file by file: errors that were found once stay fixed, also without fuzzing.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "fuzz/readers.hpp"

namespace flatdyn::testing {
namespace {

namespace fs = std::filesystem;

constexpr double kMostSeconds = 5;  // per file, also with sanitizers; a tenth is usual

void replay(const std::string& target, void (*read)(std::string_view)) {
  std::vector<fs::path> files;
  const fs::path corpus = fs::path(FLATDYN_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / target;
  for (const fs::directory_entry& entry : fs::directory_iterator(corpus)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  EXPECT_GE(files.size(), 5U);
  for (const fs::path& file : files) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NO_THROW(read(bytes.str())) << file;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    EXPECT_LT(time.count(), kMostSeconds) << file;
  }
}

TEST(Corpus, OfUrdf) { replay("urdf", read_urdf_bytes); }
TEST(Corpus, OfMjcf) { replay("mjcf", read_mjcf_bytes); }
TEST(Corpus, OfSdf) { replay("sdf", read_sdf_bytes); }
TEST(Corpus, OfToml) { replay("toml", read_toml_bytes); }
TEST(Corpus, OfScenes) { replay("scene", read_scene_bytes); }
TEST(Corpus, OfCsv) { replay("csv", read_csv_bytes); }
TEST(Corpus, OfEmittedText) { replay("text", read_text_bytes); }

}  // namespace
}  // namespace flatdyn::testing
