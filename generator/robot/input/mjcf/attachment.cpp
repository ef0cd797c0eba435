// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/attachment.hpp"

#include <algorithm>
#include <filesystem>

#include "robot/input/common/words.hpp"
#include "robot/input/mjcf/defaults.hpp"
#include "robot/input/mjcf/renaming.hpp"

namespace flatdyn {

namespace {

namespace fs = std::filesystem;

void set_attribute(MjcfElement& element, const std::string& name, const std::string& text) {
  for (MjcfAttribute& attribute : element.attributes) {
    if (attribute.name != name) continue;
    attribute.text = text;
    return;
  }
  element.attributes.push_back({name, text, element.place});
}

// An element in a model, under the nearest childclass around it.
struct NamedElement {
  const MjcfElement* element = nullptr;
  std::string class_name;
};

NamedElement find_named(const MjcfElement& in, const std::string& kind, const std::string& name,
                        const std::string& around) {
  for (const MjcfElement& child : in.children) {
    if (child.name == kind && child.text("name") == name) return {&child, around};
    const MjcfAttribute* own = child.attribute("childclass");
    const NamedElement found = find_named(child, kind, name, own == nullptr ? around : own->text);
    if (found.element != nullptr) return found;
  }
  return {};
}

// The joints of a body and of those in it, in the order of MuJoCo's q.
void add_joints_of_body(const MjcfElement& body, std::vector<const MjcfElement*>& joints);

void add_joints_in(const MjcfElement& element, std::vector<const MjcfElement*>& joints,
                   std::vector<const MjcfElement*>& bodies) {
  for (const MjcfElement& child : element.children) {
    if (child.name == "joint" || child.name == "freejoint") {
      joints.push_back(&child);
    } else if (child.name == "body") {
      bodies.push_back(&child);
    } else {
      add_joints_in(child, joints, bodies);
    }
  }
}

void add_joints_of_body(const MjcfElement& body, std::vector<const MjcfElement*>& joints) {
  std::vector<const MjcfElement*> bodies;
  add_joints_in(body, joints, bodies);
  for (const MjcfElement* child : bodies) add_joints_of_body(*child, joints);
}

class Attachment {
 public:
  Attachment(MjcfElement& attach, const MjcfElement& other, const std::string& folder, MjcfElement& root,
             Diagnostics& diagnostics)
      : attach_(attach),
        other_(other),
        folder_(folder),
        root_(root),
        diagnostics_(diagnostics),
        prefix_(attach.text("prefix")) {}

  void apply() {
    MjcfElement frame{"frame", {}, {}, attach_.place};
    if (attach_.attribute("prefix") == nullptr) {
      diagnostics_.error(attach_.place, "<attach> has no prefix", "write prefix=\"...\" before the model's names");
    } else if (fill(frame)) {
      names_ = mjcf_names_in(frame);
      add_defaults();
      add_meshes();
      for (const char* section : {"tendon", "equality", "actuator"}) add_section(section);
      add_keys();
      rename_classes(frame);
      rename_mjcf(frame, prefixed(), false);
    }
    attach_ = frame;
  }

 private:
  MjcfRenaming prefixed() const {
    return [this](const std::string& name) { return name.empty() ? name : prefix_ + name; };
  }

  // False, and an error, if what is to be attached is not there.
  bool fill(MjcfElement& frame) {
    for (const char* kind : {"body", "frame"}) {
      const MjcfAttribute* name = attach_.attribute(kind);
      if (name == nullptr) continue;
      NamedElement found;
      for (const MjcfElement* world : other_.elements("worldbody")) {
        if (found.element == nullptr) found = find_named(*world, kind, name->text, kMainClass);
      }
      if (found.element == nullptr) {
        diagnostics_.error(name->place, "<attach>: the model has no " + std::string(kind) + " \"" + name->text + "\"",
                           "check the name");
        return false;
      }
      set_attribute(frame, "childclass", found.class_name);
      frame.children.push_back(*found.element);
      is_part_ = true;
      return true;
    }
    set_attribute(frame, "childclass", kMainClass);
    for (const MjcfElement* world : other_.elements("worldbody"))
      frame.children.insert(frame.children.end(), world->children.begin(), world->children.end());
    return true;
  }

  MjcfElement& section(const std::string& name) {
    return *std::find_if(root_.children.begin(), root_.children.end(),
                         [&name](const MjcfElement& each) { return each.name == name; });
  }

  // The names of classes and meshes in an element, which MjcfRenaming leaves.
  void rename_classes(MjcfElement& element) const {
    for (MjcfAttribute& attribute : element.attributes) {
      const bool is_name = attribute.name == "class" || attribute.name == "childclass" || attribute.name == "mesh";
      if (is_name) attribute.text = prefix_ + attribute.text;
    }
    for (MjcfElement& child : element.children) rename_classes(child);
  }

  void add_defaults() {
    MjcfElement outermost{"default", {}, {}, other_.place};
    for (const MjcfElement* defaults : other_.elements("default")) {
      outermost.place = defaults->place;
      outermost.children.insert(outermost.children.end(), defaults->children.begin(), defaults->children.end());
    }
    set_attribute(outermost, "class", kMainClass);
    add_default(outermost);
    for (const MjcfElement* attached : other_.elements(kMjcfAttachedDefaults)) {
      for (const MjcfElement& defaults : attached->children) add_default(defaults);
    }
  }

  void add_default(MjcfElement defaults) {
    rename_classes(defaults);
    section(kMjcfAttachedDefaults).children.push_back(defaults);
  }

  void add_meshes() {
    for (const MjcfElement* assets : other_.elements("asset")) {
      for (const MjcfElement* asset : assets->elements("mesh")) {
        MjcfElement mesh = *asset;
        const std::string file = mesh.text("file");
        if (mesh.text("name").empty()) set_attribute(mesh, "name", fs::path(file).stem().string());
        if (!file.empty()) set_attribute(mesh, "file", fs::absolute(fs::path(folder_) / file).string());
        add_renamed(mesh, "asset");
      }
    }
  }

  void add_renamed(MjcfElement element, const char* to) {
    if (element.attribute("class") == nullptr) set_attribute(element, "class", kMainClass);
    rename_classes(element);
    rename_mjcf(element, prefixed(), true);
    section(to).children.push_back(element);
  }

  // A part of a model comes with what acts on that part alone.
  void add_section(const char* name) {
    for (const MjcfElement* holder : other_.elements(name)) {
      for (const MjcfElement& child : holder->children) {
        const MjcfReferences found = mjcf_references(child, names_);
        if (is_part_ && (found.inside == 0 || found.outside > 0)) continue;
        if (child.name == "fixed" || child.name == "spatial") names_["tendon"].insert(child.text("name"));
        add_renamed(child, name);
      }
    }
  }

  // The model's keyframes, by joint: <key name><joint name qpos/></key>.
  void add_keys() {
    std::vector<const MjcfElement*> joints;
    for (const MjcfElement* world : other_.elements("worldbody")) add_joints_of_body(*world, joints);
    for (const MjcfElement* holder : other_.elements("keyframe")) {
      for (const MjcfElement* key : holder->elements("key")) {
        if (!key->text("name").empty()) section("keyframe").children.push_back(by_joint(*key, joints));
      }
    }
  }

  MjcfElement by_joint(const MjcfElement& key, const std::vector<const MjcfElement*>& joints) const {
    MjcfElement found{"key", {{"name", prefix_ + key.text("name"), key.place}}, {}, key.place};
    for (const MjcfElement& joint : key.children) add_position(joint.text("name"), joint.text("qpos"), found);
    const std::vector<std::string> positions = words_of(key.text("qpos"));
    std::size_t next = 0;
    for (const MjcfElement* joint : joints) {
      const std::string type = joint->name == "freejoint" ? "free" : joint->text("type");
      const std::size_t count = type == "free" ? 7 : type == "ball" ? 4 : 1;
      if (count == 1 && next < positions.size()) add_position(joint->text("name"), positions[next], found);
      next += count;
    }
    if (next != positions.size() && key.children.empty()) found.children.clear();
    return found;
  }

  void add_position(const std::string& joint, const std::string& position, MjcfElement& key) const {
    const auto known = names_.find("joint");
    if (known == names_.end() || known->second.count(joint) == 0) return;
    key.children.push_back(
        {"joint", {{"name", prefix_ + joint, key.place}, {"qpos", position, key.place}}, {}, key.place});
  }

  MjcfElement& attach_;
  const MjcfElement& other_;
  std::string folder_;
  MjcfElement& root_;
  Diagnostics& diagnostics_;
  std::string prefix_;
  MjcfNames names_;
  bool is_part_ = false;
};

}  // namespace

void attach_mjcf(MjcfElement& attach, const MjcfElement& other, const std::string& folder, MjcfElement& root,
                 Diagnostics& diagnostics) {
  Attachment(attach, other, folder, root, diagnostics).apply();
}

}  // namespace flatdyn
