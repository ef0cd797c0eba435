// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/reader.hpp"

#include <algorithm>
#include <map>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/exchanged_limits.hpp"
#include "robot/input/common/floating_joints.hpp"
#include "robot/input/common/foreign_files.hpp"
#include "robot/input/common/robot_builder.hpp"
#include "robot/input/common/xacro.hpp"
#include "robot/input/common/xml_document.hpp"
#include "robot/input/urdf/actuators.hpp"
#include "robot/input/urdf/couplings.hpp"
#include "robot/input/urdf/loops.hpp"
#include "robot/input/urdf/mimics.hpp"
#include "robot/input/urdf/names.hpp"
#include "robot/input/urdf/planar.hpp"
#include "robot/input/urdf/simulators.hpp"
#include "robot/input/urdf/springs.hpp"
#include "robot/input/urdf/unsupported.hpp"
#include "robot/input/urdf/values.hpp"

namespace flatdyn {

namespace {

constexpr const char* kFixHint = "hold it still: make it type=\"fixed\", or give the option --fix ";

class UrdfReader {
 public:
  UrdfReader(const FileNode& root, ReadContext& context, Robot& robot)
      : values_(root, context),
        context_(context),
        diagnostics_(context.diagnostics),
        robot_(robot),
        builder_(context, robot) {}

  void read() {
    const FileNode& root = values_.root();
    if (!root.value("name").empty()) robot_.name = values_.required_text(root, "name", "robot");
    for (const FileNode* e : root.elements("link")) read_link(*e);
    for (const FileNode* e : root.elements("joint")) read_joint(*e);
    for (const int link : point_masses_) tell_of_point_mass(robot_.links[static_cast<std::size_t>(link)], moves(link));
    // Couplings go by the marks, and by the joints that follow others already.
    read_urdf_mimics(root, floating_names(), values_, robot_);
    read_urdf_marks(root, values_, robot_);
    read_urdf_couplings(root, values_, robot_);
    read_urdf_loops(root, values_, robot_);
    // The rest finds joints by their names in the file; the order is only that of the messages.
    check_urdf_names(root, values_);
    read_urdf_springs(root, values_, robot_);
    refuse_unread_dynamics(root, values_, robot_);
    check_urdf_simulators(root, values_, robot_);
    read_urdf_actuators(root, values_, robot_);
    // Floating and planar joints come last: joints that stand for them have other names.
    read_floating_joints();
    for (const std::string& joint : planar_) split_planar_joint(joint, context_, robot_);
  }

 private:
  std::set<std::string> floating_names() const {
    std::set<std::string> names;
    for (const int joint : floating_) names.insert(robot_.joints[static_cast<std::size_t>(joint)].name);
    return names;
  }

  void read_floating_joints() {
    std::vector<int> of_base;
    std::vector<std::string> in_tree;
    for (std::size_t k = 0; k < floating_.size(); ++k) {
      const Joint& joint = robot_.joints[static_cast<std::size_t>(floating_[k])];
      if (!floats_in_tree(robot_, joint)) {
        of_base.push_back(floating_[k]);
        continue;
      }
      in_tree.push_back(joint.name);
      refuse_of_parts(*floating_elements_[k], joint);
    }
    // Held still by --base fixed, the base's joint is a fixed one.
    if (context_.options.floating_base.value_or(true)) take_floating_joints(of_base, context_, robot_);
    for (const std::string& joint : in_tree) split_floating_joint(joint, robot_);
  }

  // The file does not say which coordinate of a joint that floats in the tree its friction and limits are meant for.
  void refuse_of_parts(const FileNode& element, const Joint& joint) {
    for (const char* tag : {"dynamics", "limit"}) {
      const FileNode* found = element.child(tag);
      if (found == nullptr) continue;
      diagnostics_.unsupported(
          found->place, "joint \"" + joint.name + "\": <" + tag + "> of a joint that floats in the tree is not read",
          "delete it, and give what it says in a TOML file over the URDF, of " + joint.name + ".x, " + joint.name +
              ".y, " + joint.name + ".z and " + joint.name + ".turn");
    }
  }

  void read_link(const FileNode& element) {
    Link link;
    link.place = element.place;
    link.name = values_.required_text(element, "name", "link");
    const std::string what = "link \"" + link.name + "\"";
    const FileNode* inertial = element.child("inertial");
    if (inertial != nullptr) link.inertials.push_back(read_inertial(*inertial, what));
    builder_.add_link(std::move(link));
  }

  Inertial read_inertial(const FileNode& element, const std::string& link) {
    Inertial inertial;
    inertial.place = element.place;
    inertial.frame = values_.origin(element, link + ", inertial");
    const FileNode* mass = element.child("mass");
    if (mass == nullptr) {
      diagnostics_.error(inertial.place, link + ": <inertial> has no <mass>", "write <mass value=\"...\"/> (kg)");
    } else {
      inertial.mass = values_.required_number(*mass, "value", link + ", mass");
    }
    const FileNode* inertia = element.child("inertia");
    if (inertia != nullptr) {
      inertial.tensor = read_tensor(*inertia, link + ", inertia");
    } else if (mass != nullptr) {
      point_masses_.push_back(static_cast<int>(robot_.links.size()));
    }
    return inertial;
  }

  // Whether a joint moves it, or one that carries it. Trees are checked later: what goes round is not followed for
  // ever.
  bool moves(int link) const {
    for (std::size_t step = 0; step < robot_.joints.size(); ++step) {
      const auto above = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                      [link](const Joint& joint) { return joint.child == link; });
      if (above == robot_.joints.end() || above->parent < 0) return false;
      if (above->type != JointType::fixed) return true;
      link = above->parent;
    }
    return false;
  }

  void tell_of_point_mass(const Link& link, bool moves) {
    const Place& place = link.inertials.front().place;
    const std::string message = "link \"" + link.name + "\": <inertial> has no <inertia>: it counts as a point mass";
    const char* hint = "write <inertia ixx= iyy= izz= ixy= ixz= iyz=/> (kg m^2); all 0 for a point mass";
    if (moves) {
      diagnostics_.warning(place, message, hint, "links with a mass and no inertia, which count as point masses");
    } else {
      diagnostics_.note(place, message + ", and does not move", hint, "links at rest with a mass and no inertia");
    }
  }

  Mat3 read_tensor(const FileNode& element, const std::string& what) {
    const auto diagonal = [&](const char* key) { return values_.required_number(element, key, what).number; };
    const auto product = [&](const char* key) {
      return values_.number(element, key, what).value_or(Value{0, element.place}).number;
    };
    const Number xx = diagonal("ixx"), yy = diagonal("iyy"), zz = diagonal("izz");
    const Number xy = product("ixy"), xz = product("ixz"), yz = product("iyz");
    return {Vec3{xx, xy, xz}, Vec3{xy, yy, yz}, Vec3{xz, yz, zz}};
  }

  void read_joint(const FileNode& element) {
    Joint joint = RobotBuilder::new_joint(values_.required_text(element, "name", "joint"), element.place);
    const std::string what = "joint \"" + joint.name + "\"";
    joint.type = read_type(element, joint);
    joint.parent = read_link_name(element, "parent", what);
    joint.child = read_link_name(element, "child", what);
    joint.origin = values_.origin(element, what);
    if (joint.type != JointType::fixed) {
      read_axis(element, what, joint);
      read_limits(element, what, joint);
      read_friction(element, what, joint);
    } else if (joint.held) {
      read_axis(element, what, joint);
      read_limits(element, what, joint);
    }
    builder_.add_joint(std::move(joint));
  }

  // The type that a held joint would otherwise have is kept in joint.held.
  JointType read_type(const FileNode& element, Joint& joint) {
    static const std::map<std::string, JointType> kTypes = {{"fixed", JointType::fixed},
                                                            {"revolute", JointType::revolute},
                                                            {"continuous", JointType::continuous},
                                                            {"prismatic", JointType::prismatic}};
    const std::string what = "joint \"" + joint.name + "\"";
    const std::string type = values_.required_text(element, "type", what);
    const auto found = kTypes.find(type);
    if (is_held(joint.name, context_) || type.empty()) {
      if (found != kTypes.end() && found->second != JointType::fixed) joint.held = Held{found->second};
      return JointType::fixed;
    }
    if (type == "floating") {
      floating_.push_back(static_cast<int>(robot_.joints.size()));
      floating_elements_.push_back(&element);
      return JointType::fixed;
    }
    if (type == "planar") {
      planar_.push_back(joint.name);
      tell_of_limits(element, what);
      return JointType::continuous;  // until all that speaks of it is read
    }
    if (found == kTypes.end()) {
      report_type(element, what, joint.name, type);
      return JointType::fixed;
    }
    return found->second;
  }

  void tell_of_limits(const FileNode& element, const std::string& what) {
    const FileNode* limit = element.child("limit");
    if (limit == nullptr) return;
    diagnostics_.note(limit->place, what + ": limits of a planar joint are not read",
                      "give them in a TOML file over the URDF, [[joint]] by [[joint]]", "limits of planar joints");
  }

  void report_type(const FileNode& element, const std::string& what, const std::string& name, const std::string& type) {
    static const std::vector<std::string> kNotYet = {"ball", "spherical", "universal", "screw"};
    if (std::find(kNotYet.begin(), kNotYet.end(), type) != kNotYet.end()) {
      diagnostics_.unsupported(element.place, what + ": type \"" + type + "\" is not supported yet", kFixHint + name);
    } else {
      diagnostics_.error(element.place, what + ": unknown type \"" + type + "\"",
                         hint_for_unknown(type, {"fixed", "revolute", "continuous", "prismatic", "planar"}, "types"));
    }
  }

  int read_link_name(const FileNode& joint, const char* tag, const std::string& what) {
    const FileNode* element = joint.child(tag);
    if (element == nullptr) {
      diagnostics_.error(joint.place, what + " has no <" + tag + ">", std::string("write <") + tag + " link=\"...\"/>");
      return -1;
    }
    const std::string name = values_.required_text(*element, "link", what);
    if (name.empty()) return -1;
    const bool is_ground = name == "world" && std::string_view(tag) == "parent" && !builder_.has_link(name);
    return is_ground ? add_world(*element, what)
                     : builder_.link({name, element->place}, what, std::string(tag) + " link");
  }

  // Some programs assume a link "world" that the file does not declare.
  int add_world(const FileNode& parent, const std::string& what) {
    diagnostics_.note(parent.place, what + ": there is no link \"world\": it is taken for the ground",
                      "write <link name=\"world\"/> to say so");
    return builder_.world(parent.place);
  }

  void read_axis(const FileNode& element, const std::string& what, Joint& joint) {
    joint.axis = {1, 0, 0};  // URDF's default
    if (const FileNode* axis = element.child("axis")) {
      joint.axis = values_.required_vector(*axis, "xyz", what + ", axis").value_or(joint.axis);
    }
  }

  void read_limits(const FileNode& element, const std::string& what, Joint& joint) {
    const FileNode* limit = element.child("limit");
    if (limit == nullptr) return;
    const std::string where = what + ", limit";
    if (joint.type != JointType::continuous && !(joint.held && joint.held->type == JointType::continuous)) {
      joint.limits.lower = values_.limit(*limit, "lower", Bound::lower, where);
      joint.limits.upper = values_.limit(*limit, "upper", Bound::upper, where);
    }
    remove_exchanged_limits(joint, diagnostics_);
    joint.limits.velocity = values_.limit(*limit, "velocity", Bound::magnitude, where);
    joint.limits.effort = values_.limit(*limit, "effort", Bound::magnitude, where);
    joint.limits.acceleration = values_.limit(*limit, "acceleration", Bound::magnitude, where);
  }

  void read_friction(const FileNode& element, const std::string& what, Joint& joint) {
    if (auto damping = values_.dynamics(element, "damping", what)) joint.viscous = *damping;
    if (auto friction = values_.dynamics(element, "friction", what)) joint.coulomb = *friction;
  }

  UrdfValues values_;
  ReadContext& context_;
  Diagnostics& diagnostics_;
  Robot& robot_;
  RobotBuilder builder_;
  std::vector<int> floating_;  // joints of that type, and their elements
  std::vector<const FileNode*> floating_elements_;
  std::vector<std::string> planar_;
  std::vector<int> point_masses_;  // links whose <inertial> has a mass and no inertia
};

void report_other_format(const FileNode& root, Diagnostics& diagnostics) {
  const std::string& name = root.name;
  const std::string message = "the outermost element is <" + name + ">, not <robot>";
  if (const std::optional<ForeignFile> foreign = foreign_by_element(name)) {
    diagnostics.error(root.place, foreign->what, foreign->hint);
  } else if (name == "mujocoinclude") {
    diagnostics.unsupported(root.place, message + ": this format is not supported",
                            "convert the model to URDF, or write a TOML file");
  } else {
    diagnostics.error(root.place, message, "a URDF file is <robot name=\"...\"> ... </robot>");
  }
}

}  // namespace

void read_urdf(const std::string& text, const std::string& file, ReadContext& context, Robot& robot) {
  static const XmlForm kForm = {".urdf", "a URDF file is <robot name=\"...\"> ... </robot>"};
  const std::optional<XmlDocument> document = parse_xml(text, file, kForm, context.diagnostics);
  if (!document) return;
  if (document->root.name != "robot") {
    report_other_format(document->root, context.diagnostics);
    return;
  }
  if (refuse_content_beside(*document, kForm, context.diagnostics)) return;
  if (refuse_template(document->root, context.diagnostics)) return;
  UrdfReader(document->root, context, robot).read();
}

}  // namespace flatdyn
