// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/foreign_files.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace flatdyn {
namespace {

constexpr const char* kMeshHint = "name the robot file (.urdf, .sdf, .xml, .xacro or .toml) that shows it";
constexpr ForeignFile kMesh = {"this is a mesh or a drawing, not a robot file", kMeshHint},
                      kCollada = {"this is a Collada file: a mesh, not a robot file", kMeshHint};

}  // namespace

std::optional<ForeignFile> foreign_by_name(const std::filesystem::path& path) {
  static const std::set<std::string, std::less<>> kMeshes = {
      ".stl", ".obj", ".mtl",  ".ply", ".msh", ".glb", ".gltf", ".fbx",  ".3ds",  ".blend", ".wrl", ".off", ".step",
      ".stp", ".igs", ".iges", ".dxf", ".dwg", ".usd", ".usda", ".usdc", ".usdz", ".3mf",   ".x3d", ".iv",  ".sldprt"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; });
  if (ending == ".dae") return kCollada;
  if (kMeshes.contains(ending)) return kMesh;
  if (path.filename() == "model.config") {
    return ForeignFile{"this is the description of a model's folder, not a robot file", "name the .sdf file beside it"};
  }
  if (ending == ".srdf") {
    return ForeignFile{"this is an SRDF, which has groups of joints and no robot", "name the .urdf file beside it"};
  }
  if (ending == ".mjb") return ForeignFile{"this is a compiled model of MuJoCo", "name the .xml file of the model"};
  return std::nullopt;
}

std::optional<ForeignFile> foreign_by_element(std::string_view element) {
  static const std::map<std::string_view, ForeignFile> kElements = {
      {"COLLADA", kCollada},
      {"X3D", kMesh},
      {"svg", kMesh},
      {"VTKFile", kMesh},
      {"launch", {"this is a launch file of ROS, not a robot file", "name the robot file that it loads"}},
      {"package", {"this is the package.xml of a ROS package, not a robot file", "name a robot file of the package"}}};
  const auto found = kElements.find(element);
  return found == kElements.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace flatdyn
