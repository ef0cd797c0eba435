// SPDX-License-Identifier: GPL-2.0-or-later
// Where a robot's text comes from: a file, stdin, or a xacro template that the program xacro expands.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

// XML is a URDF until its outermost element says that it is another format.
enum class FileKind { urdf, toml, unknown, sdf, mjcf };

// The kind of a file that is named as one, or came from stdin, by its text.
FileKind kind_by_text(FileKind kind, const std::string& text);

// The name of stdin as a file: in messages, and where a robot is read again.
inline constexpr const char* kStandardInput = "<stdin>";

struct Source {
  std::string text;
  std::string name;  // in messages: lines of an expanded template are those of "arm.xacro (expanded)"
  FileKind kind = FileKind::unknown;
};

// A robot is read several times, but stdin can be read only once, and xacro is to run only once.
class Sources {
 public:
  // Each "NAME:=VALUE", as xacro takes them.
  explicit Sources(std::vector<std::string> xacro_arguments = {}) : xacro_arguments_(std::move(xacro_arguments)) {}

  // Throws Failure(io) if it cannot be read, or if xacro is needed and not installed; nullopt and a diagnostic if it is
  // too large, or if xacro refuses it.
  std::optional<Source> read(const std::string& path, Diagnostics& diagnostics);

  // "sha1:…" of the texts of these files, of templates that were read here as xacro expanded them.
  std::string hash(const std::vector<std::string>& paths) const;

  // Throws Failure(usage) if there are arguments for xacro, and no template was read.
  void check_arguments() const;

 private:
  std::vector<std::string> xacro_arguments_;
  std::map<std::string, Source> kept_;  // by path
};

}  // namespace flatdyn
