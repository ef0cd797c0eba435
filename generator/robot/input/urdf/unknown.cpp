// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/unknown.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/unread.hpp"

namespace flatdyn {

namespace {

using EntryForm = UrdfEntry::Form;
using Names = std::vector<std::string>;

bool is_among(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string list_of(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

bool is_si_unit(std::string_view unit) {
  constexpr auto kUnits = std::to_array<std::string_view>(
      {"m", "meter", "meters", "rad", "radian", "radians", "kg", "kg m^2", "kg*m^2", "N", "Nm", "N m", "SI", "si"});
  return std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end();
}

std::string called(const UrdfEntry& entry) {
  return entry.form == EntryForm::child ? "element <" + entry.name + ">" : "attribute \"" + entry.name + "\"";
}

std::string shown(const UrdfEntry& entry) {
  return entry.form == EntryForm::child ? "<" + entry.name + ">" : entry.name + "=\"" + entry.text + "\"";
}

}  // namespace

// The known keys of an element, and those that are not there.
struct UnknownEntries::Known {
  Known(const UrdfElement& known, const std::vector<UrdfEntry>& entries)
      : element(known), missing(key_names_of(known)) {
    for (const UrdfEntry& entry : entries) std::erase(missing, key_of(known, entry));
  }

  // "did you mean ..." if the name is like one that is missing, the list of names if it may be meant for one; else "".
  std::string hint_for(const std::string& name) const {
    const std::string near = hint_for_unknown(name, missing, "attributes");
    if (near.starts_with("did you mean")) return near;
    for (const std::string& key : missing) {
      if (name.find(key) != std::string::npos || (name.size() > 2 && key.find(name) != std::string::npos)) {
        return "did you mean \"" + key + "\"?";
      }
    }
    const bool may_be_meant = missing.size() == element.keys.size() ||
                              std::any_of(missing.begin(), missing.end(),
                                          [&](const std::string& key) { return is_among(element.decisive, key); });
    return may_be_meant ? "known attributes: " + list_of(key_names_of(element)) : "";
  }

  const UrdfElement& element;
  Names missing;
};

// True if the entry is an error.
bool UnknownEntries::refuse(const FileNode& element, const UrdfEntry& entry, const Known& known,
                            const std::string& what) {
  if ((entry.name == "unit" || entry.name == "units") && !is_si_unit(entry.text)) {
    diagnostics_.error(entry.place, what + ": the unit \"" + entry.text + "\" is not read",
                       "convert the value to SI units (m, rad, kg, s, N), and delete the unit");
    return true;
  }
  if (const std::string meant = known_spelling_of(entry.name, key_names_of(known.element)); !meant.empty()) {
    diagnostics_.error(entry.place, what + ": unknown " + called(entry), "did you mean \"" + meant + "\"?");
    return true;
  }
  if (const std::string home = parent_of_element(entry.name); entry.form == EntryForm::child && !home.empty()) {
    diagnostics_.error(entry.place, what + ": <" + entry.name + "> has no effect here",
                       "it is read from <" + home + ">: write it there, or delete it");
    return true;
  }
  const std::string home = element_of_value(entry.name);
  if (!home.empty() && home != element.name && !is_zero_text(entry.text)) {
    diagnostics_.error(entry.place, what + ": " + shown(entry) + " has no effect here",
                       "it is read from <" + home + ">: write it there, or delete it");
    return true;
  }
  const bool is_rotor = has_key(known.element, "armature") && is_rotor_name(entry.name) && !is_zero_text(entry.text);
  const std::string hint =
      is_rotor ? "write armature, which is gear_ratio^2 * rotor_inertia" : known.hint_for(entry.name);
  if (hint.empty()) return false;
  diagnostics_.error(entry.place, what + ": unknown " + called(entry), hint);
  return true;
}

void UnknownEntries::note_left_out(const FileNode& element, const Names& names, const std::string& what) {
  Names first;
  for (const std::string& name : names) {
    if (noted_.insert(element.name + " " + name).second) first.push_back(name);
  }
  if (first.empty()) return;
  diagnostics_.note(element.place, what + ": left out here and in every <" + element.name + ">: " + list_of(first),
                    "what is read: " + list_of(key_names_of(*known_urdf_element(element.name))),
                    "unknown attributes left out");
}

void UnknownEntries::check(const FileNode& element, const std::string& what) {
  const UrdfElement* element_known = known_urdf_element(element.name);
  if (element_known == nullptr) return;
  const std::vector<UrdfEntry> entries = entries_of(element);
  const Known known(*element_known, entries);
  Names left_out;
  for (const UrdfEntry& entry : entries) {
    if (!key_of(known.element, entry).empty()) continue;
    const bool is_meant = !known_spelling_of(entry.name, key_names_of(known.element)).empty();
    if (has_namespace(entry.name) && !is_meant) continue;
    if (entry.form == EntryForm::text) {
      diagnostics_.error(element.place,
                         what + ": it is not clear what the text \"" + entry.text + "\" in <" + element.name + "> is",
                         "write it as attributes: " + list_of(key_names_of(known.element)));
    } else if (is_among(known.element.of_others, entry.name) || !refuse(element, entry, known, what)) {
      left_out.push_back(entry.name);
    }
  }
  note_left_out(element, left_out, what);
}

void UnknownEntries::check_misplaced(const FileNode& holder, const std::string& what) {
  for (const FileAttribute& a : holder.attributes) {
    const UrdfEntry entry{a.name, a.text, holder.place, EntryForm::attribute};
    const std::string home = element_of_value(entry.name);
    const bool is_element = known_urdf_element(entry.name) != nullptr;
    if ((home.empty() && !is_element) || has_namespace(entry.name) || is_zero_text(entry.text)) continue;
    diagnostics_.error(holder.place, what + ": " + shown(entry) + " has no effect here",
                       is_element ? "write an element: <" + entry.name + " .../>"
                                  : "it is read from <" + home + ">: write it there, or delete it");
  }
}

}  // namespace flatdyn
