// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/namespaces.hpp"

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatdyn {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;

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
  explicit Renamer(XMLElement& root) : root_(root) {}

  void run() {
    const std::string_view name = root_.Name();
    own_prefix_ = name.substr(0, name.find(':') == std::string_view::npos ? 0 : name.find(':'));
    rename(root_, {});
  }

 private:
  void rename(XMLElement& element, Addresses addresses) {
    bool has_prefixes = false;
    for (const XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string_view name = a->Name();
      if (name.starts_with(kDeclaration)) addresses[std::string(name.substr(kDeclaration.size()))] = a->Value();
    }
    for (const XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      has_prefixes = has_prefixes || renamed(a->Name(), addresses) != a->Name();
    }
    if (&element == &root_ && addresses.contains(own_prefix_)) own_address_ = addresses[own_prefix_];
    const std::string name = renamed(element.Name(), addresses);
    if (name != element.Name()) element.SetName(name.c_str());
    if (has_prefixes) rename_attributes(element, addresses);
    for (XMLElement* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      rename(*child, addresses);
    }
  }

  std::string renamed(std::string_view name, const Addresses& addresses) const {
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos || name.starts_with(kDeclaration)) return std::string(name);
    const auto address = addresses.find(name.substr(0, colon));
    if (address == addresses.end()) return std::string(name);
    const std::string local(name.substr(colon + 1));
    if (const std::string_view usual = usual_prefix(address->second); !usual.empty()) {
      return std::string(usual) + ":" + local;
    }
    return !own_address_.empty() && address->second == own_address_ ? local : std::string(name);
  }

  // All anew, as their order is that of messages.
  static void rename_attributes(XMLElement& element, const std::vector<std::pair<std::string, std::string>>& all) {
    while (element.FirstAttribute() != nullptr) element.DeleteAttribute(element.FirstAttribute()->Name());
    for (const auto& [name, value] : all) element.SetAttribute(name.c_str(), value.c_str());
  }

  void rename_attributes(XMLElement& element, const Addresses& addresses) const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      all.emplace_back(renamed(a->Name(), addresses), a->Value());
    }
    rename_attributes(element, all);
  }

  XMLElement& root_;
  std::string own_prefix_, own_address_;  // of the outermost element
};

}  // namespace

void give_usual_prefixes(XMLElement& root) { Renamer(root).run(); }

}  // namespace flatdyn
