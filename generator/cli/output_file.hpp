// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace flatdyn {

struct TextFile {
  std::filesystem::path path;
  std::string text;
};

// Throws Failure(usage) if two outputs are one file, or if an output is an input, which would be lost. Outputs without
// a name do not count.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

// Writes all of them beside their places and renames them at the end: nobody ever sees half a file, and at whatever
// moment the run is killed, files of one run are there: the last one's, or some or all of this one's. Of several runs
// in one folder, one after the other does so. A link stays a link; a device is written to. Throws Failure(io).
void write_files(const std::vector<TextFile>& wanted);

// What a subcommand tells on stdout: for people, or as JSON.
struct Told {
  std::string text;  // ends its last line
  nlohmann::ordered_json json;
};

// Writes the files, then prints what is told, with their names.
void write_and_tell(const std::vector<TextFile>& files, const Told& told, bool as_json);

}  // namespace flatdyn
