// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/meshes.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "robot/input/common/words.hpp"
#include "robot/input/mjcf/convex_hull.hpp"
#include "robot/input/mjcf/mesh_file.hpp"
#include "robot/input/mjcf/names.hpp"
#include "robot/model/exact_sign.hpp"

namespace flatdyn {

namespace {

namespace fs = std::filesystem;

constexpr const char* kGiveInertial = "write an <inertial> of the body";

std::string name_of_mesh(const FileNode& mesh) {
  const std::string name = mesh.value("name");
  return name.empty() ? fs::path(mesh.value("file")).stem().string() : name;
}

std::vector<const FileNode*> meshes_of(const FileNode& root) {
  std::vector<const FileNode*> meshes;
  for (const FileNode* assets : root.elements("asset")) {
    for (const FileNode* mesh : assets->elements("mesh")) meshes.push_back(mesh);
  }
  return meshes;
}

class SolidReader {
 public:
  SolidReader(const FileNode& mesh, const std::string& what, const MjcfModel& model)
      : model_(model), values_(model.values), diagnostics_(model.diagnostics()), item_(values_.item(mesh)) {
    item_.what = what + ", mesh \"" + name_of_mesh(mesh) + "\"";
  }

  std::optional<MjcfMeshes::Solid> read() {
    const std::optional<MeshVolume> volume = this->volume();
    const auto scale = this->scale();
    if (!volume || !scale || refuse_builtin()) return std::nullopt;
    std::optional<TriangleMesh> mesh = item_.element->attribute("file") != nullptr ? of_file() : of_numbers();
    if (!mesh) return std::nullopt;
    if (*volume == MeshVolume::exact && !has_one_orientation(*mesh)) {
      report("its triangles do not turn the same way");
      return std::nullopt;
    }
    MjcfMeshes::Solid solid;
    solid.moments = mesh_moments(scaled(*mesh, *scale), *volume);
    constexpr double kLeast = 1e-15;  // m^3, as in MuJoCo
    if (nearest_double(solid.moments.volume) < kLeast) {
      report(is_negative(solid.moments.volume) ? "its volume is negative: its triangles are turned inside out"
                                               : "it encloses no volume");
      return std::nullopt;
    }
    if (!place(*scale, solid)) return std::nullopt;
    return solid;
  }

 private:
  void report(const std::string& message) {
    diagnostics_.error(item_.element->place, item_.what + ": " + message,
                       std::string("export the mesh anew, or ") + kGiveInertial);
  }

  std::optional<MeshVolume> volume() {
    const std::string word = values_.keyword(item_, "inertia", {"convex", "exact", "legacy", "shell"},
                                             model_.settings.has_exact_mesh_inertia ? "exact" : "legacy");
    if (word == "exact") return MeshVolume::exact;
    if (word == "legacy") return MeshVolume::legacy;
    if (word == "shell") return MeshVolume::shell;
    const FileAttribute* fewer = values_.find(item_, "maxhullvert");
    if (fewer == nullptr || fewer->text == "-1") return MeshVolume::convex;
    diagnostics_.unsupported(fewer->place, item_.what + ": inertia=\"convex\" with maxhullvert is not supported",
                             std::string("leave maxhullvert out, or ") + kGiveInertial);
    return std::nullopt;
  }

  std::optional<Vec3> scale() {
    const Vec3 scale = values_.vector(item_, "scale", {1, 1, 1});
    for (const Number& each : scale) {
      if (!vanishes(each)) continue;
      report("its scale is 0");
      return std::nullopt;
    }
    return scale;
  }

  bool refuse_builtin() {
    for (const char* name : {"builtin", "plugin"}) {
      const bool has_one = item_.element->attribute(name) != nullptr || !item_.element->elements(name).empty();
      if (!has_one) continue;
      diagnostics_.unsupported(item_.element->place, item_.what + ": a mesh by " + name + " is not supported",
                               kGiveInertial);
      return true;
    }
    return false;
  }

  std::optional<TriangleMesh> of_file() {
    const FileAttribute& file = *item_.element->attribute("file");
    const fs::path folder = fs::path(model_.robot.file).parent_path() / model_.settings.mesh_folder;
    const std::string path =
        (folder / (model_.settings.strips_path ? fs::path(file.text).filename().string() : file.text)).string();
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
      diagnostics_.error(
          file.place, item_.what + ": there is no file \"" + path + "\"",
          "put it there, or write an <inertial> of the body, which is needed then; --ignore mesh leaves meshes out");
      return std::nullopt;
    }
    std::vector<std::string>& files = model_.robot.files;
    if (std::find(files.begin(), files.end(), path) == files.end()) files.push_back(path);
    return read_mesh_file(path, {file.place, item_.what}, diagnostics_);
  }

  // Corners and triangles that are in the file itself. Corners without triangles stand for their convex hull.
  std::optional<TriangleMesh> of_numbers() {
    const FileAttribute* points = item_.element->attribute("vertex");
    const FileAttribute* faces = item_.element->attribute("face");
    if (points == nullptr) {
      diagnostics_.unsupported(item_.element->place, item_.what + " has neither a file nor points",
                               std::string("name a file, or ") + kGiveInertial);
      return std::nullopt;
    }
    const std::vector<std::string> numbers = words_of(points->text),
                                   corners = faces == nullptr ? std::vector<std::string>{} : words_of(faces->text);
    MeshBuilder builder(10);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
      std::array<Scientific, 3> point;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<Scientific> number = exact_scientific(numbers[i + k]);
        if (!number) return wrong_number(*points, numbers[i + k]);
        point[k] = *number;
      }
      builder.add_point(point);
    }
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      std::array<std::size_t, 3> triangle = {};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::optional<Scientific> corner = exact_scientific(corners[i + k]);
        if (!corner || corner->exponent != 0 || corner->mantissa < 0 || corner->mantissa >= builder.point_count())
          return wrong_number(*faces, corners[i + k]);
        triangle[k] = corner->mantissa.get_ui();
      }
      builder.add_triangle(triangle[0], triangle[1], triangle[2]);
    }
    return faces == nullptr ? convex_hull(builder.mesh()) : builder.mesh();
  }

  std::optional<TriangleMesh> wrong_number(const FileAttribute& attribute, const std::string& word) {
    diagnostics_.error(attribute.place,
                       item_.what + ", " + attribute.name + ": \"" + word.substr(0, 40) +
                           (attribute.name == "face" ? "\" is no point that is there" : "\" is not a number"),
                       "write three numbers per point, three points, from 0, per face");
    return std::nullopt;
  }

  // The mesh with its axes scaled. One that is mirrored has its triangles turned.
  static TriangleMesh scaled(TriangleMesh mesh, const Vec3& scale) {
    Number common = 1;
    for (const Number& each : scale) common = GiNaC::lcm(common, GiNaC::ex_to<GiNaC::numeric>(each).denom());
    mesh.unit = mesh.unit / common;
    bool is_mirrored = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const GiNaC::numeric factor = GiNaC::ex_to<GiNaC::numeric>(common * scale[k]);
      is_mirrored = is_mirrored != factor.is_negative();
      std::ostringstream text;
      text << factor;
      const MeshInteger whole(text.str());
      for (IntegerPoint& point : mesh.points) point[k] *= whole;
    }
    if (is_mirrored) {
      for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    }
    return mesh;
  }

  // MuJoCo moves the mesh by -refpos, turns it back by refquat, and then scales it.
  bool place(const Vec3& scale, MjcfMeshes::Solid& solid) {
    const Vec3 reference = values_.vector(item_, "refpos", zero_vector());
    for (std::size_t k = 0; k < 3; ++k) solid.moments.centre[k] -= scale[k] * reference[k];
    const FileAttribute* turn = values_.find(item_, "refquat");
    if (turn == nullptr) return true;
    const bool is_uniform = vanishes(scale[0] - scale[1]) && vanishes(scale[0] - scale[2]);
    if (!is_uniform) {
      diagnostics_.unsupported(turn->place, item_.what + ": refquat with a scale that differs by axis is not supported",
                               std::string("scale the mesh in its file, or ") + kGiveInertial);
      return false;
    }
    FileNode holder{"mesh", {{"quat", turn->text, turn->place}}, {}, turn->place};
    MjcfItem orientation = MjcfValues::plain(holder);
    orientation.what = item_.what + ", refquat";
    std::vector<Displacement> turns = mjcf_orientation(orientation, values_, model_.settings);
    std::reverse(turns.begin(), turns.end());
    for (Displacement& each : turns) each.angle = -each.angle;
    solid.frame.displacements = turns;
    return true;
  }

  const MjcfModel& model_;
  const MjcfValues& values_;
  Diagnostics& diagnostics_;
  MjcfItem item_;
};

}  // namespace

const MjcfMeshes::Solid* MjcfMeshes::find(const FileAttribute& geom, const std::string& what) {
  const auto known = known_.find(geom.text);
  if (known != known_.end()) return known->second ? &*known->second : nullptr;
  std::optional<Solid>& solid = known_[geom.text];
  std::vector<std::string> names;
  for (const FileNode* mesh : meshes_of(model_.root)) {
    names.push_back(name_of_mesh(*mesh));
    if (names.back() != geom.text) continue;
    solid = SolidReader(*mesh, what, model_).read();
    return solid ? &*solid : nullptr;
  }
  report_missing_name(geom, what, "mesh", names, model_.diagnostics());
  return nullptr;
}

}  // namespace flatdyn
