// SPDX-License-Identifier: GPL-2.0-or-later
// The state that the readers of an MJCF file's sections share.
#pragma once

#include <map>

#include "robot/input/common/robot_builder.hpp"
#include "robot/input/mjcf/orientation.hpp"

namespace flatdyn {

struct MjcfSite {
  int link = -1;
  Pose pose;  // in the link's frame
};

// The geoms of a body, whose inertia is computed once all bodies are known.
struct MjcfGeom {
  const FileNode* element = nullptr;
  std::string class_name;
  Pose frame;  // of the <frame> that holds it, in the body's frame
};

struct MjcfBody {
  const FileNode* element = nullptr;
  int link = -1;
  int parent = -1;          // index of a body; -1: the world
  Pose pose;                // in the parent body's frame, with all joints at their ref
  std::vector<int> joints;  // indices of the robot's joints that move it against its parent
  bool moves = false;       // against the world
  std::vector<MjcfGeom> geoms;
  std::optional<Inertial> inertial;
  std::vector<int> free_joints = {};      // indices of the robot's joints that are free ones
  std::vector<int> position_counts = {};  // of its `joints` in MuJoCo's q: 7 of a free one, 4 of a ball
};

// The length of a tendon as a joint that is not in the robot yet: a fixed one follows the joints that it runs over.
struct MjcfTendon {
  Joint length;
  std::string what;  // tendon "split"
  bool is_fixed = false;
};

struct MjcfModel {
  const FileNode& root;
  const MjcfValues& values;
  const MjcfSettings& settings;
  Robot& robot;
  RobotBuilder builder;
  std::vector<MjcfBody> bodies = {};  // depth first, without the world
  std::map<std::string, int> body_of_name = {};
  std::map<std::string, MjcfSite> sites = {};
  std::map<std::string, Number> reference = {};   // ref of a joint, rad or m
  std::map<std::string, Number> relaxed = {};     // springref of a joint, rad or m
  std::vector<MjcfTendon> tendons = {};           // in file order
  std::vector<std::string> names_of_joints = {};  // of all elements
  std::vector<std::string> names_of_bodies = {};

  Diagnostics& diagnostics() const { return values.diagnostics(); }
};

// The name, or one like it that is not yet taken.
std::string unused_name(const std::string& wanted, const std::vector<std::string>& taken);

// A name for a link that has none in the file.
std::string new_body_name(const std::string& wanted, const MjcfModel& model);

// An error for a name that nothing has.
void report_missing_name(const FileAttribute& attribute, const std::string& what, const std::string& kind,
                         const std::vector<std::string>& known, Diagnostics& diagnostics);

std::vector<std::string> joint_names(const Robot& robot);
std::vector<std::string> body_names(const MjcfModel& model);

}  // namespace flatdyn
