// SPDX-License-Identifier: GPL-2.0-or-later
// Small SDF files of tests.
#pragma once

#include <string>

namespace flatdyn {

inline std::string sdf_model(const std::string& contents, const std::string& version = "1.9") {
  return "<sdf version=\"" + version + "\"><model name=\"r\">" + contents + "</model></sdf>";
}

// A joint "j" between links "base" and "arm".
inline std::string sdf_joint(const std::string& type, const std::string& elements) {
  return "<joint name=\"j\" type=\"" + type + "\"><parent>base</parent><child>arm</child>" + elements + "</joint>";
}

inline const std::string kBaseAndArm = R"(<link name="base"/><link name="arm"/>)";
inline const std::string kAxisZ = "<axis><xyz>0 0 1</xyz></axis>";

}  // namespace flatdyn
