// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/tree.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

namespace {

const SdfFrame& frame_at(const SdfTree& tree, int index) { return tree.frames[static_cast<std::size_t>(index)]; }

const SdfScope& scope_at(const SdfTree& tree, int index) { return tree.scopes[static_cast<std::size_t>(index)]; }

// A name is looked up as it is first: before 1.8, names could have "::" in them.
int lookup(const SdfTree& tree, int scope, const std::string& name) {
  if (name == "__model__") return scope_at(tree, scope).frame;
  const SdfScope& names = scope_at(tree, scope_of_names(tree, scope));
  if (const auto found = names.names.find(name); found != names.names.end()) return found->second;
  for (std::size_t k = name.find("::"); k != std::string::npos; k = name.find("::", k + 1)) {
    const auto model = names.models.find(name.substr(0, k));
    if (model == names.models.end()) continue;
    if (const int found = lookup(tree, model->second, name.substr(k + 2)); found >= 0) return found;
  }
  return -1;
}

// Frames from this one to the outermost.
std::vector<int> frames_above(const SdfTree& tree, int frame) {
  std::vector<int> all;
  for (; frame >= 0; frame = frame_at(tree, frame).relative_to) all.push_back(frame);
  return all;
}

}  // namespace

int scope_of_names(const SdfTree& tree, int scope) {
  while (scope_at(tree, scope).merged_into >= 0) scope = scope_at(tree, scope).merged_into;
  return scope;
}

int find_sdf_frame(const SdfTree& tree, int scope, const Reference& name, const std::string& what,
                   Diagnostics& diagnostics) {
  if (const int found = lookup(tree, scope, name.name); found >= 0) return found;
  std::vector<std::string> known;
  for (const auto& [each, frame] : scope_at(tree, scope_of_names(tree, scope)).names) known.push_back(each);
  diagnostics.error(name.place, what + ": there is no frame \"" + name.name + "\"",
                    hint_for_unknown(name.name, known, "frames"));
  return -1;
}

int body_of(const SdfTree& tree, int frame) {
  while (frame >= 0 && frame_at(tree, frame).attached_to >= 0) frame = frame_at(tree, frame).attached_to;
  return frame;
}

Displacements relative_pose(const SdfTree& tree, int a, int b) {
  std::vector<int> above_a = frames_above(tree, a), above_b = frames_above(tree, b);
  while (!above_a.empty() && !above_b.empty() && above_a.back() == above_b.back()) {
    above_a.pop_back();
    above_b.pop_back();
  }
  Displacements way;
  for (const int each : above_a) way = product(way, inverse(frame_at(tree, each).pose));
  std::reverse(above_b.begin(), above_b.end());
  for (const int each : above_b) way = product(way, frame_at(tree, each).pose);
  return way;
}

std::string name_of(const SdfFrame& frame) {
  static const std::map<SdfFrame::Kind, const char*> kWords = {{SdfFrame::Kind::world, "world"},
                                                               {SdfFrame::Kind::model, "model"},
                                                               {SdfFrame::Kind::link, "link"},
                                                               {SdfFrame::Kind::joint, "joint"},
                                                               {SdfFrame::Kind::frame, "frame"}};
  return std::string(kWords.at(frame.kind)) + " \"" + frame.name + "\"";
}

}  // namespace flatdyn
