// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/bodies.hpp"

#include <algorithm>

#include "robot/input/common/poses.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/mjcf/inertials.hpp"
#include "robot/input/mjcf/joints.hpp"
#include "robot/input/mjcf/names.hpp"

namespace flatdyn {

namespace {

// Where elements stand: the nearest class for children, and the frames around them.
struct Surroundings {
  std::string class_name = kMainClass;
  Pose frame;  // in the body's frame
};

// The elements that a body has in itself and in its frames.
struct Contents {
  struct Child {
    const FileNode* element;
    Surroundings around;
  };
  std::vector<MjcfJoint> joints;
  std::vector<MjcfGeom> geoms;
  std::vector<Child> inertials, sites, bodies;
};

void collect_names(const FileNode& element, const std::string& of, std::vector<std::string>& names) {
  for (const FileNode& child : element.children) {
    const bool is_one = child.name == of || (of == "joint" && child.name == "freejoint");
    if (is_one && !child.value("name").empty()) names.push_back(child.value("name"));
    collect_names(child, of, names);
  }
}

class BodyReader {
 public:
  explicit BodyReader(MjcfModel& model) : model_(model), values_(model.values), robot_(model.robot) {}

  void read() {
    model_.builder.world(model_.root.place);
    model_.names_of_bodies.push_back("world");
    for (const FileNode* world : model_.root.elements("worldbody")) {
      collect_names(*world, "joint", model_.names_of_joints);
      collect_names(*world, "body", model_.names_of_bodies);
    }
    for (const FileNode* world : model_.root.elements("worldbody")) {
      robot_.links[0].place = world->place;
      read_contents(*world, -1, class_for_children(*world, kMainClass));
    }
  }

 private:
  std::string class_for_children(const FileNode& element, const std::string& around) const {
    const FileAttribute* own = element.attribute("childclass");
    if (own == nullptr) return around;
    if (values_.defaults().has_class(own->text)) return own->text;
    report_missing_name(*own, name_in_messages(element), "class", values_.defaults().names(), model_.diagnostics());
    return around;
  }

  void collect(const FileNode& element, const Surroundings& around, Contents& contents) {
    for (const FileNode& child : element.children) {
      if (child.name == "joint" || child.name == "freejoint") {
        contents.joints.push_back({&child, around.class_name, around.frame});
      } else if (child.name == "geom") {
        contents.geoms.push_back({&child, around.class_name, around.frame});
      } else if (child.name == "inertial") {
        contents.inertials.push_back({&child, around});
      } else if (child.name == "site") {
        contents.sites.push_back({&child, around});
      } else if (child.name == "body") {
        contents.bodies.push_back({&child, around});
      } else if (child.name == "frame") {
        const Pose pose = mjcf_pose(MjcfValues::plain(child), values_, model_.settings);
        collect(child, {class_for_children(child, around.class_name), joined(around.frame, pose)}, contents);
      } else if (child.name == "replicate") {
        collect_copies(child, {class_for_children(child, around.class_name), around.frame}, contents);
      } else {
        refuse_kind(child);
      }
    }
  }

  // Copy k is turned by k times the angles of euler. It stands one offset, in the axes of the copy before, from that.
  void collect_copies(const FileNode& replicate, const Surroundings& around, Contents& contents) {
    const MjcfItem item = MjcfValues::plain(replicate);
    const Vec3 offset = values_.length_vector(item, "offset");
    const Pose turn{mjcf_orientation(item, values_, model_.settings), replicate.place};
    Vec3 position = zero_vector();
    int number = 0;
    for (const FileNode& copy : replicate.children) {
      Pose turned = turn;
      for (Displacement& each : turned.displacements) each.angle *= number;
      const Pose pose = joined({{translation(position)}, replicate.place}, turned);
      collect(copy, {around.class_name, joined(around.frame, pose)}, contents);
      position = expanded(position + exact_place(turned).R * offset);
      ++number;
    }
  }

  void refuse_kind(const FileNode& element) {
    for (const char* kind : {"composite", "flexcomp", "plugin"}) {
      if (element.name != kind) continue;
      refuse_mjcf(element.place, "<" + element.name + "> is not supported", kind, values_);
    }
  }

  void read_body(const Contents::Child& child, int parent) {
    const FileNode& element = *child.element;
    MjcfBody body;
    body.element = &element;
    body.parent = parent;
    body.pose = joined(child.around.frame, mjcf_pose(MjcfValues::plain(element), values_, model_.settings));
    tell_of_forces(element);
    model_.bodies.push_back(body);
    read_contents(element, static_cast<int>(model_.bodies.size()) - 1,
                  class_for_children(element, child.around.class_name));
  }

  void tell_of_forces(const FileNode& element) {
    if (element.value("mocap") == "true") {
      model_.diagnostics().note(element.place, name_in_messages(element) + ": mocap is not read: the body stands still",
                                "a joint moves a body", "bodies that motion capture moves");
    }
    const FileAttribute* gravcomp = element.attribute("gravcomp");
    const bool is_weightless = vanishes(dot(robot_.gravity, robot_.gravity));
    if (gravcomp == nullptr || is_zero_text(gravcomp->text) || is_weightless) return;
    model_.diagnostics().note(
        gravcomp->place,
        name_in_messages(element) + ", gravcomp=\"" + gravcomp->text +
            "\": the force that carries its weight is not read: gravity acts on it in full",
        "it is like an actuator's: take it off the torques; where all bodies have gravcomp=\"1\", a scene with gravity "
        "= [0, 0, 0] does",
        "bodies whose weight gravcomp carries");
  }

  std::string name_of_body(const FileNode& element) {
    const std::string name = element.value("name");
    return name.empty() ? new_body_name("body" + std::to_string(model_.bodies.size()), model_) : name;
  }

  // body: its index, or -1 of the world.
  void read_contents(const FileNode& element, int body, const std::string& class_name) {
    Contents contents;
    collect(element, {class_name, {}}, contents);
    const bool is_world = body < 0;
    if (is_world) {
      for (const MjcfJoint& joint : contents.joints) {
        model_.diagnostics().error(joint.element->place, "the world has a <" + joint.element->name + ">",
                                   "write it in the body that moves");
      }
    } else {
      read_joints(element, contents, body);
    }
    for (const Contents::Child& site : contents.sites) read_site(site, is_world ? 0 : model_.bodies[at(body)].link);
    for (const Contents::Child& child : contents.bodies) read_body(child, body);
  }

  void read_joints(const FileNode& element, const Contents& contents, int index) {
    MjcfBody body = model_.bodies[at(index)];
    const std::string name = name_of_body(element);
    const int parent = body.parent;
    add_mjcf_joints(contents.joints, name, parent < 0 ? 0 : model_.bodies[at(parent)].link, model_, body);
    const bool has_joint = std::any_of(body.joints.begin(), body.joints.end(),
                                       [this](int j) { return robot_.joints[at(j)].type != JointType::fixed; });
    body.moves = has_joint || !body.free_joints.empty() || (parent >= 0 && model_.bodies[at(parent)].moves);
    body.geoms = contents.geoms;
    if (contents.inertials.size() > 1) {
      model_.diagnostics().error(contents.inertials[1].element->place, "body \"" + name + "\" has two <inertial>",
                                 "keep one");
    }
    if (!contents.inertials.empty()) {
      const Contents::Child& inertial = contents.inertials.front();
      body.inertial = mjcf_inertial(*inertial.element, inertial.around.frame, name, body.moves, model_);
    }
    model_.body_of_name.emplace(name, index);
    model_.bodies[at(index)] = body;
  }

  void read_site(const Contents::Child& site, int link) {
    const std::string name = site.element->value("name");
    if (name.empty()) return;
    const MjcfItem item = values_.item(*site.element, site.around.class_name);
    model_.sites[name] = {link, joined(site.around.frame, mjcf_pose(item, values_, model_.settings))};
  }

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  MjcfModel& model_;
  const MjcfValues& values_;
  Robot& robot_;
};

}  // namespace

void read_mjcf_bodies(MjcfModel& model) { BodyReader(model).read(); }

}  // namespace flatdyn
