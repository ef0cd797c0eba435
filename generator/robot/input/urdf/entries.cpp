// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/entries.hpp"

#include <algorithm>
#include <map>

#include "robot/input/common/words.hpp"

namespace flatdyn {

namespace {

using EntryForm = UrdfEntry::Form;

const std::vector<UrdfKey> kOfDynamics = {{"damping", ""},          {"friction", ""},  {"armature", ""},
                                          {"spring_stiffness", ""}, {"stiffness", ""}, {"spring_reference", ""}};
const std::vector<std::string> kOfFranka = {"D", "K", "mu_coulomb", "mu_viscous"};
const UrdfElement kOneValue = {{{"value", ""}}, {"value"}, "value", true, {}};  // <motorInertia>0.02</motorInertia>
const UrdfElement kDrakesValue = {{{"value", ""}}, {"value"}, "value", false, {}};
const UrdfElement kMimic = {
    {{"joint", ""}, {"multiplier", ""}, {"offset", ""}}, {"joint", "multiplier", "offset"}, "", false, {}};

const std::map<std::string_view, UrdfElement> kElements = {
    {"origin", {{{"xyz", ""}, {"rpy", ""}, {"quat_xyzw", ""}, {"quat_wxyz", ""}}, {"xyz", "rpy"}, "", false, {}}},
    {"axis", {{{"xyz", ""}}, {"xyz"}, "xyz", false, {}}},
    {"parent", {{{"link", ""}}, {"link"}, "link", false, {}}},
    {"child", {{{"link", ""}}, {"link"}, "link", false, {}}},
    {"mass", {{{"value", ""}}, {"value"}, "value", false, {}}},
    {"inertia",
     {{{"ixx", ""}, {"iyy", ""}, {"izz", ""}, {"ixy", "iyx"}, {"ixz", "izx"}, {"iyz", "izy"}},
      {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"},
      "",
      false,
      {}}},
    {"mimic", kMimic},
    {"drake:mimic", kMimic},
    {"limit",
     {{{"lower", "min"}, {"upper", "max"}, {"velocity", ""}, {"effort", ""}, {"acceleration", "drake:acceleration"}},
      {},
      "",
      false,
      {"deceleration", "jerk"}}},
    {"dynamics", {kOfDynamics, {}, "", false, kOfFranka}},
    {"joint_properties", {kOfDynamics, {}, "", false, kOfFranka}},
    {"drake:rotor_inertia", kDrakesValue},
    {"drake:gear_ratio", kDrakesValue},
    {"rotor_inertia", kOneValue},
    {"motorInertia", kOneValue},
    {"gear_ratio", kOneValue},
    {"mechanicalReduction", kOneValue},
    {"mechanical_reduction", kOneValue},
    {"reduction", kOneValue},
};

}  // namespace

const UrdfElement* known_urdf_element(std::string_view tag) {
  const auto found = kElements.find(tag);
  return found == kElements.end() ? nullptr : &found->second;
}

std::string element_of_value(std::string_view name) {
  for (const char* tag : {"origin", "inertia", "dynamics", "limit"}) {
    if (has_key(*known_urdf_element(tag), name)) return tag;
  }
  return "";
}

std::vector<std::string> key_names_of(const UrdfElement& element) {
  std::vector<std::string> names;
  for (const UrdfKey& key : element.keys) names.push_back(key.name);
  return names;
}

bool has_key(const UrdfElement& element, std::string_view name) {
  return std::any_of(element.keys.begin(), element.keys.end(), [&](const UrdfKey& key) { return key.name == name; });
}

std::string key_of(const UrdfElement& element, const UrdfEntry& entry) {
  if (entry.form == EntryForm::text) return element.key_of_text;
  for (const UrdfKey& key : element.keys) {
    if (entry.name == key.name || entry.name == key.other_name) return key.name;
  }
  return "";
}

std::vector<UrdfEntry> entries_of(const FileNode& element) {
  std::vector<UrdfEntry> entries;
  for (const FileAttribute& a : element.attributes) {
    entries.push_back({a.name, a.text, element.place, EntryForm::attribute});
  }
  if (known_urdf_element(element.name) == nullptr) return entries;
  for (const FileNode& e : element.children) entries.push_back({e.name, value_of(e), e.place, EntryForm::child});
  if (!words_of(element.text).empty()) entries.push_back({"", element.text, element.place, EntryForm::text});
  return entries;
}

}  // namespace flatdyn
