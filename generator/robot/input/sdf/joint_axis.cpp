// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/joint_axis.hpp"

#include "robot/input/common/exchanged_limits.hpp"

namespace flatdyn {

namespace {

class AxisReader {
 public:
  AxisReader(const SdfTree& tree, const SdfFrame& frame, ReadContext& context, Joint& joint)
      : tree_(tree),
        frame_(frame),
        values_(*frame.values),
        context_(context),
        joint_(joint),
        what_("joint \"" + joint.name + "\"") {}

  void read(const FileNode& axis) {
    read_direction(axis);
    const bool is_held = joint_.type == JointType::fixed;
    if (const FileNode* limit = values_.child(axis, "limit", what_)) read_limits(*limit);
    if (is_held) return;
    if (const FileNode* dynamics = values_.child(axis, "dynamics", what_)) read_dynamics(*dynamics);
    if (const FileNode* mimic = values_.child(axis, "mimic", what_)) read_mimic(*mimic);
  }

 private:
  void read_direction(const FileNode& axis) {
    const FileNode* xyz = values_.child(axis, "xyz", what_ + ", axis");
    if (xyz == nullptr) {
      context_.diagnostics.error(axis.place, what_ + ", axis: it has no <xyz>", "write <xyz>0 0 1</xyz>");
      return;
    }
    joint_.axis = values_.vector(*xyz, what_ + ", axis, xyz").value_or(joint_.axis);
  }

  void read_limits(const FileNode& limit) {
    const std::string what = what_ + ", limit";
    const JointType motion = joint_.held ? joint_.held->type : joint_.type;
    if (motion != JointType::continuous) {
      joint_.limits.lower = values_.limit(limit, "lower", Bound::lower, what);
      joint_.limits.upper = values_.limit(limit, "upper", Bound::upper, what);
    }
    remove_exchanged_limits(joint_, context_.diagnostics);
    joint_.limits.velocity = values_.limit(limit, "velocity", Bound::magnitude, what);
    joint_.limits.effort = values_.limit(limit, "effort", Bound::magnitude, what);
    joint_.limits.acceleration = values_.limit(limit, "drake:acceleration", Bound::magnitude, what);
  }

  void read_dynamics(const FileNode& dynamics) {
    const std::string what = what_ + ", dynamics";
    if (const auto damping = values_.number(dynamics, "damping", what)) joint_.viscous = *damping;
    if (const auto friction = values_.number(dynamics, "friction", what)) joint_.coulomb = *friction;
    if (const auto stiffness = values_.number(dynamics, "spring_stiffness", what)) joint_.stiffness = *stiffness;
    if (const auto reference = values_.number(dynamics, "spring_reference", what)) joint_.spring_reference = *reference;
  }

  // The position is multiplier · (that of the leader - reference) + offset.
  void read_mimic(const FileNode& mimic) {
    const std::string what = what_ + ", mimic";
    const Reference name{values_.required_attribute(mimic, "joint", what), mimic.place};
    if (name.name.empty()) return;
    const int leader = find_sdf_frame(tree_, frame_.scope, name, what, context_.diagnostics);
    if (leader < 0) return;
    const SdfFrame& other = tree_.frames[static_cast<std::size_t>(leader)];
    if (other.kind != SdfFrame::Kind::joint) {
      context_.diagnostics.error(name.place, what + ": " + name_of(other) + " is no joint", "name a joint");
      return;
    }
    const std::string followed = name_of_axis(other, mimic.has("axis") ? mimic.value("axis") : "axis");
    const auto number = [&](const char* tag, const Number& otherwise) {
      const std::optional<Value> value = values_.number(mimic, tag, what);
      return value ? value->number : otherwise;
    };
    const Number factor = number("multiplier", 0), reference = number("reference", 0), offset = number("offset", 0);
    joint_.coupled =
        Coupled{{{{followed, name.place}, factor}}, Number(offset - factor * reference).expand(), mimic.place};
  }

  const SdfTree& tree_;
  const SdfFrame& frame_;
  const SdfValues& values_;
  ReadContext& context_;
  Joint& joint_;
  std::string what_;
};

}  // namespace

int frame_of_axis(const SdfTree& tree, int joint, const FileNode& axis, Diagnostics& diagnostics) {
  const SdfFrame& frame = tree.frames[static_cast<std::size_t>(joint)];
  const SdfValues& values = *frame.values;
  const std::string what = name_of(frame) + ", axis";
  const FileNode* xyz = axis.child("xyz");
  const std::string name = xyz == nullptr ? "" : xyz->value("expressed_in");
  const bool is_of_model = values.flag(axis, "use_parent_model_frame", values.version() <= 4, what);
  if (!name.empty()) {
    const int found = find_sdf_frame(tree, frame.scope, {name, xyz->place}, what + ", expressed_in", diagnostics);
    return found < 0 ? joint : found;
  }
  return is_of_model ? tree.scopes[static_cast<std::size_t>(frame.scope)].frame : joint;
}

void read_sdf_axis(const SdfTree& tree, const SdfFrame& frame, const FileNode& axis, ReadContext& context,
                   Joint& joint) {
  AxisReader(tree, frame, context, joint).read(axis);
}

void read_drake_words(const SdfTree& tree, const SdfFrame& frame, Diagnostics& diagnostics, Joint& joint) {
  const SdfValues& values = *frame.values;
  const std::string what = name_of(frame);
  if (const auto rotor = values.number(*frame.element, "drake:rotor_inertia", what)) {
    const Number ratio =
        values.number(*frame.element, "drake:gear_ratio", what).value_or(Value{1, rotor->place}).number;
    joint.armature = {Number(ratio * ratio * rotor->number).expand(), rotor->place};
    values.context().rotor_joints.insert(joint.name);
  }
  const FileNode* mimic = values.child(*frame.element, "drake:mimic", what);
  if (mimic == nullptr) return;
  const Reference name{values.required_attribute(*mimic, "joint", what + ", drake:mimic"), mimic->place};
  if (name.name.empty()) return;
  const int leader = find_sdf_frame(tree, frame.scope, name, what + ", drake:mimic", diagnostics);
  if (leader < 0) return;
  const Value one{1, name.place}, zero{0, name.place};
  joint.coupled = Coupled{{{{name_of_axis(tree.frames[static_cast<std::size_t>(leader)], "axis"), name.place},
                            values.attribute(*mimic, "multiplier", what).value_or(one).number}},
                          values.attribute(*mimic, "offset", what).value_or(zero).number,
                          name.place};
}

bool has_two_axes(const SdfFrame& joint) {
  const std::string type = joint.element->value("type");
  return type == "universal" || type == "revolute2";
}

std::string name_of_axis(const SdfFrame& joint, const std::string& axis) {
  return has_two_axes(joint) ? joint.name + "." + axis : joint.name;
}

}  // namespace flatdyn
