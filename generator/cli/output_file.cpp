// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/output_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/diagnostics/diagnostics.hpp"
#include "report/json_text.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

namespace {

bool is_stdout(const fs::path& path) { return path == kStdout; }

// Whether the path is a file to be replaced; devices and pipes are written to.
bool is_replaced(const fs::path& path) {
  if (is_stdout(path)) return false;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return !fs::exists(status) || fs::is_regular_file(status);
}

// Whether both paths lead to one file, also by two names. A device such as /dev/null does not count: it loses nothing.
bool is_one_file(const fs::path& a, const fs::path& b) {
  if (is_stdout(a) || is_stdout(b)) return a == b;
  if (!is_replaced(a) || !is_replaced(b)) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(a), error);
  return !error && first == fs::weakly_canonical(fs::absolute(b), error) && !error;
}

// The file with links followed: the target of a link is replaced, not the link.
TextFile followed(const TextFile& file) {
  if (!fs::is_symlink(fs::symlink_status(file.path)) || !is_replaced(file.path)) return file;
  return {fs::weakly_canonical(file.path), file.text};
}

void check_length_of_name(const fs::path& path) {
  constexpr std::size_t kLongestName = 200;  // of 255; a temporary file beside it has a longer one
  const std::string name = path.filename().string();
  if (name.size() <= kLongestName) return;
  throw Failure(FailureKind::input,
                fmt::format("{}...: a name of {} bytes is too long for a file", name.substr(0, 40), name.size()),
                "generated files are called as the robot; --name gives a shorter name");
}

// Checks, before anything is written, what rename() would report too late or not at all.
void check_writable(const TextFile& file) {
  check_length_of_name(file.path);
  if (fs::is_directory(file.path)) cannot_write(file.path, std::strerror(EISDIR));
  if (fs::exists(file.path) && ::access(file.path.c_str(), W_OK) != 0) cannot_write(file.path, std::strerror(errno));
}

}  // namespace

void check_other_logs(const std::vector<std::string>& logs, const std::vector<std::string>& others,
                      const std::string& option) {
  for (const std::string& other : others) {
    const bool is_one = std::any_of(logs.begin(), logs.end(), [&](const auto& log) { return is_one_file(log, other); });
    if (!is_one) continue;
    throw Failure(FailureKind::usage, fmt::format("{} {}: that log is one of --data, too", option, other),
                  "a log says nothing about itself: give another one");
  }
}

void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->empty()) continue;
    check_length_of_name(*output);
    for (const std::string& input : inputs) {
      if (!is_one_file(*output, input)) continue;
      throw Failure(FailureKind::usage, fmt::format("{}: the output would replace the input {}", *output, input),
                    "write to another file");
    }
    for (auto other = outputs.begin(); other != output; ++other) {
      if (other->empty() || !is_one_file(*output, *other)) continue;
      throw Failure(FailureKind::usage, fmt::format("{}: two outputs would go to this file", *output),
                    "give each a file of its own");
    }
  }
}

void write_files(const std::vector<TextFile>& wanted, const std::vector<fs::path>& outdated) {
  NewFolders folders;
  std::vector<TextFile> files, streams;
  for (const TextFile& file : wanted) {
    (is_replaced(file.path) ? files : streams).push_back(followed(file));
    if (is_stdout(file.path)) continue;
    folders.make_for(followed(file).path);
    check_writable(followed(file));
  }
  replace_files(files, outdated);
  for (const TextFile& file : streams) {
    if (is_stdout(file.path)) {
      print_result(file.text);
    } else {
      write_text(file.path, file);
    }
  }
}

void write_and_print(const std::vector<TextFile>& files, const CommandOutput& output, const OutputStyle& style) {
  const bool is_on_stdout =
      std::any_of(files.begin(), files.end(), [](const TextFile& file) { return is_stdout(file.path); });
  if (is_on_stdout && style.json) refuse_two_on_stdout();
  write_files(files);
  if (style.json) {
    nlohmann::ordered_json json = output.json;
    for (const TextFile& file : files) json["files"].push_back(file.path.string());
    print_result(json_text(json));
    return;
  }
  if (is_on_stdout || (style.quiet && !files.empty())) return;
  print_result(output.text);
  for (const TextFile& file : files) print_result(fmt::format("wrote {}\n", file.path.string()));
}

void refuse_two_on_stdout() {
  throw Failure(FailureKind::usage, "-o - and --json would both write to stdout", "leave one of them out");
}

}  // namespace flatdyn
