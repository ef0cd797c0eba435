// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "robot/input/common/words.hpp"
#include "robot/input/common/xml_document.hpp"

namespace flatdyn {

namespace {

namespace fs = std::filesystem;

constexpr int kOldestMinor = 4, kNewestMinor = 11;
constexpr const char* kIncludeHint =
    "write the path of a folder with model.config, or of an .sdf file, relative to this file; or put in what it names";

const XmlForm kSdfForm = {".sdf", "an SDF file is <sdf version=\"1.9\"> <model name=\"...\"> ... </model> </sdf>"};

// 7 of "1.7" and "1.7.0"; -1 of what is no such version.
int minor_version(const std::string& text) {
  const std::size_t point = text.find('.');
  if (text.substr(0, point) != "1" || point == std::string::npos) return -1;
  const std::string minor = text.substr(point + 1, text.find('.', point + 1) - point - 1);
  const bool is_number = !minor.empty() && minor.size() <= 2 &&
                         std::all_of(minor.begin(), minor.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_number ? std::stoi(minor) : -1;
}

std::optional<int> read_version(const FileNode& root, Diagnostics& diagnostics) {
  const FileAttribute* version = root.attribute("version");
  if (version == nullptr) {
    diagnostics.error(root.place, "<sdf> has no version: what poses and axes are relative to depends on it",
                      "write <sdf version=\"1.9\"> or whatever version the file is in");
    return std::nullopt;
  }
  const int minor = minor_version(version->text);
  if (minor >= kOldestMinor && minor <= kNewestMinor) return minor;
  diagnostics.unsupported(root.place,
                          fmt::format("SDF of version \"{}\" is not supported: 1.4 to 1.11 are", version->text),
                          "convert the file (gz sdf -p FILE), or write a version that says the same");
  return std::nullopt;
}

// The file of a folder's newest version, by its model.config.
std::optional<fs::path> file_of_folder(const fs::path& folder, const Place& place, ReadContext& context) {
  const fs::path config = folder / "model.config";
  const std::optional<std::string> text = file_text(config.string(), context.diagnostics);
  if (!text) return std::nullopt;
  static const XmlForm kConfigForm = {".config", "a model.config is <model> <sdf version=\"...\">FILE</sdf> </model>"};
  const std::optional<XmlDocument> document = parse_xml(*text, config.string(), kConfigForm, context.diagnostics);
  if (!document) return std::nullopt;
  std::string newest;
  int newest_minor = -1;
  for (const FileNode* e : document->root.elements("sdf")) {
    const int minor = e->has("version") ? minor_version(e->value("version")) : 0;
    if (minor <= newest_minor || minor > kNewestMinor) continue;
    newest_minor = minor;
    newest = single_word(e->text);
  }
  if (!newest.empty()) return folder / newest;
  context.diagnostics.error(place, "include: " + config.string() + " names no file in a version up to 1.11",
                            "write <sdf version=\"1.9\">model.sdf</sdf> in it");
  return std::nullopt;
}

// The folders or files that a URI may stand for, from the folder of the file that it is in; none of a network.
std::vector<fs::path> places_of_uri(std::string uri, const fs::path& here) {
  constexpr std::string_view kModel = "model://", kFile = "file://";
  if (uri.starts_with(kModel)) {
    uri.erase(0, kModel.size());
    return {here / uri, here / ".." / uri, here / "models" / uri};
  }
  if (uri.starts_with(kFile)) return {here / uri.substr(kFile.size())};
  return uri.find("://") == std::string::npos ? std::vector{here / uri} : std::vector<fs::path>{};
}

// The first of them that is there; nullopt, and an error, if none is.
std::optional<fs::path> place_of_uri(const Reference& uri, const fs::path& here, Diagnostics& diagnostics) {
  const std::vector<fs::path> candidates = places_of_uri(uri.name, here);
  std::vector<std::string> looked_for;
  for (const fs::path& candidate : candidates) {
    std::error_code error;
    const fs::path place = candidate.lexically_normal();
    if (fs::is_regular_file(place, error) || fs::is_regular_file(place / "model.config", error)) return place;
    const bool is_folder = fs::is_directory(place, error);
    looked_for.push_back(place.string() + (is_folder ? " (a folder without model.config)" : ""));
  }
  if (looked_for.empty()) {
    diagnostics.error(uri.place, "include: \"" + uri.name + "\" is on a network, from which nothing is fetched",
                      "put the model into a folder beside this file, and write its path");
  } else {
    diagnostics.error(uri.place,
                      fmt::format("include: \"{}\" is not found: looked for {}", uri.name, fmt::join(looked_for, ", ")),
                      kIncludeHint);
  }
  return std::nullopt;
}

}  // namespace

const SdfFile* parse_sdf(const std::string& text, const std::string& file, ReadContext& context, SdfTree& tree) {
  std::optional<XmlDocument> document = parse_xml(text, file, kSdfForm, context.diagnostics);
  if (!document) return nullptr;
  if (document->root.name != "sdf") {
    context.diagnostics.error(document->root.place, "the outermost element is <" + document->root.name + ">, not <sdf>",
                              kSdfForm.outline);
    return nullptr;
  }
  if (refuse_content_beside(*document, kSdfForm, context.diagnostics)) return nullptr;
  const std::optional<int> version = read_version(document->root, context.diagnostics);
  if (!version) return nullptr;
  tree.files.push_back(
      std::make_unique<SdfFile>(SdfFile{std::move(document->root), SdfValues(file, *version, context)}));
  return tree.files.back().get();
}

const SdfFile* include_sdf(const FileNode& include, const SdfValues& values, const std::vector<std::string>& stack,
                           SdfTree& tree, Robot& robot) {
  ReadContext& context = values.context();
  const std::optional<Reference> uri = values.name(include, "uri", "include");
  if (!uri) {
    context.diagnostics.error(include.place, "include: it has no <uri>", kIncludeHint);
    return nullptr;
  }
  std::optional<fs::path> path = place_of_uri(*uri, fs::path(values.file()).parent_path(), context.diagnostics);
  if (!path) return nullptr;
  std::error_code error;
  if (fs::is_directory(*path, error)) path = file_of_folder(*path, uri->place, context);
  if (!path) return nullptr;
  if (!fs::is_regular_file(*path, error)) {
    context.diagnostics.error(uri->place, "include: there is no file " + path->string(), kIncludeHint);
    return nullptr;
  }
  const bool goes_round = std::any_of(stack.begin(), stack.end(),
                                      [&](const std::string& each) { return fs::equivalent(each, *path, error); });
  if (goes_round) {
    context.diagnostics.error(uri->place, "include: " + path->string() + " includes itself", "include another file");
    return nullptr;
  }
  const std::optional<Source> source = context.options.sources->read(path->string(), context.diagnostics);
  if (!source) return nullptr;
  if (std::find(robot.files.begin(), robot.files.end(), path->string()) == robot.files.end()) {
    robot.files.push_back(path->string());
  }
  return parse_sdf(source->text, path->string(), context, tree);
}

}  // namespace flatdyn
