// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/element.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

namespace flatdyn {

namespace {

class TreeReader {
 public:
  TreeReader(const std::string& file, ReadContext& context, Robot& robot)
      : folder_(std::filesystem::path(file).parent_path()), context_(context), robot_(robot), files_({file}) {}

  FileNode read(const FileNode& root) {
    FileNode tree = without_children(root);
    add_children(root, tree);
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

  FileNode without_children(const FileNode& read) {
    FileNode element{read.name, {}, {}, read.place, read.text};
    for (const FileAttribute& each : read.attributes) {
      if (!is_ignored(each.name, each.place)) element.attributes.push_back(each);
    }
    return element;
  }

  void add_children(const FileNode& read, FileNode& element) {
    for (const FileNode& child : read.children) {
      if (child.name == "include") {
        include(child, element);
      } else if (!is_ignored(child.name, child.place)) {
        element.children.push_back(without_children(child));
        add_children(child, element.children.back());
      }
    }
  }

  // The path is relative to the main file or, if no file is there, to the file that includes it.
  void include(const FileNode& element, FileNode& parent) {
    const std::string name = element.value("file");
    if (name.empty()) {
      context_.diagnostics.error(element.place, "<include> names no file", "write <include file=\"...\"/>");
      return;
    }
    std::error_code error;
    const std::filesystem::path beside = std::filesystem::path(element.place.file).parent_path() / name;
    const bool is_beside =
        !std::filesystem::is_regular_file(folder_ / name, error) && std::filesystem::is_regular_file(beside, error);
    const std::string path = (is_beside ? beside : folder_ / name).string();
    if (!can_be_included(path, element.place)) return;
    const std::optional<std::string> text = file_text(path, context_.diagnostics);
    if (!text) return;
    robot_.files.push_back(path);
    files_.push_back(path);
    const std::optional<XmlDocument> included = parse_xml(*text, path, kMjcfForm, context_.diagnostics);
    if (included) add_children(included->root, parent);
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

FileNode mjcf_tree(const FileNode& root, ReadContext& context, Robot& robot) {
  TreeReader reader(root.place.file, context, robot);
  FileNode tree = reader.read(root);
  reader.tell_of_ignored();
  return tree;
}

std::optional<FileNode> mjcf_tree_of_file(const std::string& file, ReadContext& context, Robot& robot) {
  const std::optional<std::string> text = file_text(file, context.diagnostics);
  if (!text) return std::nullopt;
  robot.files.push_back(file);
  const std::optional<XmlDocument> document = parse_xml(*text, file, kMjcfForm, context.diagnostics);
  if (!document || refuse_content_beside(*document, kMjcfForm, context.diagnostics)) return std::nullopt;
  if (document->root.name != "mujoco") {
    context.diagnostics.error(document->root.place, "the model is not an MJCF file, but <" + document->root.name + ">",
                              "name an MJCF file");
    return std::nullopt;
  }
  return TreeReader(file, context, robot).read(document->root);
}

}  // namespace flatdyn
