// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace flatdyn {

// A file of the generated code.
struct GeneratedFile {
  std::string name;  // without a folder
  std::string text;
};

}  // namespace flatdyn
