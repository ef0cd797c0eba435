// SPDX-License-Identifier: GPL-2.0-or-later
// Values of URDF elements, each with its line. URDF has decimals only: no expressions, no symbols. A value is that of
// an attribute, or stands in another place of the element where it can mean nothing else, and that is noted; where it
// is given twice it must be the same.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "robot/input/common/values.hpp"
#include "robot/input/urdf/entries.hpp"

namespace flatdyn {

class UrdfValues {
 public:
  // The outermost element.
  UrdfValues(const FileNode& root, ReadContext& context);

  const FileNode& root() const { return root_; }
  // Whether the element stands directly in one that is called so.
  bool is_in(const FileNode& element, std::string_view holder) const;
  // Whether values of URDF's elements may be meant where the element stands: in a link, its <inertial>, or a joint.
  bool holds_values(const FileNode& element) const;

  // The value's text, "" and an error if it is missing or empty; an error if it is not UTF-8.
  std::string required_text(const FileNode& element, const char* key, const std::string& what) const;

  // The value's text as written, and where; nullopt if it is not there.
  std::optional<FileText> text(const FileNode& element, const char* key, const std::string& what) const;

  // The number; nullopt if it is not there, 0 and an error if it is no number.
  std::optional<Value> number(const FileNode& element, const char* key, const std::string& what) const;
  // The same, an error if it is not there.
  Value required_number(const FileNode& element, const char* key, const std::string& what) const;

  // The angle of a decimal: snapped, and asked about where it may be in degrees.
  Number angle_of(const Number& decimal, const std::string& written, const Spot& spot) const;

  // The number of a joint's <dynamics>, or of its <joint_properties>, which older files have.
  std::optional<Value> dynamics(const FileNode& joint, const char* key, const std::string& what) const;

  // A limit: infinite means none. So does a negative magnitude, which is noted.
  std::optional<Value> limit(const FileNode& element, const char* key, Bound bound, const std::string& what) const;

  // Three numbers; nullopt if they are not there, or an error.
  std::optional<Vec3> vector(const FileNode& element, const char* key, const std::string& what) const;
  // The same, and an error if they are not there.
  std::optional<Vec3> required_vector(const FileNode& element, const char* key, const std::string& what) const;

  // <origin xyz rpy> or <origin xyz quat_xyzw> of an element that may have one: xyz, then Rz(yaw) Ry(pitch) Rx(roll).
  // tag: what else it is called.
  Pose origin(const FileNode& parent, const std::string& what, const std::string& tag = "origin") const;

  ReadContext& context() const { return context_; }

 private:
  using Holders = std::vector<const FileNode*>;

  void add_holders(const FileNode& holder);
  bool is_refused_by_names(const FileNode& element, const UrdfElement& known) const;
  // The value of a key, wherever in the elements it stands; nullopt if it stands nowhere.
  std::optional<UrdfEntry> written(const Holders& holders, const std::string& key, const std::string& what) const;
  void note_unusual(const FileNode& holder, const UrdfEntry& entry, const std::string& key,
                    const std::string& what) const;
  void report_missing(const FileNode& element, const char* key, const std::string& what) const;
  std::optional<FileText> text(const Holders& holders, const char* key, const std::string& what) const;
  // By rpy, or by quat_xyzw: roll, pitch, yaw.
  Vec3 turn(const FileNode& element, const std::string& what) const;
  Vec3 angles(const FileNode& element, const char* key, const std::string& what) const;

  const FileNode& root_;
  std::unordered_map<const FileNode*, const FileNode*> holders_;  // of all elements but the root
  ReadContext& context_;
};

}  // namespace flatdyn
