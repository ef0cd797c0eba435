// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/replace_files.hpp"
#include "cli/telling.hpp"

namespace flatdyn {

// As a file's name it means stdout.
inline constexpr const char* kStdout = "-";

// Throws Failure(usage) if two outputs are one file, or if an output is an input, which would be lost. Outputs without
// a name do not count.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

// All of them or none, as replace_files does. A link stays a link, and what it leads to is replaced; a device is
// written to. Folders that are not there are made. Throws Failure(io).
void write_files(const std::vector<TextFile>& wanted, const std::vector<std::filesystem::path>& outdated = {});

// What a subcommand tells on stdout: for people, or as JSON.
struct CommandOutput {
  std::string text;  // ends its last line
  nlohmann::ordered_json json;
};

// Writes the files, then prints what is told, with their names: nothing where a file is on stdout, or, with --quiet,
// where there are files.
void write_and_tell(const std::vector<TextFile>& files, const CommandOutput& told, const Manner& manner);

// Throws Failure(usage).
[[noreturn]] void refuse_two_on_stdout();

}  // namespace flatdyn
