// SPDX-License-Identifier: GPL-2.0-or-later
// Attributes and elements in an element of a URDF that are not read there. They are left out with a note, or refused
// where something that is meant may be lost.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

class UnknownEntries {
 public:
  explicit UnknownEntries(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // Attributes, children and text of an element of which values are read.
  void check(const FileNode& element, const std::string& what);

  // Values that stand as attributes in `holder` itself and not in an element for them: <joint axis="0 0 1">.
  void check_misplaced(const FileNode& holder, const std::string& what);

 private:
  struct Known;

  bool refuse(const FileNode& element, const UrdfEntry& entry, const Known& known, const std::string& what);
  void note_left_out(const FileNode& element, const std::vector<std::string>& names, const std::string& what);

  Diagnostics& diagnostics_;
  std::set<std::string> noted_;  // said once per file: where there is one such joint, all are so
};

}  // namespace flatdyn
