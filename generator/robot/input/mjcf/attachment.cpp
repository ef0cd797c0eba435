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

void set_attribute(FileNode& element, const std::string& name, const std::string& text) {
  for (FileAttribute& attribute : element.attributes) {
    if (attribute.name != name) continue;
    attribute.text = text;
    return;
  }
  element.attributes.push_back({name, text, element.place});
}

// An element in a model, under the nearest childclass around it.
struct NamedElement {
  const FileNode* element = nullptr;
  std::string class_name;
};

NamedElement find_named(const FileNode& in, const std::string& kind, const std::string& name,
                        const std::string& around) {
  for (const FileNode& child : in.children) {
    if (child.name == kind && child.value("name") == name) return {&child, around};
    const FileAttribute* own = child.attribute("childclass");
    const NamedElement found = find_named(child, kind, name, own == nullptr ? around : own->text);
    if (found.element != nullptr) return found;
  }
  return {};
}

// The joints of a body and of those in it, in the order of MuJoCo's q.
void add_joints_of_body(const FileNode& body, std::vector<const FileNode*>& joints);

void add_joints_in(const FileNode& element, std::vector<const FileNode*>& joints,
                   std::vector<const FileNode*>& bodies) {
  for (const FileNode& child : element.children) {
    if (child.name == "joint" || child.name == "freejoint") {
      joints.push_back(&child);
    } else if (child.name == "body") {
      bodies.push_back(&child);
    } else {
      add_joints_in(child, joints, bodies);
    }
  }
}

void add_joints_of_body(const FileNode& body, std::vector<const FileNode*>& joints) {
  std::vector<const FileNode*> bodies;
  add_joints_in(body, joints, bodies);
  for (const FileNode* child : bodies) add_joints_of_body(*child, joints);
}

class Attachment {
 public:
  Attachment(FileNode& attach, const FileNode& other, const std::string& folder, FileNode& root,
             Diagnostics& diagnostics)
      : attach_(attach),
        other_(other),
        folder_(folder),
        root_(root),
        diagnostics_(diagnostics),
        prefix_(attach.value("prefix")) {}

  void apply() {
    FileNode frame{"frame", {}, {}, attach_.place};
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
  bool fill(FileNode& frame) {
    for (const char* kind : {"body", "frame"}) {
      const FileAttribute* name = attach_.attribute(kind);
      if (name == nullptr) continue;
      NamedElement found;
      for (const FileNode* world : other_.elements("worldbody")) {
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
    for (const FileNode* world : other_.elements("worldbody"))
      frame.children.insert(frame.children.end(), world->children.begin(), world->children.end());
    return true;
  }

  FileNode& section(const std::string& name) {
    return *std::find_if(root_.children.begin(), root_.children.end(),
                         [&name](const FileNode& each) { return each.name == name; });
  }

  // The names of classes and meshes in an element, which MjcfRenaming leaves.
  void rename_classes(FileNode& element) const {
    for (FileAttribute& attribute : element.attributes) {
      const bool is_name = attribute.name == "class" || attribute.name == "childclass" || attribute.name == "mesh";
      if (is_name) attribute.text = prefix_ + attribute.text;
    }
    for (FileNode& child : element.children) rename_classes(child);
  }

  void add_defaults() {
    FileNode outermost{"default", {}, {}, other_.place};
    for (const FileNode* defaults : other_.elements("default")) {
      outermost.place = defaults->place;
      outermost.children.insert(outermost.children.end(), defaults->children.begin(), defaults->children.end());
    }
    set_attribute(outermost, "class", kMainClass);
    add_default(outermost);
    for (const FileNode* attached : other_.elements(kMjcfAttachedDefaults)) {
      for (const FileNode& defaults : attached->children) add_default(defaults);
    }
  }

  void add_default(FileNode defaults) {
    rename_classes(defaults);
    section(kMjcfAttachedDefaults).children.push_back(defaults);
  }

  void add_meshes() {
    for (const FileNode* assets : other_.elements("asset")) {
      for (const FileNode* asset : assets->elements("mesh")) {
        FileNode mesh = *asset;
        const std::string file = mesh.value("file");
        if (mesh.value("name").empty()) set_attribute(mesh, "name", fs::path(file).stem().string());
        if (!file.empty()) set_attribute(mesh, "file", fs::absolute(fs::path(folder_) / file).string());
        add_renamed(mesh, "asset");
      }
    }
  }

  void add_renamed(FileNode element, const char* to) {
    if (element.attribute("class") == nullptr) set_attribute(element, "class", kMainClass);
    rename_classes(element);
    rename_mjcf(element, prefixed(), true);
    section(to).children.push_back(element);
  }

  // A part of a model comes with what acts on that part alone.
  void add_section(const char* name) {
    for (const FileNode* holder : other_.elements(name)) {
      for (const FileNode& child : holder->children) {
        const MjcfReferences found = mjcf_references(child, names_);
        if (is_part_ && (found.inside == 0 || found.outside > 0)) continue;
        if (child.name == "fixed" || child.name == "spatial") names_["tendon"].insert(child.value("name"));
        add_renamed(child, name);
      }
    }
  }

  // The model's keyframes, by joint: <key name><joint name qpos/></key>.
  void add_keys() {
    std::vector<const FileNode*> joints;
    for (const FileNode* world : other_.elements("worldbody")) add_joints_of_body(*world, joints);
    for (const FileNode* holder : other_.elements("keyframe")) {
      for (const FileNode* key : holder->elements("key")) {
        if (!key->value("name").empty()) section("keyframe").children.push_back(by_joint(*key, joints));
      }
    }
  }

  FileNode by_joint(const FileNode& key, const std::vector<const FileNode*>& joints) const {
    FileNode found{"key", {{"name", prefix_ + key.value("name"), key.place}}, {}, key.place};
    for (const FileNode& joint : key.children) add_position(joint.value("name"), joint.value("qpos"), found);
    const std::vector<std::string> positions = words_of(key.value("qpos"));
    std::size_t next = 0;
    for (const FileNode* joint : joints) {
      const std::string type = joint->name == "freejoint" ? "free" : joint->value("type");
      const std::size_t count = type == "free" ? 7 : type == "ball" ? 4 : 1;
      if (count == 1 && next < positions.size()) add_position(joint->value("name"), positions[next], found);
      next += count;
    }
    if (next != positions.size() && key.children.empty()) found.children.clear();
    return found;
  }

  void add_position(const std::string& joint, const std::string& position, FileNode& key) const {
    const auto known = names_.find("joint");
    if (known == names_.end() || known->second.count(joint) == 0) return;
    key.children.push_back(
        {"joint", {{"name", prefix_ + joint, key.place}, {"qpos", position, key.place}}, {}, key.place});
  }

  FileNode& attach_;
  const FileNode& other_;
  std::string folder_;
  FileNode& root_;
  Diagnostics& diagnostics_;
  std::string prefix_;
  MjcfNames names_;
  bool is_part_ = false;
};

}  // namespace

void attach_mjcf(FileNode& attach, const FileNode& other, const std::string& folder, FileNode& root,
                 Diagnostics& diagnostics) {
  Attachment(attach, other, folder, root, diagnostics).apply();
}

}  // namespace flatdyn
