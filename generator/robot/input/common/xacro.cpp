// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/xacro.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

bool is_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / program;
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return true;
  }
  return false;
}

// As one line of a message, or several below it.
std::string indented(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  std::string lines;
  for (const char c : text) lines += c == '\n' ? "\n    " : std::string(1, c);
  return "\n    " + lines;
}

// Elements of other programs have names of their own, which mean nothing here.
constexpr std::array<std::string_view, 6> kOfOthers = {"gazebo", "transmission", "ros2_control",
                                                       "mujoco", "plugin",       "sensor"};

bool is_of_others(const FileNode& element) {
  return std::find(kOfOthers.begin(), kOfOthers.end(), element.name) != kOfOthers.end();
}

// Before 2015 xacro took its elements without a prefix.
bool is_old_xacro(const FileNode& element) {
  const bool defines = element.name == "macro" || element.name == "property";
  return (defines && element.has("name")) || (element.name == "include" && element.has("filename"));
}

// "" if nothing in the element itself is xacro's.
std::string sign_of_template(const FileNode& element, bool is_inside_others) {
  const bool is_own = element.name.starts_with("xacro:") || (!is_inside_others && is_old_xacro(element));
  if (is_own) return "<" + element.name + ">";
  if (is_inside_others) return "";
  for (const char* attribute : {"name", "link"}) {
    const std::string text = element.value(attribute);
    if (text.find("${") != text.npos || text.find("$(") != text.npos) return "\"" + text + "\"";
  }
  return "";
}

// The first sign of each element, in the order of the file.
struct Signs {
  std::string first;
  Place place;
  int count = 0;
};

void look_for_signs(const FileNode& element, bool is_inside_others, Signs& signs) {
  const std::string sign = sign_of_template(element, is_inside_others);
  if (!sign.empty() && signs.count++ == 0) {
    signs.first = sign;
    signs.place = element.place;
  }
  for (const FileNode& child : element.children) look_for_signs(child, is_inside_others || is_of_others(child), signs);
}

}  // namespace

bool is_xacro(const fs::path& path) { return path.extension() == ".xacro"; }

std::optional<std::string> expanded_by_xacro(const std::string& file, const std::vector<std::string>& arguments,
                                             Diagnostics& diagnostics) {
  if (!is_on_path("xacro")) {
    throw Failure(FailureKind::io, file + ": this is a xacro template, and there is no program xacro on the PATH",
                  "install it (pip install xacro, or source setup.bash of a ROS that has it); or expand the file "
                  "elsewhere: xacro " +
                      fs::path(file).filename().string() + " > robot.urdf");
  }
  const TemporaryFolder folder;
  const fs::path expanded = folder.path() / "expanded", messages = folder.path() / "messages";
  std::string command = "xacro " + shell_word(fs::absolute(file).string());
  for (const std::string& argument : arguments) command += " " + shell_word(argument);
  command += " > " + shell_word(expanded.string()) + " 2> " + shell_word(messages.string());
  if (run_command(command, fs::current_path()) == 0) return content_of_file(expanded);
  check_room(folder.path(), content_of_file(messages));
  diagnostics.error({file, 0}, "xacro does not expand it:" + indented(content_of_file(messages)),
                    "correct the file; arguments are given by --xacro NAME:=VALUE");
  return std::nullopt;
}

bool refuse_template(const FileNode& root, Diagnostics& diagnostics) {
  Signs signs;
  look_for_signs(root, false, signs);
  if (signs.count == 0) return false;
  const std::string places = signs.count == 1 ? "" : " (" + std::to_string(signs.count) + " places in all)";
  diagnostics.error(signs.place, signs.first + ": this is a xacro template, not a URDF" + places,
                    "expand it first: xacro FILE > robot.urdf; a file that is called .xacro is expanded as it is read");
  return true;
}

}  // namespace flatdyn
