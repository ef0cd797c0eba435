// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/utf8.hpp"
#include "robot/input/common/poses.hpp"
#include "robot/input/common/quaternion.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/common/words.hpp"
#include "robot/model/exact_sign.hpp"
#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {

namespace {

constexpr std::size_t kOfPosition = 3, kOfEuler = 6, kOfQuaternion = 7;

bool says_the_same(const FileNode& a, const FileNode& b) {
  const auto is_text = [](const FileNode& e) { return e.children.empty() && e.attributes.empty(); };
  return is_text(a) && is_text(b) && are_equivalent_texts(a.text, b.text);
}

// SDF's default for a position without a limit.
bool is_default_limit(const Number& limit) {
  static const Number kDefault = exact_decimal("1e16");
  return !is_below(absolute(limit), kDefault);
}

}  // namespace

const FileNode* SdfValues::child(const FileNode& parent, const char* tag, const std::string& what) const {
  const std::vector<const FileNode*> all = parent.elements(tag);
  if (all.empty()) return nullptr;
  const FileNode* first = all.front();
  for (const FileNode* second : all) {
    if (second == first || says_the_same(*first, *second)) continue;
    context_.diagnostics.error(
        second->place, fmt::format("{}: <{}> is there twice (the first is in line {})", what, tag, first->place.line),
        "delete one of them");
    break;
  }
  return first;
}

std::string SdfValues::required_attribute(const FileNode& element, const char* key, const std::string& what) const {
  const std::string text = element.value(key);
  if (text.empty()) {
    context_.diagnostics.error(element.place, fmt::format("{} has no {}", what, key),
                               fmt::format("write <{} {}=\"...\">", element.name, key));
    return "";
  }
  if (is_utf8(text)) return text;
  context_.diagnostics.error(element.place, fmt::format("{}: the {} is not UTF-8", what, key),
                             "save the file as UTF-8");
  return "";
}

std::optional<Reference> SdfValues::name(const FileNode& parent, const char* tag, const std::string& what) const {
  const FileNode* element = child(parent, tag, what);
  if (element == nullptr) return std::nullopt;
  // Before 1.3 the name was an attribute; a text is all that counts since.
  const std::string text = joined_words(words_of(element->text));
  if (text.empty()) {
    context_.diagnostics.error(element->place, fmt::format("{}: <{}> is empty", what, tag),
                               fmt::format("write <{}>NAME</{}>", tag, tag));
  }
  return Reference{text, element->place};
}

std::optional<Value> SdfValues::number(const FileNode& parent, const char* tag, const std::string& what) const {
  const FileNode* element = child(parent, tag, what);
  if (element == nullptr) return std::nullopt;
  const Spot spot{element->place, what + ", " + tag};
  return Value{checked_decimal(single_word(element->text), spot, context_.diagnostics).value_or(0), spot.place};
}

std::optional<Value> SdfValues::attribute(const FileNode& element, const char* key, const std::string& what) const {
  const FileAttribute* found = element.attribute(key);
  if (found == nullptr) return std::nullopt;
  const Spot spot{element.place, what + ", " + key};
  return Value{checked_decimal(single_word(found->text), spot, context_.diagnostics).value_or(0), spot.place};
}

bool SdfValues::is_true(const std::string& text, bool otherwise, const Spot& spot) const {
  std::string small = single_word(text);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
  if (small == "true" || small == "1") return true;
  if (small == "false" || small == "0") return false;
  context_.diagnostics.error(spot.place, fmt::format("{}: \"{}\" is neither true nor false", spot.what, text),
                             "write true or false");
  return otherwise;
}

bool SdfValues::flag(const FileNode& parent, const char* tag, bool otherwise, const std::string& what) const {
  const FileNode* element = child(parent, tag, what);
  return element == nullptr ? otherwise : is_true(element->text, otherwise, {element->place, what + ", " + tag});
}

bool SdfValues::flag_attribute(const FileNode& element, const char* key, const std::string& what) const {
  const FileAttribute* found = element.attribute(key);
  return found != nullptr && is_true(found->text, false, {element.place, what + ", " + key});
}

std::optional<std::vector<Number>> SdfValues::numbers(const std::vector<std::string>& words, const Spot& spot) const {
  std::vector<Number> all;
  for (const std::string& word : words) {
    const std::optional<Number> number = checked_decimal(word, spot, context_.diagnostics);
    if (!number) return std::nullopt;
    all.push_back(*number);
  }
  return all;
}

std::optional<Vec3> SdfValues::vector(const FileNode& element, const std::string& what) const {
  const std::vector<std::string> words = words_of(element.text);
  const Spot spot{element.place, what};
  if (words.size() != kOfPosition) {
    context_.diagnostics.error(spot.place,
                               fmt::format("{}: three numbers are expected, not \"{}\"", what, joined_words(words)),
                               "separate them by blanks: 0 0 1");
    return std::nullopt;
  }
  const std::optional<std::vector<Number>> values = numbers(words, spot);
  if (!values) return std::nullopt;
  return Vec3{(*values)[0], (*values)[1], (*values)[2]};
}

std::optional<Value> SdfValues::limit(const FileNode& parent, const char* tag, Bound bound,
                                      const std::string& what) const {
  const FileNode* element = child(parent, tag, what);
  if (element == nullptr) return std::nullopt;
  const std::string text = single_word(element->text);
  const Spot spot{element->place, what + ", " + tag};
  const bool is_none = bound == Bound::magnitude && text.starts_with('-');
  if (!is_infinite_limit(text)) {
    const std::optional<Number> value = checked_decimal(text, spot, context_.diagnostics);
    if (!value || is_none) return std::nullopt;
    if (!is_default_limit(*value)) return Value{*value, spot.place};
  }
  if (!is_none) check_infinite_limit(text, bound, spot, context_.diagnostics);
  return std::nullopt;
}

Vec3 SdfValues::angles(const std::vector<std::string>& words, const std::vector<Number>& numbers, bool degrees,
                       const Spot& spot) const {
  Vec3 all;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string& written = words[i + kOfPosition];
    all[i] = decimal_angle(numbers[i + kOfPosition], written, {degrees, false, false}, spot, context_);
    if (degrees || !may_be_degrees(all[i])) continue;
    warn_of_degrees(all[i], spot, "if so, write <pose degrees=\"true\">", context_.diagnostics);
  }
  return all;
}

Vec3 SdfValues::angles_of_quaternion(const std::vector<std::string>& words, const std::vector<Number>& numbers,
                                     const Spot& spot) const {
  const Quaternion q = {numbers[3], numbers[4], numbers[5], numbers[6]};
  if (magnitude(squared_norm(q) - 1) > magnitude(exact_decimal("1e-2"))) {
    context_.diagnostics.error(spot.place, spot.what + ": this is not a unit quaternion",
                               "write x y z w with a sum of squares of 1 behind the position: 0 0 0 1 turns nothing");
    return zero_vector();
  }
  // A pitch that is so near to a quarter turn is snapped to it.
  const bool snaps = !context_.options.snap_tolerance.is_zero();
  Vec3 rpy = rpy_of(q, snaps ? exact_decimal("1e-12") : Number(0));
  const std::string written = joined_words({words.begin() + kOfPosition, words.end()});
  for (Number& angle : rpy) angle = snapped_angle(angle, written, spot, context_);
  return rpy;
}

SdfPose SdfValues::pose(const FileNode& parent, const std::string& what) const {
  const FileNode* element = child(parent, "pose", what);
  if (element == nullptr) return {{}, {"", parent.place}};
  const Spot spot{element->place, what + ", pose"};
  // Versions up to 1.6 called it so.
  const bool is_older = version_ <= 6 && !element->has("relative_to");
  SdfPose pose{{}, {element->value(is_older ? "frame" : "relative_to"), spot.place}};
  const std::vector<std::string> words = words_of(element->text);
  if (words.empty()) return pose;
  const FileAttribute* format = element->attribute("rotation_format");
  const bool is_quaternion = format != nullptr && format->text == "quat_xyzw";
  if (format != nullptr && !is_quaternion && format->text != "euler_rpy") {
    context_.diagnostics.error(spot.place, fmt::format("{}: unknown rotation_format \"{}\"", spot.what, format->text),
                               "write euler_rpy or quat_xyzw");
    return pose;
  }
  const std::size_t expected = is_quaternion ? kOfQuaternion : kOfEuler;
  if (words.size() != expected) {
    context_.diagnostics.error(
        spot.place, fmt::format("{}: {} numbers are expected, not \"{}\"", spot.what, expected, joined_words(words)),
        is_quaternion ? "write x y z, and the quaternion x y z w" : "write x y z roll pitch yaw");
    return pose;
  }
  const std::optional<std::vector<Number>> values = numbers(words, spot);
  if (!values) return pose;
  const Vec3 xyz = {(*values)[0], (*values)[1], (*values)[2]};
  for (const Number& length : xyz) note_length(length, spot, {}, context_);
  const Vec3 rpy = is_quaternion ? angles_of_quaternion(words, *values, spot)
                                 : angles(words, *values, flag_attribute(*element, "degrees", spot.what), spot);
  pose.displacements = pose_from_xyz_rpy(xyz, rpy, spot.place).displacements;
  return pose;
}

}  // namespace flatdyn
