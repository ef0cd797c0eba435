// SPDX-License-Identifier: GPL-2.0-or-later
// Elements, attributes and texts of a file that its format's rows do not have: errors where they may be meant for one
// that is read, refused where by their names they change how the robot moves, else noted once for each name. Formats
// whose programs refuse every unknown name do so here, too.
#pragma once

#include <set>
#include <string>

#include "robot/input/common/file_node.hpp"
#include "robot/input/common/schema.hpp"

namespace flatdyn {

// The format in messages.
struct FormatWords {
  std::string name;                  // "SDF"
  std::string page;                  // "docs/robot-format/sdf.md"
  bool is_strict = false;            // every unknown name is an error
  bool is_strict_of_prefix = false;  // <x:joint> may be meant for <joint>
};

class UnknownNames {
 public:
  UnknownNames(const Schema& schema, FormatWords format, Diagnostics& diagnostics)
      : schema_(schema), format_(std::move(format)), diagnostics_(diagnostics) {}
  virtual ~UnknownNames() = default;

  // The element, called `what` in messages, and those in it that are read and have rows.
  void check(const FileNode& element, const std::string& what, const std::string& holder = {});
  const Schema& schema() const { return schema_; }

 protected:
  // Whether what is in the element is read, too.
  virtual bool goes_into(const FileNode& element, const FileNode& holder) const;
  // The name of an element in messages, in one that is called `holder`.
  virtual std::string name_in(const std::string& holder, const FileNode& element) const;
  // True if the format says something of its own of an unknown element that is not misspelt.
  virtual bool refuse_by_format(const FileNode& element, const std::string& what);
  // Whether an unknown element says nothing but its name, or zeros.
  virtual bool says_nothing(const FileNode& element) const;
  bool is_refused_by_name(const FileNode& element) const;
  // True, and an error, if an element may be meant for one that is read.
  bool refuse_spelling(const FileNode& element, const std::string& what, const SchemaNames& names);
  void note(const FileNode& element, const std::string& what);

  Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  void check_attributes(const FileNode& element, const std::string& what, const SchemaNames& names);
  void check_child(const FileNode& child, const std::string& what, const SchemaNames& names);
  void check_text(const FileNode& element, const std::string& what);
  std::string hint_for(const std::string& name, const SchemaNames& names, bool is_element) const;

  const Schema& schema_;
  FormatWords format_;
  Diagnostics& diagnostics_;
  std::set<std::string> noted_;  // once for each name
};

}  // namespace flatdyn
