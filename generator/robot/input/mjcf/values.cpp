// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/values.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/common/words.hpp"

namespace flatdyn {

namespace {

std::string count_text(std::size_t least, std::size_t most) {
  const std::string count = std::to_string(least);
  return least == most ? count + (most == 1 ? " number is" : " numbers are")
                       : count + " to " + std::to_string(most) + " numbers are";
}

}  // namespace

Vec3 as_vector(const std::vector<Number>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

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

std::optional<MjcfValues::Numbers> MjcfValues::numbers(const MjcfItem& item, const char* name, std::size_t least,
                                                       std::size_t most) const {
  const FileAttribute* found = find(item, name);
  if (found == nullptr) return std::nullopt;
  Numbers values{{}, words_of(found->text), spot(item, *found)};
  if (values.written.size() < least || values.written.size() > most) {
    diagnostics().error(found->place,
                        values.spot.what + ": " + count_text(least, most) + " expected, not \"" + found->text + "\"",
                        "separate them by blanks");
    return std::nullopt;
  }
  for (const std::string& word : values.written) {
    const std::optional<Number> value = checked_decimal(word, values.spot, diagnostics());
    if (!value) return std::nullopt;
    values.numbers.push_back(*value);
  }
  return values;
}

std::optional<Value> MjcfValues::number(const MjcfItem& item, const char* name) const {
  const std::optional<Numbers> found = numbers(item, name, 1, 1);
  if (!found) return std::nullopt;
  return Value{found->numbers[0], found->spot.place};
}

Value MjcfValues::number_or(const MjcfItem& item, const char* name, const Number& fallback) const {
  return number(item, name).value_or(Value{fallback, item.element->place});
}

Vec3 MjcfValues::vector(const MjcfItem& item, const char* name, const Vec3& fallback) const {
  const std::optional<Numbers> found = numbers(item, name, 3, 3);
  return found ? as_vector(found->numbers) : fallback;
}

Vec3 MjcfValues::length_vector(const MjcfItem& item, const char* name) const {
  const std::optional<Numbers> found = numbers(item, name, 3, 3);
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
    diagnostics().error(found->place, where.what + ": 2 numbers are expected, not \"" + found->text + "\"",
                        "separate them by blanks");
    return std::nullopt;
  }
  std::array<std::optional<Value>, 2> limits;
  for (std::size_t i = 0; i < 2; ++i) {
    if (is_infinite_limit(words[i])) {
      check_infinite_limit(words[i], i == 0 ? Bound::lower : Bound::upper, where, diagnostics());
    } else if (const auto value = checked_decimal(words[i], where, diagnostics())) {
      limits[i] = Value{*value, where.place};
    }
  }
  return limits;
}

}  // namespace flatdyn
