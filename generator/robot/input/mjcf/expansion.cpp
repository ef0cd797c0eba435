// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/expansion.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "robot/input/mjcf/attachment.hpp"
#include "robot/input/mjcf/names.hpp"
#include "robot/input/mjcf/replication.hpp"
#include "robot/input/mjcf/settings.hpp"

namespace flatdyn {

namespace {

namespace fs = std::filesystem;

// Another model, which <asset> names.
struct OtherModel {
  FileNode root;
  std::string mesh_folder;
};

MjcfSettings settings_of(FileNode root, ReadContext& context) {
  std::erase_if(root.children, [](const FileNode& child) { return child.name == "option"; });
  const MjcfDefaults defaults(root, context.diagnostics);
  Robot none;
  return mjcf_settings(root, MjcfValues(defaults, context), none);
}

class Expander {
 public:
  // around: the files that attach this one.
  Expander(FileNode& root, const std::string& file, ReadContext& context, Robot& robot,
           const std::vector<std::string>& around)
      : root_(root), file_(file), context_(context), robot_(robot), files_(around) {
    files_.push_back(file);
  }

  void expand() {
    for (const char* section : kMjcfSections) {
      if (root_.elements(section).empty()) root_.children.push_back({section, {}, {}, root_.place});
    }
    for (FileNode& child : root_.children) {
      if (child.name == "worldbody") expand(child);
    }
  }

 private:
  void expand(FileNode& element) {
    for (FileNode& child : element.children) {
      if (child.name == "attach") {
        attach(child);
      } else {
        expand(child);
      }
    }
    if (element.name == "replicate") replicate_mjcf(element, root_, context_.diagnostics, copied_);
  }

  void attach(FileNode& element) {
    const FileAttribute* model = element.attribute("model");
    if (model == nullptr) {
      context_.diagnostics.unsupported(element.place, "<attach> of a part of the model itself is not supported",
                                       "name a model of <asset>: model=\"...\"");
      element = {"frame", {}, {}, element.place};
      return;
    }
    if (const OtherModel* other = find_model(*model)) {
      attach_mjcf(element, other->root, other->mesh_folder, root_, context_.diagnostics);
    } else {
      element = {"frame", {}, {}, element.place};
    }
  }

  // The model of this name in <asset>; nullptr, and an error, if there is none that can be attached.
  const OtherModel* find_model(const FileAttribute& name) {
    for (const FileNode* assets : root_.elements("asset")) {
      for (const FileNode* asset : assets->elements("model")) {
        const FileAttribute* own_name = asset->attribute("name");
        if (own_name != nullptr && own_name->text != name.text) continue;
        const OtherModel* model = load(*asset);
        if (model == nullptr) return nullptr;
        if (own_name != nullptr || model->root.value("model") == name.text) return model;
      }
    }
    context_.diagnostics.error(name.place, "<attach>: there is no model \"" + name.text + "\"",
                               "name a <model> of <asset>");
    return nullptr;
  }

  const OtherModel* load(const FileNode& asset) {
    const FileAttribute* written = asset.attribute("file");
    if (written == nullptr || written->text.empty()) {
      context_.diagnostics.error(asset.place, name_in_messages(asset) + " names no file", "write file=\"...\"");
      return nullptr;
    }
    const std::string path = (fs::path(file_).parent_path() / written->text).string();
    const auto known = models_.find(path);
    if (known != models_.end()) return known->second ? &*known->second : nullptr;
    std::optional<OtherModel>& model = models_[path];
    model = read(path, *written);
    return model ? &*model : nullptr;
  }

  std::optional<OtherModel> read(const std::string& path, const FileAttribute& written) {
    const std::string what = "model \"" + written.text + "\"";
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
      context_.diagnostics.error(written.place, what + ": there is no file \"" + path + "\"",
                                 "the path is relative to the folder of the file that names it");
      return std::nullopt;
    }
    if (std::any_of(files_.begin(), files_.end(),
                    [&](const std::string& around) { return fs::equivalent(around, path, error); })) {
      context_.diagnostics.error(written.place, what + ": a model cannot attach itself", "name another file");
      return std::nullopt;
    }
    std::optional<FileNode> root = mjcf_tree_of_file(path, context_, robot_);
    if (!root) return std::nullopt;
    check_mjcf_names(*root, context_.diagnostics);
    const MjcfSettings settings = settings_of(*root, context_);
    if (!has_same_settings(settings, what, written.place)) return std::nullopt;
    if (!root->elements("option").empty()) {
      context_.diagnostics.note(root->elements("option").front()->place,
                                what + ": the <option> of a model that is attached is not read",
                                "that of the main file holds", "options of models that are attached");
    }
    Expander(*root, path, context_, robot_, files_).expand();
    return OtherModel{*root, (fs::path(path).parent_path() / settings.mesh_folder).string()};
  }

  bool has_same_settings(const MjcfSettings& other, const std::string& what, const Place& place) {
    if (!settings_) settings_ = settings_of(root_, context_);
    const std::string difference = mjcf_difference(*settings_, other);
    if (difference.empty()) return true;
    context_.diagnostics.unsupported(
        place, what + ": its <compiler> has another " + difference + " than this file's, which is not supported",
        "write both files for the same <compiler>: their numbers change with it");
    return false;
  }

  FileNode& root_;
  std::string file_;
  ReadContext& context_;
  Robot& robot_;
  std::vector<std::string> files_;
  std::map<std::string, std::optional<OtherModel>> models_;
  std::optional<MjcfSettings> settings_;
  std::size_t copied_ = 0;
};

}  // namespace

void expand_mjcf(FileNode& root, const std::string& file, ReadContext& context, Robot& robot) {
  Expander(root, file, context, robot, {}).expand();
}

}  // namespace flatdyn
