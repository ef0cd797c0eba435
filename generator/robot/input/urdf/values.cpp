// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/values.hpp"

#include <algorithm>
#include <array>

#include "base/diagnostics/utf8.hpp"
#include "robot/input/common/poses.hpp"
#include "robot/input/common/quaternion.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/common/words.hpp"
#include "robot/model/exact_sign.hpp"
#include "robot/model/unit_plausibility.hpp"

namespace flatdyn {

namespace {

// Where URDF writes the value of a key.
bool is_usual(const FileNode& holder, const UrdfEntry& entry, const std::string& key) {
  const UrdfElement* known = known_urdf_element(holder.name);
  if (known == nullptr || has_namespace(entry.name)) return true;
  if (holder.name == "joint_properties") return false;
  return entry.form == UrdfEntry::Form::text ? known->text_is_usual
                                             : entry.form == UrdfEntry::Form::attribute && entry.name == key;
}

std::string words_for_place(const FileNode& holder, const UrdfEntry& entry) {
  const std::string tag = "<" + holder.name + ">";
  if (entry.form == UrdfEntry::Form::text) return "the text of " + tag;
  if (entry.form == UrdfEntry::Form::child) return "<" + entry.name + "> in " + tag;
  return "\"" + entry.name + "\" of " + tag;
}

}  // namespace

UrdfValues::UrdfValues(const FileNode& root, ReadContext& context) : root_(root), context_(context) {
  add_holders(root);
}

void UrdfValues::add_holders(const FileNode& holder) {
  for (const FileNode& child : holder.children) {
    holders_[&child] = &holder;
    add_holders(child);
  }
}

bool UrdfValues::is_in(const FileNode& element, std::string_view holder) const {
  const auto found = holders_.find(&element);
  return found != holders_.end() && found->second->name == holder;
}

bool UrdfValues::holds_values(const FileNode& element) const {
  return is_in(element, "link") || is_in(element, "inertial") ||
         (is_in(element, "joint") && is_in(*holders_.at(&element), "robot"));
}

// Whether the check of names has an error for something in the element that may be meant for what is missing.
bool UrdfValues::is_refused_by_names(const FileNode& element, const UrdfElement& known) const {
  if (!holds_values(element)) return false;
  const std::vector<UrdfEntry> entries = entries_of(element);
  return std::any_of(entries.begin(), entries.end(), [&](const UrdfEntry& entry) {
    return key_of(known, entry).empty() && !has_namespace(entry.name);
  });
}

std::optional<UrdfEntry> UrdfValues::written(const Holders& holders, const std::string& key,
                                             const std::string& what) const {
  std::optional<UrdfEntry> found;
  const FileNode* holder_of_found = nullptr;
  for (const FileNode* holder : holders) {
    const UrdfElement* known = known_urdf_element(holder->name);
    for (const UrdfEntry& entry : entries_of(*holder)) {
      if ((known == nullptr ? entry.name : key_of(*known, entry)) != key) continue;
      if (found && !are_equivalent_texts(found->text, entry.text)) {
        context_.diagnostics.error(entry.place,
                                   what + ": " + key + " is given twice, as \"" + found->text + "\" in " +
                                       words_for_place(*holder_of_found, *found) + " and as \"" + entry.text +
                                       "\" in " + words_for_place(*holder, entry),
                                   "keep the one that is right");
      }
      if (found && (is_usual(*holder_of_found, *found, key) || !is_usual(*holder, entry, key))) continue;
      found = entry;
      holder_of_found = holder;
    }
  }
  if (found && !is_usual(*holder_of_found, *found, key)) note_unusual(*holder_of_found, *found, key, what);
  return found;
}

void UrdfValues::note_unusual(const FileNode& holder, const UrdfEntry& entry, const std::string& key,
                              const std::string& what) const {
  const std::string tag = holder.name == "joint_properties" ? "dynamics" : holder.name;
  context_.diagnostics.note(entry.place, what + ": " + key + " is read from " + words_for_place(holder, entry),
                            "URDF has it as <" + tag + " " + key + "=\"...\"/>", "values read from unusual places");
}

void UrdfValues::report_missing(const FileNode& element, const char* key, const std::string& what) const {
  const std::string tag = element.name;
  const UrdfElement* known = known_urdf_element(tag);
  if (known != nullptr && is_refused_by_names(element, *known)) return;
  if (known != nullptr && known->text_is_usual) {
    context_.diagnostics.error(element.place, what + ": <" + tag + "> is empty",
                               "write <" + tag + ">...</" + tag + ">");
  } else {
    context_.diagnostics.error(element.place, what + ": <" + tag + "> has no attribute \"" + key + "\"",
                               "write <" + tag + " " + key + "=\"...\">");
  }
}

std::string UrdfValues::required_text(const FileNode& element, const char* key, const std::string& what) const {
  const std::optional<UrdfEntry> entry = written({&element}, key, what);
  if (!entry || entry->text.empty()) {
    report_missing(element, key, what);
    return "";
  }
  if (!is_utf8(entry->text)) {
    context_.diagnostics.error(element.place, what + ": " + key + " is not UTF-8",
                               "save the file as UTF-8 (iconv -t UTF-8), or write the name in ASCII");
  }
  return entry->form == UrdfEntry::Form::attribute ? entry->text : single_word(entry->text);
}

std::optional<FileText> UrdfValues::text(const Holders& holders, const char* key, const std::string& what) const {
  const std::optional<UrdfEntry> entry = written(holders, key, what);
  if (!entry) return std::nullopt;
  return FileText{entry->text, {entry->place, entry->form == UrdfEntry::Form::text ? what : what + ", " + key}};
}

std::optional<FileText> UrdfValues::text(const FileNode& element, const char* key, const std::string& what) const {
  return text(Holders{&element}, key, what);
}

std::optional<Value> UrdfValues::number(const FileNode& element, const char* key, const std::string& what) const {
  const std::optional<FileText> found = text(element, key, what);
  return found ? std::optional(value_in(*found, context_.diagnostics)) : std::nullopt;
}

std::optional<Value> UrdfValues::dynamics(const FileNode& joint, const char* key, const std::string& what) const {
  Holders holders;
  for (const char* tag : {"dynamics", "joint_properties"}) {
    if (const FileNode* element = joint.child(tag)) holders.push_back(element);
  }
  const std::optional<FileText> found = text(holders, key, what + ", dynamics");
  return found ? std::optional(value_in(*found, context_.diagnostics)) : std::nullopt;
}

Value UrdfValues::required_number(const FileNode& element, const char* key, const std::string& what) const {
  if (const std::optional<Value> value = number(element, key, what)) return *value;
  report_missing(element, key, what);
  return {0, element.place};
}

std::optional<Value> UrdfValues::limit(const FileNode& element, const char* key, Bound bound,
                                       const std::string& what) const {
  const std::optional<FileText> found = text(element, key, what);
  const std::optional<Value> limit = found ? limit_in(*found, bound, context_.diagnostics) : std::nullopt;
  if (!limit || bound != Bound::magnitude || !is_negative(limit->number)) return limit;
  context_.diagnostics.note(
      found->spot.place, found->spot.what + ": \"" + single_word(found->text) + "\" is taken as not given",
      "a limit is a magnitude; leave it out where there is none", "negative limits taken as not given");
  return std::nullopt;
}

std::optional<Vec3> UrdfValues::vector(const FileNode& element, const char* key, const std::string& what) const {
  const std::optional<FileText> found = text(element, key, what);
  return found ? vector_in(*found, context_.diagnostics) : std::nullopt;
}

std::optional<Vec3> UrdfValues::required_vector(const FileNode& element, const char* key,
                                                const std::string& what) const {
  const std::optional<FileText> found = text(element, key, what);
  if (!found) report_missing(element, key, what);
  return found ? vector_in(*found, context_.diagnostics) : std::nullopt;
}

Vec3 UrdfValues::angles(const FileNode& element, const char* key, const std::string& what) const {
  const std::optional<FileText> found = text(element, key, what);
  const auto decimals = found ? numbers_in(*found, 3, 3, context_.diagnostics) : std::nullopt;
  if (!decimals) return zero_vector();
  Vec3 values;
  for (std::size_t i = 0; i < 3; ++i) values[i] = angle_of(decimals->numbers[i], decimals->written[i], found->spot);
  return values;
}

Vec3 UrdfValues::turn(const FileNode& element, const std::string& what) const {
  const Vec3 rpy = angles(element, "rpy", what);
  const std::optional<FileText> found = text(element, "quat_xyzw", what);
  const auto xyzw =
      found ? numbers_in(*found, 4, 4, context_.diagnostics, "separate them by blanks: \"0 0 0 1\", the real part last")
            : std::nullopt;
  if (!xyzw) return rpy;
  if (!text(element, "rpy", what)) return rpy_in(xyzw->numbers, *found, context_).value_or(rpy);
  const Quaternion q = {xyzw->numbers[0], xyzw->numbers[1], xyzw->numbers[2], xyzw->numbers[3]};
  if (!is_rotation(q, rpy)) {
    context_.diagnostics.error(found->spot.place, found->spot.what + " and rpy are not the same rotation",
                               "keep the one that is right");
  }
  return rpy;
}

Number UrdfValues::angle_of(const Number& decimal, const std::string& written, const Spot& spot) const {
  const Number angle = snapped_angle(decimal, written, spot, context_);
  if (may_be_degrees(angle)) {
    const std::string hint = "if so, write " + radians_text(decimal, AngleText::decimal) + ": URDF has radians";
    warn_of_degrees(angle, spot, hint, context_.diagnostics);
  }
  return angle;
}

Pose UrdfValues::origin(const FileNode& parent, const std::string& what, const std::string& tag) const {
  const FileNode* element = parent.child(tag);
  if (element == nullptr) return {{}, parent.place};
  const std::string where = what + ", " + tag;
  if (text(*element, "quat_wxyz", where)) {
    context_.diagnostics.unsupported(element->place, where + ": quat_wxyz is not supported",
                                     "write quat_xyzw, with the real part last, or rpy");
  }
  // One after the other: compilers differ in the order in which they evaluate arguments, and diagnostics would with
  // them.
  const Vec3 xyz = vector(*element, "xyz", where).value_or(zero_vector());
  for (const Number& length : xyz) note_length(length, {element->place, where + ", xyz"}, {}, context_);
  const Vec3 rpy = turn(*element, where);
  return pose_from_xyz_rpy(xyz, rpy, element->place);
}

}  // namespace flatdyn
