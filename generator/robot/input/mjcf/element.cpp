// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/element.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "robot/input/common/xml_document.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

class TreeReader {
 public:
  TreeReader(const std::string& file, ReadContext& context, Robot& robot)
      : folder_(std::filesystem::path(file).parent_path()), context_(context), robot_(robot) {}

  MjcfElement read(const XMLElement& root, const std::string& file) {
    files_.push_back(file);
    MjcfElement tree = element_of(root, file);
    read_children(root, file, tree);
    return tree;
  }

  void tell_of_ignored() {
    for (const std::string& name : context_.options.ignored) {
      const auto found = ignored_.find(name);
      if (found == ignored_.end()) {
        context_.diagnostics.note({robot_.file, 0}, "--ignore " + name + " has no effect: nothing is called so",
                                  "name an element or an attribute of the file");
      } else {
        const int count = found->second.count;
        context_.diagnostics.note(found->second.first,
                                  name + ": left out here" +
                                      (count > 1 ? ", and in " + std::to_string(count - 1) + " more places" : "") +
                                      ", by --ignore",
                                  "the robot is computed without it");
      }
    }
  }

 private:
  struct Ignored {
    Place first;
    int count = 0;
  };

  bool is_ignored(const std::string& name, const Place& place) {
    const std::vector<std::string>& names = context_.options.ignored;
    if (std::find(names.begin(), names.end(), name) == names.end()) return false;
    Ignored& ignored = ignored_.emplace(name, Ignored{place, 0}).first->second;
    ++ignored.count;
    return true;
  }

  MjcfElement element_of(const XMLElement& read, const std::string& file) {
    MjcfElement element;
    element.name = read.Name();
    element.place = {file, read.GetLineNum()};
    for (const tinyxml2::XMLAttribute* a = read.FirstAttribute(); a != nullptr; a = a->Next()) {
      const Place place{file, a->GetLineNum()};
      if (!is_ignored(a->Name(), place)) element.attributes.push_back({a->Name(), a->Value(), place});
    }
    return element;
  }

  void read_children(const XMLElement& read, const std::string& file, MjcfElement& element) {
    for (const XMLElement* child = read.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      const std::string name = child->Name();
      if (name == "include") {
        include(*child, file, element);
      } else if (!is_ignored(name, {file, child->GetLineNum()})) {
        element.children.push_back(element_of(*child, file));
        read_children(*child, file, element.children.back());
      }
    }
  }

  // The path is relative to the main file or, if no file is there, to the file that includes it.
  void include(const XMLElement& element, const std::string& file, MjcfElement& parent) {
    const Place place{file, element.GetLineNum()};
    const char* name = element.Attribute("file");
    if (name == nullptr || *name == '\0') {
      context_.diagnostics.error(place, "<include> names no file", "write <include file=\"...\"/>");
      return;
    }
    std::error_code error;
    const std::filesystem::path beside = std::filesystem::path(file).parent_path() / name;
    const bool is_beside =
        !std::filesystem::is_regular_file(folder_ / name, error) && std::filesystem::is_regular_file(beside, error);
    const std::string path = (is_beside ? beside : folder_ / name).string();
    if (!can_be_included(path, place)) return;
    const std::optional<std::string> text = file_text(path, context_.diagnostics);
    if (!text) return;
    robot_.files.push_back(path);
    files_.push_back(path);
    tinyxml2::XMLDocument document;
    const XMLElement* included = parse_xml(*text, path, kMjcfForm, context_.diagnostics, document);
    if (included != nullptr) read_children(*included, path, parent);
  }

  bool can_be_included(const std::string& path, const Place& place) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
      context_.diagnostics.error(
          place, "<include>: there is no file \"" + path + "\"",
          "the path is relative to the folder of the main file, or to that of the file that includes it");
      return false;
    }
    const bool was_read = std::any_of(files_.begin(), files_.end(), [&](const std::string& read) {
      return std::filesystem::equivalent(read, path, error);
    });
    if (!was_read) return true;
    context_.diagnostics.error(place, "<include>: \"" + path + "\" is included already",
                               "a file can be included once only");
    return false;
  }

  std::filesystem::path folder_;
  ReadContext& context_;
  Robot& robot_;
  std::map<std::string, Ignored> ignored_;
  std::vector<std::string> files_;  // that were read
};

}  // namespace

const MjcfAttribute* MjcfElement::attribute(std::string_view attribute_name) const {
  for (const MjcfAttribute& each : attributes) {
    if (each.name == attribute_name) return &each;
  }
  return nullptr;
}

std::string MjcfElement::text(std::string_view attribute_name) const {
  const MjcfAttribute* found = attribute(attribute_name);
  return found == nullptr ? "" : found->text;
}

std::vector<const MjcfElement*> MjcfElement::elements(std::string_view element_name) const {
  std::vector<const MjcfElement*> found;
  for (const MjcfElement& child : children) {
    if (child.name == element_name) found.push_back(&child);
  }
  return found;
}

std::string name_in_messages(const MjcfElement& element) {
  const std::string name = element.text("name");
  return element.name + (name.empty() ? "" : " \"" + name + "\"");
}

MjcfElement mjcf_tree(const XMLElement& root, const std::string& file, ReadContext& context, Robot& robot) {
  TreeReader reader(file, context, robot);
  MjcfElement tree = reader.read(root, file);
  reader.tell_of_ignored();
  return tree;
}

std::optional<MjcfElement> mjcf_tree_of_file(const std::string& file, ReadContext& context, Robot& robot) {
  const std::optional<std::string> text = file_text(file, context.diagnostics);
  if (!text) return std::nullopt;
  robot.files.push_back(file);
  tinyxml2::XMLDocument document;
  const XMLElement* root = parse_xml(*text, file, kMjcfForm, context.diagnostics, document);
  if (root == nullptr || refuse_content_beside(*root, file, kMjcfForm, context.diagnostics)) return std::nullopt;
  if (std::string_view(root->Name()) != "mujoco") {
    context.diagnostics.error({file, root->GetLineNum()},
                              "the model is not an MJCF file, but <" + std::string(root->Name()) + ">",
                              "name an MJCF file");
    return std::nullopt;
  }
  return TreeReader(file, context, robot).read(*root, file);
}

}  // namespace flatdyn
