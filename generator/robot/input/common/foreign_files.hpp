// SPDX-License-Identifier: GPL-2.0-or-later
// Files of other kinds that often lie next to robot files and are easily named instead of one.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace flatdyn {

struct ForeignFile {
  const char *what, *hint;
};

// A mesh, a drawing or another such file, recognised by its name; nullopt for other files.
std::optional<ForeignFile> foreign_by_name(const std::filesystem::path& path);

// The same of XML, by its outermost element.
std::optional<ForeignFile> foreign_by_element(std::string_view element);

}  // namespace flatdyn
