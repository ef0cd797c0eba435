// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/messages.hpp"
#include "cli/replace_files.hpp"

namespace flatdyn {

// The file name that means stdout.
inline constexpr const char* kStdout = "-";

// Throws Failure(usage) if two outputs are the same file, or if an output is an input, which would be lost. Outputs
// without a name are ignored.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

// Throws Failure(usage) if a log of the second list is also one of the first: it would be compared with itself.
void check_other_logs(const std::vector<std::string>& logs, const std::vector<std::string>& others,
                      const std::string& option);

// Writes all files or none, by replace_files(). A link stays a link, and its target is replaced; a device is written
// to. Missing folders are made. Throws Failure(io).
void write_files(const std::vector<TextFile>& wanted, const std::vector<std::filesystem::path>& outdated = {});

// The output of a subcommand on stdout: text for people, or JSON.
struct CommandOutput {
  std::string text;  // ends with a line break
  nlohmann::ordered_json json;
};

// Writes the files, then prints the output with their names. Nothing is printed if a file goes to stdout or, with
// --quiet, if there are files.
void write_and_print(const std::vector<TextFile>& files, const CommandOutput& output, const OutputStyle& style);

// Throws Failure(usage).
[[noreturn]] void refuse_two_on_stdout();

}  // namespace flatdyn
