// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/namespaces.hpp"

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace flatdyn {
namespace {

using Addresses = std::map<std::string, std::string, std::less<>>;  // by prefix

constexpr std::string_view kDeclaration = "xmlns:";

// Without what differs between spellings of one address: http or https, www, an oblique stroke at the end.
std::string_view plain_address(std::string_view address) {
  for (const std::string_view start : {"http://", "https://", "www."}) {
    if (address.starts_with(start)) address.remove_prefix(start.size());
  }
  while (address.ends_with('/')) address.remove_suffix(1);
  return address;
}

// "drake" for the address of Drake's words; "" for one that is not known.
std::string_view usual_prefix(std::string_view address) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kPrefixes = {
      {{"drake.mit.edu", "drake"},
       {"ros.org/wiki/xacro", "xacro"},
       {"wiki.ros.org/xacro", "xacro"},
       {"playerstage.sourceforge.net/gazebo/xmlschema/#xacro", "xacro"},
       {"ros.org/xacro", "xacro"}}};
  for (const auto& [known, prefix] : kPrefixes) {
    if (plain_address(address) == known) return prefix;
  }
  return "";
}

class Renamer {
 public:
  explicit Renamer(FileNode& root) : root_(root) {}

  void run() {
    const std::size_t colon = root_.name.find(':');
    own_prefix_ = root_.name.substr(0, colon == std::string::npos ? 0 : colon);
    rename(root_, {});
  }

 private:
  void rename(FileNode& element, Addresses addresses) {
    for (const FileAttribute& each : element.attributes) {
      if (each.name.starts_with(kDeclaration)) addresses[each.name.substr(kDeclaration.size())] = each.text;
    }
    if (&element == &root_ && addresses.contains(own_prefix_)) own_address_ = addresses[own_prefix_];
    element.name = renamed(element.name, addresses);
    for (FileAttribute& each : element.attributes) each.name = renamed(each.name, addresses);
    for (FileNode& child : element.children) rename(child, addresses);
  }

  std::string renamed(const std::string& name, const Addresses& addresses) const {
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos || name.starts_with(kDeclaration)) return name;
    const auto address = addresses.find(name.substr(0, colon));
    if (address == addresses.end()) return name;
    const std::string local = name.substr(colon + 1);
    if (const std::string_view usual = usual_prefix(address->second); !usual.empty()) {
      return std::string(usual) + ":" + local;
    }
    return !own_address_.empty() && address->second == own_address_ ? local : name;
  }

  FileNode& root_;
  std::string own_prefix_, own_address_;  // of the outermost element
};

}  // namespace

void give_usual_prefixes(FileNode& root) { Renamer(root).run(); }

}  // namespace flatdyn
