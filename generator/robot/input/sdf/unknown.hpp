// SPDX-License-Identifier: GPL-2.0-or-later
// Elements and attributes of an SDF that nothing is read from: left out with a note, or refused where the robot that is
// meant may be another one than is read without them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "robot/input/sdf/values.hpp"

namespace flatdyn {

// The names that an element may have in it.
struct SdfNames {
  std::vector<std::string> read;
  std::vector<std::string> irrelevant;  // elements that have nothing to do with dynamics
  std::vector<std::string> attributes;
};

class SdfUnknown {
 public:
  // Children, attributes and stray text of an element.
  void check(const FileNode& holder, const std::string& what, const SdfNames& names, const SdfValues& values);

 private:
  void check_child(const FileNode& child, const std::string& what, const SdfNames& names, const SdfValues& values);
  void check_attributes(const FileNode& holder, const std::string& what, const SdfNames& names,
                        const SdfValues& values);

  std::set<std::string> noted_;  // once per name
};

}  // namespace flatdyn
