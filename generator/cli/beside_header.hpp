// SPDX-License-Identifier: GPL-2.0-or-later
// Files beside a header that speak of the header that was there, and would be wrong beside another one.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/replace_files.hpp"

namespace flatdyn {

// For `generate`: certificate and scripts of `certify`. None if the header stays as it is.
std::vector<std::filesystem::path> outdated_certificate(const TextFile& header);

// For `certify`: the manifest of `generate`, if the header changes, and scripts of the last certificate.
std::vector<std::filesystem::path> outdated_manifest_and_scripts(const TextFile& header);

}  // namespace flatdyn
