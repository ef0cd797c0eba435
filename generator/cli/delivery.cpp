// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/delivery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "base/diagnostics/diagnostics.hpp"
#include "cli/outdated_files.hpp"
#include "robot/input/common/sources.hpp"

namespace flatdyn {
namespace {

std::optional<std::string> text_on_disk(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

// The difference between the file and the one on disk; empty if there is none.
std::string difference(const TextFile& file) {
  const std::optional<std::string> there = text_on_disk(file.path);
  if (!there) return "it is not there";
  if (*there == file.text) return "";
  const auto [old, made] = std::mismatch(there->begin(), there->end(), file.text.begin(), file.text.end());
  return fmt::format("from line {} on", 1 + std::count(there->begin(), old, '\n'));
}

void compare(const std::vector<TextFile>& files) {
  for (const TextFile& file : files) {
    const std::string how = difference(file);
    if (how.empty()) continue;
    throw Failure(FailureKind::outdated,
                  fmt::format("{}: is not what this run would write: {}", file.path.string(), how),
                  "run it again without --check");
  }
}

std::string escaped(const std::string& path) {
  std::string result;
  for (const char c : path) {
    if (c == ' ' || c == '#' || c == '\\') result += '\\';
    result += c == '$' ? "$$" : std::string(1, c);
  }
  return result;
}

std::vector<std::string> files_among(std::vector<std::string> inputs) {
  std::erase(inputs, kStandardInput);
  return inputs;
}

std::string listed(const std::vector<TextFile>& files, const char* verb) {
  std::string lines;
  for (const TextFile& file : files) lines += fmt::format("{} {}\n", verb, file.path.string());
  return lines;
}

}  // namespace

std::string dependency_rule(const std::vector<std::string>& targets, const std::vector<std::string>& prerequisites) {
  std::string rule;
  for (const std::string& target : targets) rule += (rule.empty() ? "" : " ") + escaped(target);
  rule += ':';
  for (const std::string& prerequisite : prerequisites) rule += " \\\n  " + escaped(prerequisite);
  return rule + '\n';
}

void Delivery::add_to(CLI::App& command) {
  CLI::Option* compared = command.add_flag(
      "--check", check, "write nothing; exit code 7 if an output is missing or is not what would be written");
  command.add_flag("-n,--dry-run", dry_run, "write nothing, say what would be written")->excludes(compared);
  command.add_option("--depfile", depfile, "also write which files the outputs were made from, for make or Ninja")
      ->type_name("FILE");
}

std::string Delivery::deliver(std::vector<TextFile> files, const std::vector<std::string>& inputs) const {
  std::vector<std::string> outputs;
  for (const TextFile& file : files) outputs.push_back(file.path.string());
  if (!depfile.empty()) files.push_back({depfile, dependency_rule(outputs, files_among(inputs))});
  outputs.push_back(depfile);
  check_outputs(outputs, inputs);
  const bool is_to_stdout = files.front().path == kStdout;
  const std::vector<std::filesystem::path> outdated =
      is_to_stdout ? std::vector<std::filesystem::path>() : outdated_certificate(files.front());
  if (check) {
    compare(files);
    return listed(files, "up to date:");
  }
  if (dry_run) return listed(files, "would write");
  write_files(files, outdated);
  return listed(files, "wrote");
}

}  // namespace flatdyn
