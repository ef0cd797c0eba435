// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/declare.hpp"

#include <fmt/format.h>

#include "robot/input/sdf/files.hpp"

namespace flatdyn {

namespace {

using Kind = SdfFrame::Kind;

constexpr std::size_t kMostFrames = 20000;

}  // namespace

std::optional<SdfModel> model_of_include(const FileNode& include, const SdfValues& values,
                                         const std::vector<std::string>& stack, SdfTree& tree, Robot& robot) {
  const SdfFile* file = include_sdf(include, values, stack, tree, robot);
  if (file == nullptr) return std::nullopt;
  const std::vector<const FileNode*> models = file->root.elements("model");
  if (models.size() == 1) return SdfModel{models.front(), &file->values, &include, &values};
  values.context().diagnostics.error(
      include.place, fmt::format("include: there are {} models in {}", models.size(), file->values.file()),
      "a file that is included has one <model>, directly in <sdf>");
  return std::nullopt;
}

std::string name_of(const SdfModel& model) {
  if (model.include != nullptr) {
    if (const auto name = model.include_values->name(*model.include, "name", "include"); name && !name->name.empty()) {
      return name->name;
    }
  }
  return model.values->required_attribute(*model.element, "name", "model");
}

bool is_static(const SdfModel& model) {
  const bool own = model.values->flag(*model.element, "static", false, "model");
  return model.include == nullptr ? own : model.include_values->flag(*model.include, "static", own, "include");
}

bool SdfDeclarer::has_room(const SdfValues& values, const FileNode& element) {
  if (tree_.frames.size() < kMostFrames) return true;
  if (!is_full_) {
    values.context().diagnostics.unsupported(
        element.place, fmt::format("there are more than {} links, joints and frames", kMostFrames),
        "leave out what does not move");
  }
  is_full_ = true;
  return false;
}

void SdfDeclarer::add_name(const std::string& name, int frame, int scope, const SdfValues& values) {
  auto& names = tree_.scopes[static_cast<std::size_t>(scope_of_names(tree_, scope))].names;
  const auto [found, inserted] = names.emplace(name, frame);
  if (inserted || name.empty()) return;
  const SdfFrame& first = tree_.frames[static_cast<std::size_t>(found->second)];
  const SdfFrame& second = tree_.frames[static_cast<std::size_t>(frame)];
  // Two links or two joints of one name are found when the tree is checked.
  if (first.kind == second.kind && (first.kind == Kind::link || first.kind == Kind::joint)) return;
  if (values.version() >= 7 || second.kind == Kind::frame || second.kind == Kind::model) {
    values.context().diagnostics.error(
        second.element->place,
        fmt::format("{} has the name of {} (line {})", name_of(second), name_of(first), first.element->place.line),
        "names must differ: rename one of them");
  }
  if (second.kind == Kind::link) found->second = frame;
}

int SdfDeclarer::add_frame(Kind kind, const FileNode& element, const SdfValues& values, int scope) {
  if (!has_room(values, element)) return -1;
  const std::string name = values.required_attribute(element, "name", element.name);
  const int index = static_cast<int>(tree_.frames.size());
  const std::string& prefix = tree_.scopes[static_cast<std::size_t>(scope)].prefix;
  tree_.frames.push_back({kind, name.empty() ? name : prefix + name, &element, &values, scope});
  add_name(name, index, scope, values);
  return index;
}

void SdfDeclarer::declare_world(const FileNode* world, const SdfValues& values, const std::string& model) {
  stack_ = {values.file()};
  tree_.frames.push_back({Kind::world, "world", world, &values});
  tree_.scopes.push_back({"", -1, 0, {{"world", 0}}});
  if (world == nullptr) return;
  unknown_.check(*world, "world");
  for (const FileNode* e : world->elements("frame")) add_frame(Kind::frame, *e, values, 0);
  for (const FileNode* e : world->elements("joint")) {
    const std::optional<Reference> child = values.name(*e, "child", name_in_messages(*e));
    if (child && (child->name == model || child->name.starts_with(model + "::"))) {
      unknown_.check(*e, name_in_messages(*e));
      add_frame(Kind::joint, *e, values, 0);
    }
  }
}

void SdfDeclarer::declare_robot(const SdfModel& model) {
  if (model.values->file() != stack_.back()) stack_.push_back(model.values->file());
  declare_model(model, 0, "", false);
}

int SdfDeclarer::add_scope(const SdfModel& model, int parent, const std::string& prefix, bool merge) {
  const int scope = static_cast<int>(tree_.scopes.size());
  const bool in_static = tree_.scopes[static_cast<std::size_t>(parent)].is_static;
  tree_.scopes.push_back({prefix,
                          parent,
                          static_cast<int>(tree_.frames.size()),
                          {},
                          {},
                          merge ? parent : -1,
                          in_static || is_static(model),
                          model.include,
                          model.include_values});
  return scope;
}

void SdfDeclarer::declare_model(const SdfModel& model, int parent, const std::string& prefix, bool merge) {
  if (!has_room(*model.values, *model.element)) return;
  const std::string name = name_of(model);
  const std::string inner = parent == 0 ? "" : merge ? prefix : prefix + name + "::";
  const int scope = add_scope(model, parent, inner, merge);
  const int frame = tree_.scopes[static_cast<std::size_t>(scope)].frame;
  tree_.frames.push_back({Kind::model, prefix + name, model.element, model.values, parent, scope});
  if (!merge) {
    add_name(name, frame, parent, *model.values);
    tree_.scopes[static_cast<std::size_t>(scope_of_names(tree_, parent))].models.emplace(name, scope);
  }
  unknown_.check_model(*model.element, name_of(tree_.frames[static_cast<std::size_t>(frame)]), inner,
                       tree_.scopes[static_cast<std::size_t>(scope)].is_static);
  declare_children(model, scope);
}

void SdfDeclarer::declare_children(const SdfModel& model, int scope) {
  const SdfValues& values = *model.values;
  const std::string prefix = prefix_of(scope);
  for (const FileNode& e : model.element->children) {
    const std::string& tag = e.name;
    if (tag == "link") {
      add_frame(Kind::link, e, values, scope);
    } else if (tag == "joint") {
      add_frame(Kind::joint, e, values, scope);
    } else if (tag == "frame") {
      add_frame(Kind::frame, e, values, scope);
    } else if (tag == "model") {
      declare_model({&e, &values}, scope, prefix, false);
    } else if (tag == "include") {
      declare_include(e, values, scope);
    }
  }
}

void SdfDeclarer::declare_include(const FileNode& include, const SdfValues& values, int scope) {
  unknown_.check(include, "include");
  const std::optional<SdfModel> model = model_of_include(include, values, stack_, tree_, robot_);
  if (!model) return;
  stack_.push_back(model->values->file());
  const bool merge = values.flag_attribute(include, "merge", "include");
  declare_model(*model, scope, prefix_of(scope), merge);
  stack_.pop_back();
}

}  // namespace flatdyn
