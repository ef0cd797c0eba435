// SPDX-License-Identifier: GPL-2.0-or-later
// Files made to break readers: refused with a diagnostic, in little time and memory.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "robot/input/reader.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

// Two tenths are usual. Code with sanitizers, which is not optimised, takes a hundred times as long.
#ifdef __has_feature
constexpr bool kHasSanitizers = __has_feature(address_sanitizer);
#else
constexpr bool kHasSanitizers = false;
#endif
constexpr double kMostSeconds = kHasSanitizers ? 120 : 10;
constexpr long kMostKilobytes = 400'000;

std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int k = 0; k < times; ++k) result += text;
  return result;
}

long peak_kilobytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

class Hostile : public ::testing::Test {
 protected:
  Hostile() { fs::create_directories(folder_); }
  ~Hostile() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }

  // The first message; empty if there was no error.
  static std::string refusal_of(const std::string& path) {
    const auto start = std::chrono::steady_clock::now();
    const long before = peak_kilobytes();
    Diagnostics diagnostics;
    const std::optional<Robot> robot = read_robot(path, {}, diagnostics);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    EXPECT_LT(time.count(), kMostSeconds);
    EXPECT_LT(peak_kilobytes() - before, kMostKilobytes);
    EXPECT_FALSE(robot.has_value());
    return diagnostics.has_errors() ? diagnostics.all().front().message : "";
  }

  fs::path folder_ = fs::path(::testing::TempDir()) / fmt::format("flatdyn-hostile-{}", ::getpid());
};

TEST_F(Hostile, EntitiesThatGrowAreNotExpanded) {
  std::string text = "<?xml version=\"1.0\"?>\n<!DOCTYPE robot [<!ENTITY a \"aaaaaaaaaa\">\n";
  for (char c = 'b'; c < 'n'; ++c) {
    text += fmt::format("<!ENTITY {} \"{}\">\n", c, repeated(fmt::format("&{};", static_cast<char>(c - 1)), 10));
  }
  EXPECT_NE(refusal_of(file("laughs.urdf", text + "]>\n<robot name=\"x\"><link name=\"&m;\"/></robot>")), "");
}

TEST_F(Hostile, NestingOfAMillionIsRefused) {
  constexpr int kMillion = 1'000'000;
  const std::string xml = file("nested.urdf", "<robot name=\"x\">" + repeated("<link>", kMillion) + "</robot>");
  EXPECT_NE(refusal_of(xml).find("element depth exceeded"), std::string::npos);
  EXPECT_NE(refusal_of(file("nested.toml", "x = " + repeated("[", kMillion))).find("nested"), std::string::npos);
  const std::string braces = file("braces.toml", "x = " + repeated("{a = ", kMillion));
  EXPECT_NE(refusal_of(braces), "");
  const std::string brackets = file("brackets.toml", "gravity = [\"" + repeated("(", kMillion) + "1\", 0, 0]");
  EXPECT_NE(refusal_of(brackets), "");
}

TEST_F(Hostile, AFileOfAHundredMegabytesIsNotRead) {
  const std::string path = file("large.urdf", "<robot name=\"x\">");
  fs::resize_file(path, 100'000'000);
  EXPECT_NE(refusal_of(path).find("larger than 64 MB"), std::string::npos);
}

TEST_F(Hostile, TenThousandJointsAreRefused) {
  std::string text = "<robot name=\"x\"><link name=\"l0\"/>";
  for (int i = 1; i <= 10'000; ++i) {
    text += fmt::format(
        "<link name=\"l{0}\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
        "iyz=\"0\"/></inertial></link><joint name=\"j{0}\" type=\"continuous\"><parent link=\"l{1}\"/>"
        "<child link=\"l{0}\"/></joint>\n",
        i, i - 1);
  }
  EXPECT_EQ(refusal_of(file("many.urdf", text + "</robot>")),
            "the robot has 10000 joints; more than 2000 are not supported");
}

}  // namespace
}  // namespace flatdyn
