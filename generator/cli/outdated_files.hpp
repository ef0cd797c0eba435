// SPDX-License-Identifier: GPL-2.0-or-later
// Files beside a header that describe the previous header and would be wrong beside a new one.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/replace_files.hpp"

namespace flatdyn {

// For `generate`: the certificate and scripts of `certify`. Empty if the header does not change.
std::vector<std::filesystem::path> outdated_certificate(const TextFile& header);

// For `certify`: the manifest of `generate` if the header changes, and the scripts of the last certificate.
std::vector<std::filesystem::path> outdated_manifest_and_scripts(const TextFile& header);

}  // namespace flatdyn
