// SPDX-License-Identifier: GPL-2.0-or-later
// Elements of a URDF that nothing is read from: left out with a note, or refused where the robot that is meant may be
// another one than is read without them.
#pragma once

#include <string>
#include <vector>

#include "robot/input/common/unknown_names.hpp"
#include "robot/input/urdf/values.hpp"

namespace flatdyn {

class UnreadElements : public UnknownNames {
 public:
  explicit UnreadElements(const UrdfValues& values);

  // The same of an element in which springs, friction and gears would change nothing, as it does not move.
  void check_still(const FileNode& element, const std::string& what);

  // Errors for what is spelt almost like what is read of a fixed joint.
  void check_spelling(const FileNode& fixed_joint, const std::string& what);

  // Elements with a mass in an element that has nothing to do with dynamics: <visual><inertial>.
  void check_bodies_in(const FileNode& element, const std::string& what);

  using UnknownNames::note;

 private:
  bool goes_into(const FileNode&, const FileNode&) const override { return false; }
  bool says_nothing(const FileNode& element) const override;
  bool refuse_by_format(const FileNode& element, const std::string& what) override;
  bool refuse_place(const FileNode& element, const std::string& what);
  bool refuse_words_of_sdf(const FileNode& element, const std::string& what);
  bool refuse_files(const FileNode& element, const std::string& what);
  bool check_switch(const FileNode& element, const std::string& what);
  bool refuse_contents(const FileNode& element, const std::string& what);

  const UrdfValues& values_;
  bool moves_ = true;
};

// Where an element of this name is read from: "joint"; "" if no values are read from such elements.
std::string parent_of_element(std::string_view name);

}  // namespace flatdyn
