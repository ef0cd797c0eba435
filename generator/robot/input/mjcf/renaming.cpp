// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/renaming.hpp"

namespace flatdyn {

namespace {

void add_names(const FileNode& element, MjcfNames& names) {
  for (const FileNode& child : element.children) {
    const std::string name = child.value("name");
    if (!name.empty()) names[child.name == "freejoint" ? "joint" : child.name].insert(name);
    add_names(child, names);
  }
}

void count_references(const FileNode& element, const MjcfNames& names, MjcfReferences& found) {
  for (const FileAttribute& attribute : element.attributes) {
    const std::string kind = mjcf_reference_kind(attribute.name);
    if (kind.empty()) continue;
    const auto known = names.find(kind);
    const bool is_inside = known != names.end() && known->second.count(attribute.text) > 0;
    ++(is_inside ? found.inside : found.outside);
  }
  for (const FileNode& child : element.children) count_references(child, names, found);
}

}  // namespace

MjcfNames mjcf_names_in(const FileNode& element) {
  MjcfNames names;
  add_names(element, names);
  return names;
}

std::string mjcf_reference_kind(const std::string& attribute) {
  static const std::map<std::string, std::string> kKinds = {
      {"joint", "joint"},   {"jointinparent", "joint"}, {"joint1", "joint"},   {"joint2", "joint"},  {"site", "site"},
      {"refsite", "site"},  {"slidersite", "site"},     {"cranksite", "site"}, {"sidesite", "site"}, {"site1", "site"},
      {"site2", "site"},    {"body", "body"},           {"body1", "body"},     {"body2", "body"},    {"geom", "geom"},
      {"tendon", "tendon"}, {"tendon1", "tendon"},      {"tendon2", "tendon"}};
  const auto found = kKinds.find(attribute);
  return found == kKinds.end() ? "" : found->second;
}

MjcfReferences mjcf_references(const FileNode& element, const MjcfNames& names) {
  MjcfReferences found;
  count_references(element, names, found);
  return found;
}

void rename_mjcf(FileNode& element, const MjcfRenaming& renaming, bool references) {
  for (FileAttribute& attribute : element.attributes) {
    const std::string kind = mjcf_reference_kind(attribute.name);
    const bool is_reference = references && !kind.empty() && !(kind == "body" && attribute.text == "world");
    if (attribute.name == "name" || is_reference) attribute.text = renaming(attribute.text);
  }
  for (FileNode& child : element.children) rename_mjcf(child, renaming, references);
}

}  // namespace flatdyn
