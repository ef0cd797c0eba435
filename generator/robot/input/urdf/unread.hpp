// SPDX-License-Identifier: GPL-2.0-or-later
// Elements of a URDF that nothing is read from: left out with a note, or refused where the robot that is meant may be
// another one than is read without them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "robot/input/urdf/values.hpp"

namespace flatdyn {

// The children that an element may have: those that are read, and those that have nothing to do with dynamics.
struct ChildNames {
  std::vector<std::string> read;
  std::vector<std::string> irrelevant;
  bool holder_moves = true;  // what does not move is not changed by springs, friction, and gears
  bool reads_text = false;   // the text between the children is read as well
};

class UnreadElements {
 public:
  explicit UnreadElements(const UrdfValues& values) : values_(values), diagnostics_(values.context().diagnostics) {}

  // Children of `holder`, and its text.
  void check(const FileNode& holder, const std::string& what, const ChildNames& names);

  // The same where the holder does not move: what is spelt almost like what is read of it.
  void check_spelling(const FileNode& holder, const std::string& what, const std::vector<std::string>& read);

  // Elements with a mass in an element that has nothing to do with dynamics: <visual><inertial>.
  void check_bodies_in(const FileNode& element, const std::string& what);

  void note(const FileNode& element, const std::string& what);

 private:
  bool refuse_spelling(const FileNode& element, const std::string& what, const std::vector<std::string>& read);
  bool refuse_place(const FileNode& element, const std::string& what);
  bool refuse_words_of_sdf(const FileNode& element, const std::string& what);
  bool check_switch(const FileNode& element, const std::string& what);
  bool refuse_contents(const FileNode& element, const std::string& what);
  void check_one(const FileNode& element, const std::string& what, const ChildNames& names);

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  std::set<std::string> noted_;  // once per file and name
};

// Where an element of this name is read from: "joint"; "" if no values are read from such elements.
std::string parent_of_element(std::string_view name);

}  // namespace flatdyn
