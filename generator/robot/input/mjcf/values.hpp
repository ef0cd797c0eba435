// SPDX-License-Identifier: GPL-2.0-or-later
// Values of MJCF elements, each with its place: an element's own, or those of its class of defaults.
#pragma once

#include "robot/input/common/values.hpp"
#include "robot/input/mjcf/defaults.hpp"

namespace flatdyn {

// An element under its class, and its name in messages.
struct MjcfItem {
  const FileNode* element = nullptr;
  std::string kind;        // of defaults: "joint"
  std::string class_name;  // "" if it has no defaults
  std::string what;        // joint "elbow"
};

class MjcfValues {
 public:
  MjcfValues(const MjcfDefaults& defaults, ReadContext& context) : defaults_(defaults), context_(context) {}

  // The element with its own class, or else with this one. section: see default_kind_of().
  MjcfItem item(const FileNode& element, const std::string& class_name = kMainClass,
                const std::string& section = "") const;
  // An element that has no defaults.
  static MjcfItem plain(const FileNode& element);

  // nullptr if neither the element nor its class has it.
  const FileAttribute* find(const MjcfItem& item, const char* name) const;
  bool is_own(const MjcfItem& item, const char* name) const { return item.element->attribute(name) != nullptr; }

  std::string text(const MjcfItem& item, const char* name, const std::string& fallback = "") const;
  // One of these words; an error, and the fallback, if it is another one.
  std::string keyword(const MjcfItem& item, const char* name, const std::vector<std::string>& words,
                      const std::string& fallback) const;
  bool flag(const MjcfItem& item, const char* name, bool fallback) const;  // true or false

  std::optional<Value> number(const MjcfItem& item, const char* name) const;
  Value number_or(const MjcfItem& item, const char* name, const Number& fallback) const;
  // As many numbers as this, with their texts; nullopt, and perhaps an error, if they are not there.
  std::optional<FileNumbers> numbers(const MjcfItem& item, const char* name, std::size_t least, std::size_t most) const;
  Vec3 vector(const MjcfItem& item, const char* name, const Vec3& fallback) const;
  Vec3 length_vector(const MjcfItem& item, const char* name) const;  // m; asked about where it is long

  // Two limits, infinite ones left out. nullopt if they are not there.
  std::optional<std::array<std::optional<Value>, 2>> range(const MjcfItem& item, const char* name) const;

  Spot spot(const MjcfItem& item, const FileAttribute& attribute) const;
  ReadContext& context() const { return context_; }
  Diagnostics& diagnostics() const { return context_.diagnostics; }
  const MjcfDefaults& defaults() const { return defaults_; }

 private:
  const MjcfDefaults& defaults_;
  ReadContext& context_;
};

}  // namespace flatdyn
