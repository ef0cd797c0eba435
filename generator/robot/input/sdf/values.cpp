// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/utf8.hpp"
#include "robot/input/common/poses.hpp"
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

std::optional<FileText> SdfValues::text(const FileNode& parent, const char* tag, const std::string& what) const {
  const FileNode* element = child(parent, tag, what);
  if (element == nullptr) return std::nullopt;
  return FileText{element->text, {element->place, what + ", " + tag}};
}

std::optional<Value> SdfValues::number(const FileNode& parent, const char* tag, const std::string& what) const {
  const std::optional<FileText> found = text(parent, tag, what);
  return found ? std::optional(value_in(*found, context_.diagnostics)) : std::nullopt;
}

std::optional<Value> SdfValues::attribute(const FileNode& element, const char* key, const std::string& what) const {
  if (!element.has(key)) return std::nullopt;
  return value_in({element.value(key), {element.place, what + ", " + key}}, context_.diagnostics);
}

bool SdfValues::flag(const FileNode& parent, const char* tag, bool otherwise, const std::string& what) const {
  const std::optional<FileText> found = text(parent, tag, what);
  return found ? flag_in(*found, context_.diagnostics).value_or(otherwise) : otherwise;
}

bool SdfValues::flag_attribute(const FileNode& element, const char* key, const std::string& what) const {
  const FileText text{element.value(key), {element.place, what + ", " + key}};
  return element.has(key) && flag_in(text, context_.diagnostics).value_or(false);
}

std::optional<Vec3> SdfValues::vector(const FileNode& element, const std::string& what) const {
  return vector_in({element.text, {element.place, what}}, context_.diagnostics);
}

std::optional<Value> SdfValues::limit(const FileNode& parent, const char* tag, Bound bound,
                                      const std::string& what) const {
  const std::optional<FileText> found = text(parent, tag, what);
  if (!found) return std::nullopt;
  const bool is_none = bound == Bound::magnitude && single_word(found->text).starts_with('-');
  const std::optional<Value> limit = limit_in(*found, is_none ? Bound::lower : bound, context_.diagnostics);
  if (!limit || !is_default_limit(limit->number)) return is_none ? std::nullopt : limit;
  if (!is_none) check_infinite_limit(single_word(found->text), bound, found->spot, context_.diagnostics);
  return std::nullopt;
}

Vec3 SdfValues::angles(const FileNumbers& pose, bool degrees) const {
  Vec3 all;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = i + kOfPosition;
    all[i] = decimal_angle(pose.numbers[k], pose.written[k], {degrees, false, false}, pose.spot, context_);
    if (degrees || !may_be_degrees(all[i])) continue;
    warn_of_degrees(all[i], pose.spot, "if so, write <pose degrees=\"true\">", context_.diagnostics);
  }
  return all;
}

Vec3 SdfValues::rpy_behind_position(const FileNumbers& pose) const {
  const std::string written = joined_words({pose.written.begin() + kOfPosition, pose.written.end()});
  return rpy_in({pose.numbers.begin() + kOfPosition, pose.numbers.end()}, {written, pose.spot}, context_,
                " behind the position")
      .value_or(zero_vector());
}

SdfPose SdfValues::pose(const FileNode& parent, const std::string& what) const {
  const FileNode* element = child(parent, "pose", what);
  if (element == nullptr) return {{}, {"", parent.place}};
  const Spot spot{element->place, what + ", pose"};
  // Versions up to 1.6 called it so.
  const bool is_older = version_ <= 6 && !element->has("relative_to");
  SdfPose pose{{}, {element->value(is_older ? "frame" : "relative_to"), spot.place}};
  if (words_of(element->text).empty()) return pose;
  const FileAttribute* format = element->attribute("rotation_format");
  const bool is_quaternion = format != nullptr && format->text == "quat_xyzw";
  if (format != nullptr && !is_quaternion && format->text != "euler_rpy") {
    context_.diagnostics.error(spot.place, fmt::format("{}: unknown rotation_format \"{}\"", spot.what, format->text),
                               "write euler_rpy or quat_xyzw");
    return pose;
  }
  const std::size_t count = is_quaternion ? kOfQuaternion : kOfEuler;
  const std::optional<FileNumbers> values =
      numbers_in({element->text, spot}, count, count, context_.diagnostics,
                 is_quaternion ? "write x y z, and the quaternion x y z w" : "write x y z roll pitch yaw");
  if (!values) return pose;
  const Vec3 xyz = as_vector(values->numbers);
  for (const Number& length : xyz) note_length(length, spot, {}, context_);
  const Vec3 rpy =
      is_quaternion ? rpy_behind_position(*values) : angles(*values, flag_attribute(*element, "degrees", spot.what));
  pose.displacements = pose_from_xyz_rpy(xyz, rpy, spot.place).displacements;
  return pose;
}

}  // namespace flatdyn
