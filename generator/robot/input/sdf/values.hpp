// SPDX-License-Identifier: GPL-2.0-or-later
// Values of SDF elements, each with its line. A value is the text of an element: <mass>2</mass>. A child that is there
// twice in different ways is an error: it is not clear which one counts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/input/common/file_node.hpp"
#include "robot/input/common/values.hpp"
#include "robot/model/pose_product.hpp"

namespace flatdyn {

// A pose as written, and the frame that it names; an empty name: the default of the element.
struct SdfPose {
  Displacements displacements;
  Reference relative_to;
};

class SdfValues {
 public:
  // version: the minor number, 7 of "1.7".
  SdfValues(std::string file, int version, ReadContext& context)
      : file_(std::move(file)), version_(version), context_(context) {}

  const std::string& file() const { return file_; }
  int version() const { return version_; }
  ReadContext& context() const { return context_; }

  // The child of this name, nullptr if there is none.
  const FileNode* child(const FileNode& parent, const char* tag, const std::string& what) const;

  // The attribute, "" and an error if it is missing, empty or not UTF-8.
  std::string required_attribute(const FileNode& element, const char* key, const std::string& what) const;

  // The text of a child without the blanks around it, as a name; nullopt if there is no such child.
  std::optional<Reference> name(const FileNode& parent, const char* tag, const std::string& what) const;

  // The number that is the text of a child; nullopt if it is not there, 0 and an error if it is no number.
  std::optional<Value> number(const FileNode& parent, const char* tag, const std::string& what) const;

  // The number of an attribute.
  std::optional<Value> attribute(const FileNode& element, const char* key, const std::string& what) const;

  // true, 1, false or 0, in any letters; `otherwise` where there is nothing, and with an error for other words.
  bool flag(const FileNode& parent, const char* tag, bool otherwise, const std::string& what) const;
  bool flag_attribute(const FileNode& element, const char* key, const std::string& what) const;

  // The three numbers of an element; nullopt and an error if it has others.
  std::optional<Vec3> vector(const FileNode& element, const std::string& what) const;

  // A limit: infinite, 1e16 as SDF's defaults, or a negative magnitude, means none.
  std::optional<Value> limit(const FileNode& parent, const char* tag, Bound bound, const std::string& what) const;

  // The pose of an element by its <pose>, by default none: x y z, then Rz(yaw) Ry(pitch) Rx(roll) or a quaternion.
  SdfPose pose(const FileNode& parent, const std::string& what) const;

 private:
  std::optional<FileText> text(const FileNode& parent, const char* tag, const std::string& what) const;
  Vec3 angles(const FileNumbers& pose, bool degrees) const;
  Vec3 rpy_behind_position(const FileNumbers& pose) const;

  std::string file_;
  int version_;
  ReadContext& context_;
};

}  // namespace flatdyn
