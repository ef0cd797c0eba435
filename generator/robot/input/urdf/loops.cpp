// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/loops.hpp"

#include <algorithm>
#include <set>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/children.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {

namespace {

enum class Cut { point, axis, unsupported, unknown };

Cut cut_of(const std::string& type) {
  static const std::set<std::string> kPoints = {"spherical", "ball", "position"};
  static const std::set<std::string> kAxes = {"revolute", "continuous", "hinge"};
  static const std::set<std::string> kOthers = {"prismatic", "planar", "fixed",   "link", "universal",
                                                "floating",  "screw",  "rolling", "weld", "cylindrical"};
  constexpr std::string_view kSuffix = "_joint";
  const std::string name = type.ends_with(kSuffix) ? type.substr(0, type.size() - kSuffix.size()) : type;
  if (kPoints.count(name) > 0) return Cut::point;
  if (kAxes.count(name) > 0) return Cut::axis;
  return kOthers.count(name) > 0 ? Cut::unsupported : Cut::unknown;
}

// The names of one of the two ends: <predecessor>, <predecessor_origin>, <predecessor_axis>.
struct EndTags {
  std::string link, origin, axis;

  explicit EndTags(const std::string& name) : link(name), origin(name + "_origin"), axis(name + "_axis") {}
};

Mat3 turn_of(const Pose& pose) {
  Mat3 R = identity_matrix();
  for (const Displacement& each : pose.displacements) {
    if (each.kind == Displacement::Kind::rotation_x) R = R * rotation_x(planar_rotation(each.angle));
    if (each.kind == Displacement::Kind::rotation_y) R = R * rotation_y(planar_rotation(each.angle));
    if (each.kind == Displacement::Kind::rotation_z) R = R * rotation_z(planar_rotation(each.angle));
  }
  return expanded(R);
}

// An origin is one translation, if any, and then rotations.
Vec3 point_of(const Pose& pose) {
  return pose.displacements.empty() ? zero_vector() : pose.displacements.front().translation;
}

class LoopReader {
 public:
  LoopReader(const UrdfValues& values, Robot& robot)
      : values_(values), diagnostics_(values.context().diagnostics), robot_(robot) {}

  void read(const FileNode& root) {
    for (const FileNode& element : root.children) {
      const std::string& name = element.name;
      if (name == "loop" || name == "loop_joint" || name == "constraint") read_typed(element);
      if (name == "loop_constraint") read_loop(element, Cut::point);
      if (name == "mujoco") {
        for (const FileNode* equality : element.elements("equality")) read_equality(*equality);
      }
    }
  }

 private:
  void read_typed(const FileNode& element) {
    const std::string what = name_in_messages(element);
    const std::string type = values_.required_text(element, "type", what);
    if (type.empty()) return;
    const Cut cut = cut_of(type);
    if (cut == Cut::unknown) {
      diagnostics_.error(element.place, what + ": unknown type \"" + type + "\"",
                         hint_for_unknown(type, {"revolute", "continuous", "spherical", "ball"}, "types"));
    } else if (cut == Cut::unsupported) {
      diagnostics_.unsupported(element.place, what + ": type \"" + type + "\" is not supported yet",
                               "cut the loop at a joint of type \"revolute\" or \"spherical\"");
    } else {
      read_loop(element, cut);
    }
  }

  // <loop_joint> is Drake's, with the point of each end in <link1 link xyz rpy> and <link2>.
  static std::array<EndTags, 2> tags_of(const FileNode& element) {
    const std::string& name = element.name;
    const auto has = [&element](const char* tag) { return element.child(tag) != nullptr; };
    if (name == "loop_joint" && !has("predecessor") && !has("parent")) return {EndTags("link1"), EndTags("link2")};
    const bool is_plus = name == "loop" || has("predecessor");
    return {EndTags(is_plus ? "predecessor" : "parent"), EndTags(is_plus ? "successor" : "child")};
  }

  static bool has_point_in_link(const EndTags& tags) { return tags.link.starts_with("link"); }

  // The axis of both ends and that of one of them are the same thing twice.
  void check_axes(const FileNode& element, const std::string& what, const std::array<EndTags, 2>& tags) {
    const FileNode* common = element.child("axis");
    for (const EndTags& end : tags) {
      const FileNode* own = element.child(end.axis);
      if (common == nullptr || own == nullptr) continue;
      const auto axis = values_.text(*common, "xyz", what), other = values_.text(*own, "xyz", what);
      if (axis && other && are_equivalent_texts(axis->text, other->text)) continue;
      diagnostics_.error(own->place, what + " has both <axis> and <" + end.axis + ">, which differ",
                         "keep the one that is right");
    }
  }

  void read_loop(const FileNode& element, Cut cut) {
    const std::array<EndTags, 2> tags = tags_of(element);
    const std::string what = name_in_messages(element);
    refuse_other_attributes(element, what, {"name", "type"}, values_);
    check_children(element, what, tags);
    check_axes(element, what, tags);
    Loop loop;
    loop.place = element.place;
    loop.name = element.value("name");
    loop.is_marked = true;
    std::array<Vec3, 2> axes;
    bool complete = true;
    for (std::size_t e = 0; e < 2; ++e) {
      complete = read_end(element, what, tags[e], loop.links[e]) && complete;
      const Pose frame = frame_of(element, what, tags[e]);
      loop.points[e] = point_of(frame);
      if (cut == Cut::axis) axes[e] = turn_of(frame) * axis_of(element, what, {tags[e].axis, tags[0].axis, "axis"});
    }
    if (cut == Cut::axis) loop.axes = axes;
    if (!complete || (cut == Cut::axis && !have_directions(axes, loop, what))) return;
    robot_.loops.push_back(std::move(loop));
  }

  bool have_directions(const std::array<Vec3, 2>& axes, const Loop& loop, const std::string& what) {
    if (std::none_of(axes.begin(), axes.end(), [](const Vec3& axis) { return vanishes(dot(axis, axis)); })) return true;
    diagnostics_.error(loop.place, what + ": its axis is zero", "give the axis a direction");
    return false;
  }

  // The point and the axes of an end: <origin> in it, or next to it.
  Pose frame_of(const FileNode& element, const std::string& what, const EndTags& tags) {
    const FileNode* end = element.child(tags.link);
    const FileNode* beside = element.child(tags.origin);
    if (end != nullptr && has_point_in_link(tags)) return values_.origin(element, what, tags.link);
    if (end != nullptr && end->child("origin") != nullptr) {
      if (beside != nullptr) {
        diagnostics_.error(beside->place,
                           what + " has both <" + tags.origin + "> and an <origin> in <" + tags.link + ">", "keep one");
      }
      refuse_other_attributes(*end->child("origin"), what + ", " + tags.link + ", origin", {"xyz", "rpy", "quat_xyzw"},
                              values_);
      return values_.origin(*end, what + ", " + tags.link);
    }
    if (beside != nullptr) {
      refuse_other_attributes(*beside, what + ", " + tags.origin, {"xyz", "rpy", "quat_xyzw"}, values_);
    }
    return values_.origin(element, what, tags.origin);
  }

  // The first of these elements that is there; URDF's default of axes is 1 0 0.
  Vec3 axis_of(const FileNode& element, const std::string& what, const std::vector<std::string>& tags) {
    for (const std::string& tag : tags) {
      const FileNode* axis = element.child(tag);
      if (axis == nullptr) continue;
      refuse_other_attributes(*axis, what + ", " + tag, {"xyz"}, values_);
      values_.required_text(*axis, "xyz", what + ", " + tag);
      return values_.vector(*axis, "xyz", what + ", " + tag).value_or(Vec3{1, 0, 0});
    }
    return {1, 0, 0};
  }

  bool read_end(const FileNode& element, const std::string& what, const EndTags& tags, Reference& link) {
    const FileNode* end = element.child(tags.link);
    if (end == nullptr) {
      diagnostics_.error(element.place, what + " has no <" + tags.link + ">",
                         "write <" + tags.link + " link=\"...\"/>");
      return false;
    }
    const std::string where = what + ", " + tags.link;
    const bool has_point = has_point_in_link(tags);
    refuse_children(*end, where, has_point ? std::vector<std::string>{} : std::vector<std::string>{"origin"}, values_);
    if (end->elements("origin").size() > 1) {
      diagnostics_.error(end->place, where + " has two <origin> elements", "keep one");
    }
    refuse_other_attributes(
        *end, where,
        has_point ? std::vector<std::string>{"link", "xyz", "rpy", "quat_xyzw"} : std::vector<std::string>{"link"},
        values_);
    link = {values_.required_text(*end, "link", where), end->place};
    return !link.name.empty() && find_link(robot_, link, where, diagnostics_);
  }

  void check_children(const FileNode& element, const std::string& what, const std::array<EndTags, 2>& tags) {
    std::vector<std::string> known = {"axis"};
    for (const EndTags& end : tags) known.insert(known.end(), {end.link, end.origin, end.axis});
    for (const FileNode& child : element.children) {
      const std::string& name = child.name;
      if (name == "dynamics") {
        refuse_friction(child, what);
      } else if (name != "limit") {  // of the joint that is cut: nothing follows from them
        refuse_unless_known(child, what, known);
      }
    }
    for (const std::string& tag : known) refuse_second(element, what, tag, values_);
  }

  void refuse_unless_known(const FileNode& child, const std::string& what, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), child.name) != known.end()) return;
    diagnostics_.error(child.place, what + ": unknown element <" + child.name + ">",
                       hint_for_unknown(child.name, known, "elements"));
  }

  void refuse_friction(const FileNode& dynamics, const std::string& what) {
    for (const std::string& key : key_names_of(*known_urdf_element("dynamics"))) {
      const auto value = values_.number(dynamics, key.c_str(), what + ", dynamics");
      if (!value || vanishes(value->number)) continue;
      diagnostics_.unsupported(
          value->place, what + ", dynamics, " + key + ": friction in the joint that closes a loop is not supported yet",
          "cut the loop at a joint without friction, or leave it out");
      return;
    }
  }

  void read_equality(const FileNode& equality) {
    for (const FileNode& element : equality.children) {
      const std::string& name = element.name;
      if (name == "joint" || element.value("active") == "false") continue;
      if (name == "connect" && element.has("body1")) {
        read_connect(element);
      } else {
        diagnostics_.unsupported(element.place, "mujoco, equality: <" + std::string(name) + "> is not supported yet",
                                 "supported: <joint> with a linear polycoef, <connect body1 body2 anchor>");
      }
    }
  }

  // The second body is the world if it is left out.
  void read_connect(const FileNode& element) {
    const std::string what = "mujoco, equality, " + name_in_messages(element);
    refuse_other_attributes(element, what, {"name", "class", "active", "body1", "body2", "anchor", "solref", "solimp"},
                            values_);
    Loop loop;
    loop.place = element.place;
    loop.name = element.value("name");
    loop.is_marked = loop.meets_at_zero = true;
    loop.links = {Reference{element.value("body1"), loop.place},
                  Reference{element.has("body2") ? element.value("body2") : root_link(), loop.place}};
    values_.required_text(element, "anchor", what);
    loop.points[0] = values_.vector(element, "anchor", what).value_or(zero_vector());
    for (const Reference& link : loop.links) {
      if (!find_link(robot_, link, what, diagnostics_)) return;
    }
    robot_.loops.push_back(std::move(loop));
  }

  std::string root_link() const {
    for (std::size_t l = 0; l < robot_.links.size(); ++l) {
      const bool is_child = std::any_of(robot_.joints.begin(), robot_.joints.end(),
                                        [l](const Joint& joint) { return joint.child == static_cast<int>(l); });
      if (!is_child) return robot_.links[l].name;
    }
    return "";
  }

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  Robot& robot_;
};

}  // namespace

void read_urdf_loops(const FileNode& root, const UrdfValues& values, Robot& robot) {
  LoopReader(values, robot).read(root);
}

}  // namespace flatdyn
