// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/joints.hpp"

#include <algorithm>
#include <cstdlib>

#include "robot/input/common/exact_root.hpp"
#include "robot/input/common/poses.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/mjcf/names.hpp"

namespace flatdyn {

namespace {

// A joint of a type that the model does not have. It can be held still.
void refuse_joint_type(const Place& place, const std::string& what, const std::string& type, const std::string& name,
                       const MjcfValues& values) {
  values.diagnostics().unsupported(place, what + ": type \"" + type + "\" is not supported yet",
                                   "hold it still by the option --fix " + name);
}

Number smaller_magnitude(const Number& a, const Number& b) {
  return magnitude(a) < magnitude(b) ? Number(magnitude(a)) : Number(magnitude(b));
}

class JointReader {
 public:
  // `is_childless`: whether the joint's body has no bodies on it.
  JointReader(const MjcfJoint& joint, const std::string& name, bool is_childless, const MjcfModel& model)
      : is_childless_(is_childless),
        values_(model.values),
        settings_(model.settings),
        context_(model.values.context()),
        read_(joint),
        item_(joint.element->name == "freejoint" ? MjcfValues::plain(*joint.element)
                                                 : model.values.item(*joint.element, joint.class_name)) {
    joint_.name = name;
    joint_.place = joint.element->place;
    item_.what = "joint \"" + name + "\"";
  }

  // nullopt if it is refused. One of a type that the model does not have can be held where the file puts the body.
  std::optional<Joint> read() {
    const std::string type = this->type();
    if (type == "free" || type == "ball") {
      position_count_ = type == "free" ? 7 : 4;
      is_free_ = type == "free" && !is_held(joint_.name, context_);
      if (is_free_ && context_.options.floating_base.value_or(true)) {
        read_forces_of_base();
        refuse_alignment();
      }
      if (is_free_ || is_held(joint_.name, context_)) return joint_;
      if (type == "free") {
        refuse_joint_type(item_.element->place, item_.what, type, joint_.name, values_);
        return std::nullopt;
      }
      read_ball();
      return joint_;
    }
    joint_.type = type == "slide" ? JointType::prismatic : JointType::continuous;
    read_axis();
    read_limits();
    read_forces();
    return joint_;
  }

  Number reference() const { return reference_; }
  bool is_free() const { return is_free_; }
  int position_count() const { return position_count_; }

  // The position of a hinge or slide in MuJoCo's qpos_spring.
  Number relaxed() const {
    const bool has_one = position_count_ == 1 && joint_.type != JointType::fixed;
    if (!has_one) return 0;
    return vanishes(joint_.stiffness.number) ? relaxed_position().number : joint_.spring_reference.number;
  }

 private:
  bool slides() const { return joint_.type == JointType::prismatic; }

  std::string type() const {
    if (item_.element->name == "freejoint") return "free";
    return values_.keyword(item_, "type", {"hinge", "slide", "ball", "free"}, "hinge");
  }

  // Those that MuJoCo adds to the six entries of the joint. Most of them come from defaults that are meant for others.
  void read_forces_of_base() {
    for (const char* name : {"stiffness", "springdamper"}) {
      const FileAttribute* found = values_.find(item_, name);
      if (found == nullptr || is_zero_text(found->text)) continue;
      values_.diagnostics().unsupported(found->place,
                                        values_.spot(item_, *found).what + ": not supported for a free joint",
                                        "write <freejoint/>, which has no such forces and takes no defaults");
    }
    joint_.armature = values_.number_or(item_, "armature", 0);
    joint_.coulomb = values_.number_or(item_, "frictionloss", 0);
    joint_.viscous = mjcf_linear(item_, "damping", values_);
    tell_of_forces_of_base();
  }

  void tell_of_forces_of_base() {
    std::string named;
    for (const auto& [name, value] : {std::pair("armature", &joint_.armature), std::pair("damping", &joint_.viscous),
                                      std::pair("frictionloss", &joint_.coulomb)}) {
      if (!vanishes(value->number)) named += (named.empty() ? "" : ", ") + std::string(name);
    }
    if (named.empty()) return;
    context_.diagnostics.note(
        joint_.place, item_.what + " moves freely with " + named + ", perhaps by accident",
        "as in MuJoCo they act on the base, which nothing holds; <freejoint/> has none, and takes "
        "none from defaults");
    if (vanishes(joint_.coulomb.number)) return;
    context_.diagnostics.warning(
        joint_.coulomb.place,
        item_.what +
            ", frictionloss: left out along the axes of the world, read about those of "
            "the base",
        "its force depends on how the base is turned, which functions are not told; headers of "
        "--convention, which take the pose, add it");
  }

  // MuJoCo moves the frame of such a body to its centre of mass, along its principal axes, if it carries no other.
  void refuse_alignment() const {
    const std::string word = values_.keyword(item_, "align", {"true", "false", "auto"}, "auto");
    if (!is_childless_ || word == "false" || (word == "auto" && !settings_.aligns_free_bodies)) return;
    values_.diagnostics().unsupported(joint_.place,
                                      item_.what + ": a frame that is aligned with the inertia is not supported",
                                      "write align=\"false\": the frame of the body is that of the file then");
  }

  // A ball joint turns about its point, with the body's axes; velocities are along these.
  void read_ball() {
    joint_.type = JointType::spherical;
    const ExactPlace frame = exact_place(read_.frame);
    const Vec3 position = frame.R * values_.length_vector(item_, "pos") + frame.p;
    joint_.origin.place = joint_.link_offset.place = joint_.place;
    if (!vanishes(dot(position, position))) {
      joint_.origin.displacements.push_back(translation(position));
      joint_.link_offset.displacements.push_back(translation(Number(-1) * position));
    }
    tell_of_range();
    tell_of_effort();
    read_forces();
  }

  void tell_of_range() {
    if (!mjcf_is_limited(item_, "range", "limited", values_, settings_)) return;
    const auto range = values_.range(item_, "range");
    if (range && (*range)[0] && !vanishes((*range)[0]->number)) {
      context_.diagnostics.error((*range)[0]->place, item_.what + ", range: the first number of a ball joint is not 0",
                                 "write range=\"0 ANGLE\": the joint turns by up to ANGLE, about any axis");
    }
    context_.diagnostics.note(joint_.place, item_.what + ": its range, of the angle by which it turns, is not kept",
                              "limits of position are those of joints with one axis",
                              "ranges of ball joints, which are not kept");
  }

  // MuJoCo clamps the forces of actuators on hinges and slides only.
  void tell_of_effort() {
    if (!mjcf_is_limited(item_, "actuatorfrcrange", "actuatorfrclimited", values_, settings_)) return;
    context_.diagnostics.note(values_.find(item_, "actuatorfrcrange")->place,
                              item_.what + ": its actuatorfrcrange is not read",
                              "MuJoCo limits efforts of hinge and slide joints only",
                              "limits of the efforts of ball joints, which are not read");
  }

  // The joint's frame is the body's, with the origin on the axis; `ref` is the position at which it does not move the
  // body.
  void read_axis() {
    const ExactPlace frame = exact_place(read_.frame);
    joint_.axis = frame.R * values_.vector(item_, "axis", {0, 0, 1});
    if (vanishes(dot(joint_.axis, joint_.axis))) {
      context_.diagnostics.error(joint_.place, item_.what + ": its axis is zero", "give the axis a direction");
      joint_.axis = {0, 0, 1};
    }
    const Vec3 position = frame.R * values_.length_vector(item_, "pos") + frame.p;
    joint_.origin.place = joint_.link_offset.place = joint_.place;
    if (!slides() && !vanishes(dot(position, position))) {
      joint_.origin.displacements.push_back(translation(position));
      joint_.link_offset.displacements.push_back(translation(Number(-1) * position));
    }
    read_reference();
  }

  void read_reference() {
    const auto found = values_.numbers(item_, "ref", 1, 1);
    if (!found) return;
    if (slides()) {
      reference_ = found->numbers[0];
      if (vanishes(reference_)) return;
      const Number length = exact_root(dot(joint_.axis, joint_.axis));
      joint_.origin.displacements.push_back(translation((-reference_ / length) * joint_.axis));
      return;
    }
    reference_ = decimal_angle(found->numbers[0], found->written[0], settings_.angles, found->spot, context_);
    for (const Displacement& turn : turn_about(joint_.axis, -reference_, found->spot, found->written[0], context_)) {
      joint_.origin.displacements.push_back(turn);
    }
  }

  void read_limits() {
    if (mjcf_is_limited(item_, "range", "limited", values_, settings_)) {
      if (const auto range = values_.range(item_, "range")) {
        joint_.limits.lower = in_si((*range)[0]);
        joint_.limits.upper = in_si((*range)[1]);
      }
      const bool has_any = joint_.limits.lower || joint_.limits.upper;
      if (!slides() && has_any) joint_.type = JointType::revolute;
    }
    joint_.limits.effort = mjcf_effort(item_, "actuatorfrcrange", "actuatorfrclimited", values_, settings_);
  }

  std::optional<Value> in_si(std::optional<Value> limit) const {
    if (limit && !slides()) {
      limit->number = in_radians(limit->number, settings_.angles, {limit->place, item_.what}, context_.diagnostics);
    }
    return limit;
  }

  void read_forces() {
    joint_.armature = values_.number_or(item_, "armature", 0);
    joint_.coulomb = values_.number_or(item_, "frictionloss", 0);
    joint_.viscous = mjcf_linear(item_, "damping", values_);
    joint_.stiffness = mjcf_linear(item_, "stiffness", values_);
    if (!vanishes(joint_.stiffness.number)) joint_.spring_reference = relaxed_position();
    const FileAttribute* found = values_.find(item_, "springdamper");
    if (found == nullptr || is_zero_text(found->text)) return;
    refuse_mjcf(found->place,
                values_.spot(item_, *found).what + ": a spring that is given by its motion is not supported",
                "springdamper", values_);
  }

  // MuJoCo's qpos_spring, at which the spring exerts nothing; `ref` moves the body, not the spring.
  Value relaxed_position() const {
    const auto found = values_.numbers(item_, "springref", 1, 1);
    if (!found) return {0, joint_.place};
    if (slides()) return {found->numbers[0], found->spot.place};
    return {in_radians(found->numbers[0], settings_.angles, found->spot, context_.diagnostics), found->spot.place};
  }

  bool is_childless_;
  const MjcfValues& values_;
  const MjcfSettings& settings_;
  ReadContext& context_;
  const MjcfJoint& read_;
  MjcfItem item_;
  Joint joint_;
  Number reference_ = 0;
  bool is_free_ = false;
  int position_count_ = 1;
};

// `others`: the joints of the same body, which the robot does not have yet.
std::string new_joint_name(const std::string& wanted, const std::vector<Joint>& others, const MjcfModel& model) {
  std::vector<std::string> taken = model.names_of_joints;
  for (const Joint& joint : model.robot.joints) taken.push_back(joint.name);
  for (const Joint& joint : others) taken.push_back(joint.name);
  return unused_name(wanted, taken);
}

bool has_body(const FileNode& element) {
  return std::any_of(element.children.begin(), element.children.end(),
                     [](const FileNode& child) { return child.name == "body" || has_body(child); });
}

// MuJoCo refuses a body whose ball joint is followed by a joint that turns.
bool turns_after_ball(const std::vector<Joint>& before, const Joint& joint) {
  return joint.type != JointType::prismatic && joint.type != JointType::fixed &&
         std::any_of(before.begin(), before.end(),
                     [](const Joint& other) { return other.type == JointType::spherical; });
}

std::string joint_name(const MjcfJoint& joint, const std::string& body, const std::vector<Joint>& others,
                       const MjcfModel& model) {
  const std::string name = joint.element->value("name");
  return name.empty() ? new_joint_name(body + "_joint", others, model) : name;
}

}  // namespace

bool mjcf_is_limited(const MjcfItem& item, const char* range, const char* limited, const MjcfValues& values,
                     const MjcfSettings& settings) {
  const std::string word = values.keyword(item, limited, {"true", "false", "auto"}, "auto");
  const FileAttribute* found = values.find(item, range);
  if (word == "false" || (found == nullptr && word == "auto")) return false;
  Diagnostics& diagnostics = values.diagnostics();
  if (found == nullptr) {
    diagnostics.error(item.element->place, item.what + ": " + limited + " is true, but " + range + " is not given",
                      std::string("write ") + range + "=\"LOWER UPPER\"");
    return false;
  }
  const std::vector<std::string> words = words_of(found->text);
  if (words.size() != 2) return true;  // an error where they are read
  const double lower = std::strtod(words[0].c_str(), nullptr), upper = std::strtod(words[1].c_str(), nullptr);
  if (word == "true" && lower >= upper) {
    diagnostics.error(found->place, item.what + ", " + range + ": the first number is not below the second",
                      "write the lower limit first");
    return false;
  }
  if (word == "true") return true;
  if (!settings.automatic_limits && lower != upper) {
    diagnostics.error(found->place,
                      item.what + ": " + range + " is given, but not " + limited + ", and autolimits is false",
                      std::string("write ") + limited + "=\"true\" or \"false\"");
  }
  if (lower > upper) {
    diagnostics.warning(
        found->place,
        item.what + ", " + range + ": the first number is above the second: as in MuJoCo, there is no limit",
        "write the lower limit first", "ranges without effect, as their numbers are exchanged");
  }
  return lower < upper;
}

Value mjcf_linear(const MjcfItem& item, const char* name, const MjcfValues& values) {
  const auto found = values.numbers(item, name, 1, 3);
  if (!found) return {0, item.element->place};
  const bool is_linear =
      std::all_of(found->numbers.begin() + 1, found->numbers.end(), [](const Number& x) { return vanishes(x); });
  if (!is_linear) {
    refuse_mjcf(found->spot.place, found->spot.what + ": " + name + " that is not linear is not supported", name,
                values);
  }
  return {found->numbers[0], found->spot.place};
}

std::optional<Value> mjcf_effort(const MjcfItem& item, const char* range, const char* limited, const MjcfValues& values,
                                 const MjcfSettings& settings) {
  if (!mjcf_is_limited(item, range, limited, values, settings)) return std::nullopt;
  const auto limits = values.range(item, range);
  if (!limits || !(*limits)[0] || !(*limits)[1]) return std::nullopt;
  const Number lower = (*limits)[0]->number, upper = (*limits)[1]->number;
  const bool acts_one_way = vanishes(lower) != vanishes(upper);
  const Value effort{acts_one_way ? Number(magnitude(lower + upper)) : smaller_magnitude(lower, upper),
                     (*limits)[0]->place};
  if (vanishes(lower + upper)) return effort;
  if (acts_one_way) {
    values.diagnostics().note(effort.place,
                              item.what + ", " + range + ": it acts one way only; its limit counts both ways",
                              "effort limits are the same both ways here", "effort limits of one direction only");
    return effort;
  }
  values.diagnostics().note(effort.place, item.what + ", " + range + ": the smaller of its two limits counts both ways",
                            "effort limits are the same both ways here", "effort limits that differ by direction");
  return effort;
}

void add_mjcf_joints(const std::vector<MjcfJoint>& joints, const std::string& body, int parent_link, MjcfModel& model,
                     MjcfBody& added) {
  Robot& robot = model.robot;
  std::vector<Joint> moving;
  std::vector<bool> is_free;
  const bool has_tendons = !model.root.elements("tendon").empty();
  for (const MjcfJoint& each : joints) {
    JointReader reader(each, joint_name(each, body, moving, model), !has_body(*added.element), model);
    const std::optional<Joint> joint = reader.read();
    if (!joint) continue;
    if (turns_after_ball(moving, *joint)) {
      model.diagnostics().error(joint->place, "joint \"" + joint->name + "\" turns a body that a ball joint turns",
                                "write slides and hinges before the ball joint, or give the joint a body of its own");
    }
    model.reference[joint->name] = reader.reference();
    if (has_tendons) model.relaxed[joint->name] = reader.relaxed();
    moving.push_back(*joint);
    is_free.push_back(reader.is_free());
    added.position_counts.push_back(reader.position_count());
  }
  if (moving.empty()) {
    Joint fixed;
    fixed.name = new_joint_name(body, moving, model);
    fixed.place = added.element->place;
    moving.push_back(fixed);
    is_free.push_back(false);
    added.position_counts.push_back(0);
  }
  moving.front().origin = joined(added.pose, moving.front().origin);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const bool is_last = k + 1 == moving.size();
    moving[k].parent = parent_link;
    const std::string link = is_last ? body : new_body_name(body + "_" + std::to_string(k + 1), model);
    moving[k].child = parent_link = model.builder.add_link({link, {}, added.element->place});
    added.joints.push_back(static_cast<int>(robot.joints.size()));
    if (is_free[k]) added.free_joints.push_back(added.joints.back());
    robot.joints.push_back(moving[k]);
  }
  added.link = parent_link;
}

}  // namespace flatdyn
