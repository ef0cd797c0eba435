// SPDX-License-Identifier: GPL-2.0-or-later
// The frames of an SDF model and of those nested in it: links, joints, models and <frame>s, each with its pose in
// another one, and the link that it moves with.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/input/sdf/values.hpp"

namespace flatdyn {

struct SdfFile {
  FileNode root;
  SdfValues values;
};

struct SdfFrame {
  enum class Kind { world, model, link, joint, frame };

  Kind kind = Kind::frame;
  std::string name;  // with those of its models: "arm::hand::palm"
  const FileNode* element = nullptr;
  const SdfValues* values = nullptr;
  int scope = 0;            // where names that it mentions are looked up; of a model, that around it
  int own_scope = -1;       // of a model
  int relative_to = -1;     // -1: none, as of the world
  Displacements pose = {};  // in that frame
  int attached_to = -1;     // the frame that it moves with; -1 of links and the world
};

// A model, or the world: names are unique in it.
struct SdfScope {
  std::string prefix;                      // "arm::"
  int parent = -1;                         // index of the scope
  int frame = -1;                          // its own frame, __model__
  std::map<std::string, int> names = {};   // frames
  std::map<std::string, int> models = {};  // scopes
  int merged_into = -1;                    // the scope that has its names, of <include merge="true">
  bool is_static = false;
  const FileNode* include = nullptr;  // by which the model comes into another file
  const SdfValues* include_values = nullptr;
};

struct SdfTree {
  std::vector<std::unique_ptr<SdfFile>> files;
  std::vector<SdfFrame> frames;  // in the order of the file; the first one is the world
  std::vector<SdfScope> scopes;  // the first one is the world
};

// The frame of this name, as seen in a scope; -1 and an error if there is none. `what` says who refers to it.
int find_sdf_frame(const SdfTree& tree, int scope, const Reference& name, const std::string& what,
                   Diagnostics& diagnostics);

// The scope that has the names of this one.
int scope_of_names(const SdfTree& tree, int scope);

// The index of the link that a frame moves with, or of the world; -1 if attachments go round, which was reported.
int body_of(const SdfTree& tree, int frame);

// The pose of frame `b` in frame `a`.
Displacements relative_pose(const SdfTree& tree, int a, int b);

// "link \"arm::hand\"".
std::string name_of(const SdfFrame& frame);

}  // namespace flatdyn
