// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/values.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/common/words.hpp"

namespace flatdyn {

MjcfItem MjcfValues::item(const FileNode& element, const std::string& class_name, const std::string& section) const {
  MjcfItem found{&element, default_kind_of(element.name, section), class_name, name_in_messages(element)};
  const FileAttribute* own = element.attribute("class");
  if (own == nullptr) return found;
  if (defaults_.has_class(own->text)) {
    found.class_name = own->text;
  } else {
    diagnostics().error(own->place, found.what + ": there is no class \"" + own->text + "\" of defaults",
                        hint_for_unknown(own->text, defaults_.names(), "classes"));
  }
  return found;
}

MjcfItem MjcfValues::plain(const FileNode& element) { return {&element, "", "", name_in_messages(element)}; }

const FileAttribute* MjcfValues::find(const MjcfItem& item, const char* name) const {
  if (const FileAttribute* own = item.element->attribute(name)) return own;
  return item.class_name.empty() ? nullptr : defaults_.find(item.class_name, item.kind, name);
}

Spot MjcfValues::spot(const MjcfItem& item, const FileAttribute& attribute) const {
  return {attribute.place, item.what + ", " + attribute.name};
}

std::string MjcfValues::text(const MjcfItem& item, const char* name, const std::string& fallback) const {
  const FileAttribute* found = find(item, name);
  return found == nullptr ? fallback : found->text;
}

std::string MjcfValues::keyword(const MjcfItem& item, const char* name, const std::vector<std::string>& words,
                                const std::string& fallback) const {
  const FileAttribute* found = find(item, name);
  if (found == nullptr) return fallback;
  if (std::find(words.begin(), words.end(), found->text) != words.end()) return found->text;
  diagnostics().error(found->place, item.what + ": unknown " + name + " \"" + found->text + "\"",
                      hint_for_unknown(found->text, words, "words"));
  return fallback;
}

bool MjcfValues::flag(const MjcfItem& item, const char* name, bool fallback) const {
  return keyword(item, name, {"true", "false"}, fallback ? "true" : "false") == "true";
}

std::optional<FileNumbers> MjcfValues::numbers(const MjcfItem& item, const char* name, std::size_t least,
                                               std::size_t most) const {
  const FileAttribute* found = find(item, name);
  return found == nullptr ? std::nullopt : numbers_in({found->text, spot(item, *found)}, least, most, diagnostics());
}

std::optional<Value> MjcfValues::number(const MjcfItem& item, const char* name) const {
  const std::optional<FileNumbers> found = numbers(item, name, 1, 1);
  if (!found) return std::nullopt;
  return Value{found->numbers[0], found->spot.place};
}

Value MjcfValues::number_or(const MjcfItem& item, const char* name, const Number& fallback) const {
  return number(item, name).value_or(Value{fallback, item.element->place});
}

Vec3 MjcfValues::vector(const MjcfItem& item, const char* name, const Vec3& fallback) const {
  const std::optional<FileNumbers> found = numbers(item, name, 3, 3);
  return found ? as_vector(found->numbers) : fallback;
}

Vec3 MjcfValues::length_vector(const MjcfItem& item, const char* name) const {
  const std::optional<FileNumbers> found = numbers(item, name, 3, 3);
  if (!found) return zero_vector();
  for (const Number& length : found->numbers) note_length(length, found->spot, {}, context_);
  return as_vector(found->numbers);
}

std::optional<std::array<std::optional<Value>, 2>> MjcfValues::range(const MjcfItem& item, const char* name) const {
  const FileAttribute* found = find(item, name);
  if (found == nullptr) return std::nullopt;
  const Spot where = spot(item, *found);
  const std::vector<std::string> words = words_of(found->text);
  if (words.size() != 2) {
    numbers_in({found->text, where}, 2, 2, diagnostics(), "write the lower and the upper limit");
    return std::nullopt;
  }
  return std::array{limit_in({words[0], where}, Bound::lower, diagnostics()),
                    limit_in({words[1], where}, Bound::upper, diagnostics())};
}

}  // namespace flatdyn
