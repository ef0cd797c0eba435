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

Spot UrdfValues::spot(const UrdfEntry& entry, const std::string& key, const std::string& what) const {
  return {entry.place, entry.form == UrdfEntry::Form::text ? what : what + ", " + key};
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

std::optional<UrdfText> UrdfValues::text(const FileNode& element, const char* key, const std::string& what) const {
  const std::optional<UrdfEntry> entry = written({&element}, key, what);
  if (!entry) return std::nullopt;
  return UrdfText{entry->text, spot(*entry, key, what)};
}

std::optional<Value> UrdfValues::number(const Holders& holders, const char* key, const std::string& what) const {
  const std::optional<UrdfEntry> entry = written(holders, key, what);
  if (!entry) return std::nullopt;
  const Spot where = spot(*entry, key, what);
  return Value{checked_decimal(single_word(entry->text), where, context_.diagnostics).value_or(0), where.place};
}

std::optional<Value> UrdfValues::number(const FileNode& element, const char* key, const std::string& what) const {
  return number(Holders{&element}, key, what);
}

std::optional<Value> UrdfValues::dynamics(const FileNode& joint, const char* key, const std::string& what) const {
  Holders holders;
  for (const char* tag : {"dynamics", "joint_properties"}) {
    if (const FileNode* element = joint.child(tag)) holders.push_back(element);
  }
  return number(holders, key, what + ", dynamics");
}

Value UrdfValues::required_number(const FileNode& element, const char* key, const std::string& what) const {
  if (const std::optional<Value> value = number(element, key, what)) return *value;
  report_missing(element, key, what);
  return {0, element.place};
}

Number UrdfValues::angle(const FileNode& element, const char* key, const std::string& what) const {
  const std::optional<UrdfEntry> entry = written({&element}, key, what);
  if (!entry) return 0;
  const Spot where = spot(*entry, key, what);
  const std::string text = single_word(entry->text);
  const std::optional<Number> value = checked_decimal(text, where, context_.diagnostics);
  return value ? angle_of(*value, text, where) : Number(0);
}

Number UrdfValues::number_of_text(const FileNode& element, const std::string& what) const {
  return checked_decimal(single_word(element.text), {element.place, what}, context_.diagnostics).value_or(0);
}

std::optional<Value> UrdfValues::limit(const FileNode& element, const char* key, Bound bound,
                                       const std::string& what) const {
  const std::optional<UrdfEntry> entry = written({&element}, key, what);
  if (!entry) return std::nullopt;
  const Spot where = spot(*entry, key, what);
  const std::string text = single_word(entry->text);
  if (is_infinite_limit(text)) {
    check_infinite_limit(text, bound, where, context_.diagnostics);
    return std::nullopt;
  }
  const std::optional<Number> value = checked_decimal(text, where, context_.diagnostics);
  if (!value) return std::nullopt;
  if (bound == Bound::magnitude && is_negative(*value)) {
    context_.diagnostics.note(where.place, where.what + ": \"" + text + "\" is taken as not given",
                              "a limit is a magnitude; leave it out where there is none",
                              "negative limits taken as not given");
    return std::nullopt;
  }
  return Value{*value, where.place};
}

template <std::size_t n>
std::optional<std::array<Number, n>> UrdfValues::numbers(const UrdfEntry& entry, const Spot& spot) const {
  const std::vector<std::string> words = words_of(entry.text);
  if (words.size() != n) {
    context_.diagnostics.error(
        spot.place,
        spot.what + ": " + (n == 3 ? "three" : "four") + " numbers are expected, not \"" + entry.text + "\"",
        std::string("separate them by blanks: ") + (n == 3 ? "\"0 0 0.5\"" : "\"0 0 0 1\", the real part last"));
    return std::nullopt;
  }
  std::array<Number, n> values;
  for (std::size_t i = 0; i < n; ++i) {
    const std::optional<Number> value = checked_decimal(words[i], spot, context_.diagnostics);
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

std::optional<Vec3> UrdfValues::vector(const UrdfEntry& entry, const Spot& spot) const {
  return numbers<3>(entry, spot);
}

std::optional<Vec3> UrdfValues::vector(const FileNode& element, const char* key, const std::string& what) const {
  const std::optional<UrdfEntry> entry = written({&element}, key, what);
  return entry ? vector(*entry, spot(*entry, key, what)) : std::nullopt;
}

std::optional<Vec3> UrdfValues::required_vector(const FileNode& element, const char* key,
                                                const std::string& what) const {
  const std::optional<UrdfEntry> entry = written({&element}, key, what);
  if (!entry) report_missing(element, key, what);
  return entry ? vector(*entry, spot(*entry, key, what)) : std::nullopt;
}

Vec3 UrdfValues::angles(const FileNode& element, const char* key, const std::string& what) const {
  const std::optional<UrdfEntry> entry = written({&element}, key, what);
  if (!entry) return zero_vector();
  const Spot where = spot(*entry, key, what);
  const std::optional<Vec3> decimals = vector(*entry, where);
  if (!decimals) return zero_vector();
  const std::vector<std::string> words = words_of(entry->text);
  Vec3 values;
  for (std::size_t i = 0; i < 3; ++i) values[i] = angle_of((*decimals)[i], words[i], where);
  return values;
}

Vec3 UrdfValues::turn(const FileNode& element, const std::string& what) const {
  const Vec3 rpy = angles(element, "rpy", what);
  const std::optional<UrdfEntry> entry = written({&element}, "quat_xyzw", what);
  if (!entry) return rpy;
  const Spot where = spot(*entry, "quat_xyzw", what);
  const std::optional<Quaternion> q = numbers<4>(*entry, where);
  if (!q || !check_length(*q, where)) return rpy;
  if (written({&element}, "rpy", what)) {
    if (!is_rotation(*q, rpy)) {
      context_.diagnostics.error(where.place, where.what + " and rpy are not the same rotation",
                                 "keep the one that is right");
    }
    return rpy;
  }
  // A pitch that is so near to a quarter turn is snapped to it.
  const bool snaps = !context_.options.snap_tolerance.is_zero();
  const Vec3 angles = rpy_of(*q, snaps ? exact_decimal("1e-12") : Number(0));
  Vec3 snapped;
  for (std::size_t i = 0; i < 3; ++i) snapped[i] = snapped_angle(angles[i], entry->text, where, context_);
  return snapped;
}

// Files have units to as many digits as are printed; what is much longer or shorter is no rotation that is meant.
bool UrdfValues::check_length(const std::array<Number, 4>& quaternion, const Spot& spot) const {
  const GiNaC::numeric off = magnitude(squared_norm(quaternion) - 1);
  if (off <= magnitude(exact_decimal("1e-2"))) return true;
  context_.diagnostics.error(spot.place, spot.what + " is not a unit quaternion",
                             "write x y z w with a sum of squares of 1: 0 0 0 1 turns nothing");
  return false;
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
  if (written({element}, "quat_wxyz", where)) {
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
