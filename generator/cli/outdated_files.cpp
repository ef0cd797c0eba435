// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/outdated_files.hpp"

#include <nlohmann/json.hpp>

#include "base/system/process.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

namespace {

bool stays(const TextFile& header) { return fs::exists(header.path) && content_of_file(header.path) == header.text; }

fs::path beside_the_header(const TextFile& header, const char* extension) {
  return fs::path(header.path).replace_extension(extension);
}

// Whether the file speaks of this header, and does not just have the right name.
bool is_of(const fs::path& json_file, const TextFile& header) {
  const auto json = nlohmann::json::parse(content_of_file(json_file), nullptr, false);
  return json.is_object() && json.contains("flatdyn") && json.contains("header") &&
         json["header"] == header.path.filename().string();
}

std::vector<fs::path> scripts(const TextFile& header) {
  std::vector<fs::path> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(beside_the_header(header, "gappa"), ignored)) {
    if (entry.path().extension() == ".g") found.push_back(entry.path());
  }
  return found;
}

}  // namespace

std::vector<fs::path> outdated_certificate(const TextFile& header) {
  const fs::path certificate = beside_the_header(header, "certificate.json");
  if (!is_of(certificate, header) || stays(header)) return {};
  std::vector<fs::path> files = scripts(header);
  files.push_back(certificate);
  files.push_back(beside_the_header(header, "certificate.md"));
  return files;
}

std::vector<fs::path> outdated_manifest_and_scripts(const TextFile& header) {
  std::vector<fs::path> files = scripts(header);
  const fs::path manifest = beside_the_header(header, "json");
  if (is_of(manifest, header) && !stays(header)) files.push_back(manifest);
  return files;
}

}  // namespace flatdyn
