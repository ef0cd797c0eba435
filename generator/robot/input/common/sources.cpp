// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/sources.hpp"

#include <iostream>
#include <iterator>

#include "base/system/process.hpp"
#include "robot/input/common/content_hash.hpp"
#include "robot/input/common/context.hpp"
#include "robot/input/common/xacro.hpp"
#include "robot/input/common/xml_document.hpp"

namespace flatdyn {
namespace {

// Behind a byte order mark and blanks, XML begins with "<"; in UTF-16 with a zero byte next to it.
FileKind kind_of_text(const std::string& text) {
  const std::size_t first = text.find_first_not_of(std::string("\xEF\xBB\xBF\xFF\xFE \t\r\n\0", 10));
  return first != std::string::npos && text[first] == '<' ? FileKind::urdf : FileKind::toml;
}

Source from_standard_input() {
  std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const FileKind kind = kind_of_text(text);
  return {std::move(text), kStandardInput, kind};
}

}  // namespace

FileKind kind_by_text(FileKind kind, const std::string& text) {
  if (kind != FileKind::urdf) return kind;
  const std::string element = outermost_element(text);
  if (element == "sdf") return FileKind::sdf;
  return element == "mujoco" ? FileKind::mjcf : kind;
}

std::optional<Source> Sources::read(const std::string& path, Diagnostics& diagnostics) {
  if (const auto kept = kept_.find(path); kept != kept_.end()) return kept->second;
  if (path == kStandardInput) {
    Source source = from_standard_input();
    if (!check_size(source.text.size(), path, diagnostics)) return std::nullopt;
    if (!check_fetched(source.text, path, diagnostics)) return std::nullopt;
    return kept_.emplace(path, std::move(source)).first->second;
  }
  std::optional<std::string> text = file_text(path, diagnostics);
  if (!text) return std::nullopt;
  if (is_pipe(path)) {
    const FileKind kind = kind_of_text(*text);
    return kept_.emplace(path, Source{*std::move(text), path, kind}).first->second;
  }
  if (!is_xacro(path)) return Source{*std::move(text), path, kind_of(path)};
  std::optional<std::string> expanded = expanded_by_xacro(path, xacro_arguments_, diagnostics);
  if (!expanded) return std::nullopt;
  return kept_.emplace(path, Source{*std::move(expanded), path + " (expanded)", FileKind::urdf}).first->second;
}

std::string Sources::hash(const std::vector<std::string>& paths) const {
  std::vector<std::string> texts;
  for (const std::string& path : paths) {
    const auto kept = kept_.find(path);
    texts.push_back(kept != kept_.end() ? kept->second.text : content_of_file(path));
  }
  return content_hash(texts);
}

void Sources::check_arguments() const {
  if (xacro_arguments_.empty()) return;
  for (const auto& [path, source] : kept_) {
    if (is_xacro(path)) return;
  }
  throw Failure(FailureKind::usage, "--xacro " + xacro_arguments_.front() + " has no effect: no .xacro file is read",
                "leave it out, or name the template");
}

}  // namespace flatdyn
