// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/keyframe.hpp"

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

namespace {

std::vector<const FileNode*> keys_of(const FileNode& root) {
  std::vector<const FileNode*> keys;
  for (const FileNode* section : root.elements("keyframe")) {
    for (const FileNode* key : section->elements("key")) keys.push_back(key);
  }
  return keys;
}

// The key of this name; nullptr, and an error, if there is none.
const FileNode* find_key(const std::string& name, const MjcfModel& model) {
  std::vector<std::string> known;
  for (const FileNode* key : keys_of(model.root)) {
    if (key->value("name") == name) return key;
    if (!key->value("name").empty()) known.push_back(key->value("name"));
  }
  model.diagnostics().error(
      {}, "--keyframe: there is no keyframe \"" + name + "\"",
      known.empty() ? "the file has none with a name" : hint_for_unknown(name, known, "keyframes"));
  return nullptr;
}

std::size_t position_count(const MjcfModel& model) {
  std::size_t count = 0;
  for (const MjcfBody& body : model.bodies) {
    for (const int each : body.position_counts) count += static_cast<std::size_t>(each);
  }
  return count;
}

void take_positions(const FileNumbers& positions, const MjcfModel& model) {
  std::size_t next = 0;
  for (const MjcfBody& body : model.bodies) {
    for (std::size_t k = 0; k < body.position_counts.size(); ++k) {
      const Joint& joint = model.robot.joints[static_cast<std::size_t>(body.joints[k])];
      const bool moves =
          joint.type != JointType::fixed && !joint.coupled && !is_held(joint.name, model.values.context());
      if (moves && body.position_counts[k] == 1) {
        JointPosition position;
        position.joint = joint.name;
        position.position = positions.numbers[next];
        position.place = positions.spot.place;
        model.robot.assembly.push_back(position);
      }
      next += static_cast<std::size_t>(body.position_counts[k]);
    }
  }
}

// The positions of an attached model; other joints are where `ref` puts them.
void take_positions_by_joint(const FileNode& key, const MjcfModel& model) {
  for (const Joint& joint : model.robot.joints) {
    if (joint.type == JointType::fixed || joint.coupled || is_held(joint.name, model.values.context())) continue;
    const auto reference = model.reference.find(joint.name);
    JointPosition position;
    position.joint = joint.name;
    position.place = key.place;
    position.position = reference == model.reference.end() ? Number(0) : reference->second;
    for (const FileNode& written : key.children) {
      if (written.value("name") == joint.name)
        position.position = model.values.number_or(MjcfValues::plain(written), "qpos", 0).number;
    }
    model.robot.assembly.push_back(position);
  }
}

}  // namespace

void read_mjcf_keyframe(const MjcfModel& model) {
  const std::optional<std::string>& name = model.values.context().options.keyframe;
  if (!name) return;
  const FileNode* key = find_key(*name, model);
  if (key == nullptr) return;
  if (model.robot.loops.empty()) {
    model.diagnostics().note({}, "--keyframe " + *name + " has no effect: the robot has no closed loops",
                             "its positions are those near which loops are closed");
    return;
  }
  if (!key->children.empty()) return take_positions_by_joint(*key, model);
  if (key->attribute("qpos") == nullptr) {
    model.diagnostics().error(key->place, name_in_messages(*key) + " has no qpos", "write the positions of all joints");
    return;
  }
  const std::size_t count = position_count(model);
  const auto positions = model.values.numbers(MjcfValues::plain(*key), "qpos", count, count);
  if (positions) take_positions(*positions, model);
}

}  // namespace flatdyn
