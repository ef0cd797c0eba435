// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/placing.hpp"

#include <algorithm>

namespace flatdyn {

namespace {

using Kind = SdfFrame::Kind;

class Placer {
 public:
  Placer(Diagnostics& diagnostics, SdfTree& tree) : diagnostics_(diagnostics), tree_(tree) {}

  bool place() {
    const std::size_t before = diagnostics_.all().size();
    for (std::size_t i = 1; i < tree_.frames.size(); ++i) attach(tree_.frames[i]);
    for (std::size_t i = 1; i < tree_.frames.size(); ++i) place(tree_.frames[i]);
    if (!all_end(&SdfFrame::attached_to, "what they are attached to") ||
        !all_end(&SdfFrame::relative_to, "what their poses are relative to")) {
      return false;
    }
    // Models in models come behind them: their poses are final first.
    for (std::size_t i = tree_.frames.size(); i-- > 1;) {
      if (tree_.frames[i].kind == Kind::model) place_by_frame(static_cast<int>(i));
    }
    const auto is_error = [](const Diagnostic& each) { return each.severity == Severity::error; };
    return std::none_of(diagnostics_.all().begin() + static_cast<std::ptrdiff_t>(before), diagnostics_.all().end(),
                        is_error);
  }

 private:
  const SdfScope& scope_of(const SdfFrame& frame) const { return tree_.scopes[static_cast<std::size_t>(frame.scope)]; }

  const SdfScope& own_scope(const SdfFrame& model) const {
    return tree_.scopes[static_cast<std::size_t>(model.own_scope)];
  }

  // The frame that is named in a scope, `otherwise` for an empty name, or one that is not there.
  int named_frame(const Reference& name, int scope, int otherwise, const std::string& what) {
    if (name.name.empty()) return otherwise;
    const int found = find_sdf_frame(tree_, scope, name, what, diagnostics_);
    return found < 0 ? otherwise : found;
  }

  int named_frame(const SdfFrame& frame, const char* attribute, int scope, int otherwise) {
    const Reference reference{frame.element->value(attribute), frame.element->place};
    return named_frame(reference, scope, otherwise, name_of(frame) + ", " + attribute);
  }

  void attach(SdfFrame& frame) {
    if (frame.kind == Kind::frame) {
      frame.attached_to = named_frame(frame, "attached_to", frame.scope, scope_of(frame).frame);
    } else if (frame.kind == Kind::joint) {
      frame.attached_to = std::max(frame_of_joint(tree_, frame, "child", diagnostics_), 0);
    } else if (frame.kind == Kind::model) {
      frame.attached_to = own_scope(frame).is_static ? 0 : canonical_link(frame);
    }
  }

  int canonical_link(const SdfFrame& model) {
    return named_frame(model, "canonical_link", model.own_scope, first_link_in(model.own_scope));
  }

  // Its own first link, else that of the first model in it; -1 if there is none.
  int first_link_in(int scope) const {
    for (const bool nested : {false, true}) {
      for (std::size_t i = 0; i < tree_.frames.size(); ++i) {
        const SdfFrame& frame = tree_.frames[i];
        const bool is_own = frame.scope == scope || scope_of_names(tree_, frame.scope) == scope;
        if (frame.kind == Kind::link && (is_own || (nested && is_within(frame.scope, scope)))) {
          return static_cast<int>(i);
        }
      }
    }
    return -1;
  }

  bool is_within(int scope, int outer) const {
    while (scope >= 0 && scope != outer) scope = tree_.scopes[static_cast<std::size_t>(scope)].parent;
    return scope == outer;
  }

  void place(SdfFrame& frame) {
    const bool is_model = frame.kind == Kind::model;
    const FileNode* holder = frame.element;
    const SdfValues* values = frame.values;
    if (is_model && own_scope(frame).include != nullptr && own_scope(frame).include->child("pose") != nullptr) {
      holder = own_scope(frame).include;
      values = own_scope(frame).include_values;
    }
    const SdfPose pose = values->pose(*holder, name_of(frame));
    const bool moves_with = frame.kind == Kind::frame || frame.kind == Kind::joint;
    const int otherwise = moves_with ? frame.attached_to : scope_of(frame).frame;
    frame.relative_to = named_frame(pose.relative_to, frame.scope, otherwise, name_of(frame) + ", pose, relative_to");
    frame.pose = pose.displacements;
  }

  // The pose of a model is that of its placement frame.
  void place_by_frame(int index) {
    SdfFrame& model = tree_.frames[static_cast<std::size_t>(index)];
    const SdfScope& scope = own_scope(model);
    int frame = named_frame(model, "placement_frame", model.own_scope, index);
    if (scope.include != nullptr) {
      if (const auto name = scope.include_values->name(*scope.include, "placement_frame", "include")) {
        frame = named_frame(*name, model.own_scope, index, "include, placement_frame");
      }
    }
    if (frame != index) model.pose = product(model.pose, inverse(relative_pose(tree_, index, frame)));
  }

  bool all_end(int SdfFrame::*next, const char* what) {
    std::vector<int> seen(tree_.frames.size(), -1);  // from which frame a walk came by
    for (int start = 0; start < static_cast<int>(tree_.frames.size()); ++start) {
      for (int i = start; i >= 0; i = tree_.frames[static_cast<std::size_t>(i)].*next) {
        int& from = seen[static_cast<std::size_t>(i)];
        if (from == start) return report_circle(i, what);
        if (from >= 0) break;
        from = start;
      }
    }
    return true;
  }

  bool report_circle(int index, const char* what) {
    const SdfFrame& frame = tree_.frames[static_cast<std::size_t>(index)];
    diagnostics_.error(frame.element->place, name_of(frame) + ": frames go round by " + what + ", and so are nowhere",
                       "let one of them be relative to __model__");
    return false;
  }

  Diagnostics& diagnostics_;
  SdfTree& tree_;
};

}  // namespace

int frame_of_joint(const SdfTree& tree, const SdfFrame& joint, const char* tag, Diagnostics& diagnostics) {
  const std::string what = name_of(joint);
  const std::optional<Reference> name = joint.values->name(*joint.element, tag, what);
  if (!name) {
    diagnostics.error(joint.element->place, what + " has no <" + tag + ">",
                      std::string("write <") + tag + ">LINK</" + tag + ">");
    return -1;
  }
  if (name->name.empty()) return -1;
  if (name->name == "world" && std::string_view(tag) == "parent") return 0;
  return find_sdf_frame(tree, joint.scope, *name, what + ", " + tag, diagnostics);
}

bool place_sdf_frames(Diagnostics& diagnostics, SdfTree& tree) { return Placer(diagnostics, tree).place(); }

}  // namespace flatdyn
