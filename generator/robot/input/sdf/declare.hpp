// SPDX-License-Identifier: GPL-2.0-or-later
// SDF elements → the tree of frames, before poses are read: models, and in them links, joints, frames, nested models
// and included ones.
#pragma once

#include "robot/input/sdf/tree.hpp"
#include "robot/input/sdf/unknown.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// A model, and the <include> by which it comes into another file, if any: it can replace name, pose and whether the
// model is static.
struct SdfModel {
  const FileNode* element = nullptr;
  const SdfValues* values = nullptr;
  const FileNode* include = nullptr;
  const SdfValues* include_values = nullptr;
};

// The only model of a file; nullopt and an error if there is none, or several.
std::optional<SdfModel> model_of_include(const FileNode& include, const SdfValues& values,
                                         const std::vector<std::string>& stack, SdfTree& tree, Robot& robot);

// As the include calls it, or as it is called itself.
std::string name_of(const SdfModel& model);
bool is_static(const SdfModel& model);

class SdfDeclarer {
 public:
  SdfDeclarer(SdfTree& tree, SdfUnknown& unknown, Robot& robot) : tree_(tree), unknown_(unknown), robot_(robot) {}

  // The world, with its frames, and with those joints whose child is in the model. nullptr: a model without a world.
  void declare_world(const FileNode* world, const SdfValues& values, const std::string& model);

  // The model that the robot is made of: names in it have no prefix.
  void declare_robot(const SdfModel& model);

 private:
  void declare_model(const SdfModel& model, int parent, const std::string& prefix, bool merge);
  void declare_children(const SdfModel& model, int scope);
  void declare_include(const FileNode& include, const SdfValues& values, int scope);
  // A copy, as scopes are added while it is in use.
  std::string prefix_of(int scope) const { return tree_.scopes[static_cast<std::size_t>(scope)].prefix; }
  int add_scope(const SdfModel& model, int parent, const std::string& prefix, bool merge);
  int add_frame(SdfFrame::Kind kind, const FileNode& element, const SdfValues& values, int scope);
  void add_name(const std::string& name, int frame, int scope, const SdfValues& values);
  bool has_room(const SdfValues& values, const FileNode& element);

  SdfTree& tree_;
  SdfUnknown& unknown_;
  Robot& robot_;
  std::vector<std::string> stack_;  // files that are being read
  bool is_full_ = false;
};

}  // namespace flatdyn
