// SPDX-License-Identifier: GPL-2.0-or-later
// Robot files of tests, written to a folder of their own that is removed again.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "robot/input/reader.hpp"

namespace flatdyn {

class RobotFiles : public ::testing::Test {
 protected:
  RobotFiles() {
    std::string pattern = (std::filesystem::temp_directory_path() / "flatdyn-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~RobotFiles() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  // The robot of a file that must be without errors.
  Robot read(const std::string& name, const std::string& text, const ReadOptions& options = {}) {
    diagnostics_ = {};
    const std::optional<Robot> robot = read_robot(write(name, text), options, diagnostics_);
    EXPECT_TRUE(robot.has_value()) << (diagnostics_.all().empty() ? "" : to_string(diagnostics_.all().front()));
    return robot.value();
  }

  std::filesystem::path folder_;
  Diagnostics diagnostics_;
};

// <robot> with a base, a link of 2 kg, and a joint of this type with these elements; `more` after them.
inline std::string one_joint_urdf(const std::string& type, const std::string& elements, const std::string& more = "") {
  return "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"><inertial><mass value=\"2\"/>"
         "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
         "<joint name=\"j\" type=\"" +
         type + "\"><parent link=\"base\"/><child link=\"arm\"/>" + elements + "</joint>" + more + "</robot>";
}

}  // namespace flatdyn
