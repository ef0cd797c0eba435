// SPDX-License-Identifier: GPL-2.0-or-later
// The robots of robots/, read.
#pragma once

#include <string>

#include "pipeline.hpp"

namespace flatdyn::testing {

inline Model model_of(const std::string& file) {
  return read_model(std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots" / file, {});
}

}  // namespace flatdyn::testing
