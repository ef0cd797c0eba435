// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/geoms.hpp"

#include <algorithm>

#include "robot/input/common/exact_root.hpp"
#include "robot/input/common/poses.hpp"
#include "robot/input/mjcf/names.hpp"
#include "robot/input/mjcf/solids.hpp"
#include "robot/model/exact_sign.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {

namespace {

constexpr int kWater = 1000;  // kg/m^3, the density where none is given

class GeomReader {
 public:
  GeomReader(const MjcfGeom& geom, const std::string& body, const MjcfModel& model, MjcfMeshes& meshes)
      : geom_(geom),
        model_(model),
        values_(model.values),
        meshes_(meshes),
        item_(values_.item(*geom.element, geom.class_name)) {
    item_.what = "body \"" + body + "\", " + item_.what;
  }

  // nullopt if it has no mass, or an error.
  std::optional<Inertial> read() {
    type_ = values_.keyword(item_, "type",
                            {"sphere", "capsule", "cylinder", "ellipsoid", "box", "mesh", "plane", "hfield", "sdf"},
                            "sphere");
    if (!counts()) return std::nullopt;
    if (type_ == "plane" || type_ == "hfield") return std::nullopt;
    const FileAttribute* mesh = values_.find(item_, "mesh");
    if (type_ == "mesh") return inertial_of_mesh(mesh);
    if (type_ == "sdf" || mesh != nullptr) return refuse_mesh();
    if (values_.flag(item_, "shellinertia", false)) {
      values_.diagnostics().unsupported(values_.find(item_, "shellinertia")->place,
                                        item_.what + ": the inertia of a shell is not supported",
                                        "give the body an <inertial>");
      return std::nullopt;
    }
    return inertial();
  }

 private:
  // Whether its group is among those that count, and it has a mass.
  bool counts() const {
    const double group = nearest_double(values_.number_or(item_, "group", 0).number);
    if (group < model_.settings.inertia_groups[0] || group > model_.settings.inertia_groups[1]) return false;
    const std::optional<Value> mass = values_.number(item_, "mass");
    return !vanishes(mass ? mass->number : values_.number_or(item_, "density", kWater).number);
  }

  bool is_left_out(const char* name) const {
    const std::vector<std::string>& names = values_.context().options.ignored;
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  // A shape that MuJoCo fits to a mesh, or a signed distance function.
  std::optional<Inertial> refuse_mesh() {
    if (is_left_out("mesh")) return std::nullopt;
    refuse_mjcf(geom_.element->place,
                item_.what + ": the inertia of a " + type_ + " by a mesh is not supported, and the body needs an " +
                    "<inertial>",
                "mesh", values_);
    return std::nullopt;
  }

  std::optional<Inertial> inertial_of_mesh(const FileAttribute* mesh) {
    if (is_left_out("mesh")) return std::nullopt;
    if (mesh == nullptr) {
      values_.diagnostics().error(geom_.element->place, item_.what + " names no mesh", "write mesh=\"...\"");
      return std::nullopt;
    }
    const MjcfMeshes::Solid* solid = meshes_.find(*mesh, item_.what);
    if (solid == nullptr) return std::nullopt;
    Inertial inertial;
    inertial.place = geom_.element->place;
    inertial.frame = joined(geom_.frame, joined(mjcf_pose(item_, values_, model_.settings), solid->frame));
    inertial.frame.displacements.push_back(translation(solid->moments.centre));
    const Number& volume = solid->moments.volume;
    inertial.mass = mass_of(volume);
    for (std::size_t i = 0; i < 3; ++i) {
      inertial.tensor[i] = expanded((inertial.mass.number / volume) * solid->moments.tensor[i]);
    }
    return inertial;
  }

  Value mass_of(const Number& volume) const {
    if (const std::optional<Value> mass = values_.number(item_, "mass")) return *mass;
    Value mass = values_.number_or(item_, "density", kWater);
    if (is_negative(mass.number)) {
      values_.diagnostics().error(mass.place, item_.what + ": its density is negative", "density is in kg/m^3");
      mass.number = 0;  // said once
    }
    mass.number *= volume;
    return mass;
  }

  // Each number is that of the element, or of the nearest class that has so many.
  std::optional<std::vector<Number>> sizes(std::size_t count) const {
    std::vector<Number> found;
    const auto own = values_.numbers(item_, "size", 1, 3);
    if (own) found = own->numbers;
    if (found.size() < count) fill_from_classes(found);
    if (found.size() < count) {
      values_.diagnostics().error(geom_.element->place,
                                  item_.what + ": a " + type_ + " needs " + std::to_string(count) + " sizes",
                                  "write size=\"...\": half lengths, the radius first");
      return std::nullopt;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (is_positive(found[i])) continue;
      values_.diagnostics().error(geom_.element->place,
                                  item_.what + ": size " + std::to_string(i + 1) + " is not positive",
                                  "sizes are half lengths, m");
      return std::nullopt;
    }
    return found;
  }

  void fill_from_classes(std::vector<Number>& found) const {
    for (const FileAttribute* layer : values_.defaults().find_all(item_.class_name, item_.kind, "size")) {
      FileNode holder{geom_.element->name, {*layer}, {}, layer->place};
      const auto wider = values_.numbers({&holder, "", "", item_.what}, "size", 1, 3);
      for (std::size_t i = found.size(); wider && i < wider->numbers.size(); ++i) found.push_back(wider->numbers[i]);
    }
  }

  std::optional<Inertial> inertial() {
    Inertial inertial;
    inertial.place = geom_.element->place;
    std::optional<MjcfSolid> solid;
    if (const auto ends = values_.numbers(item_, "fromto", 6, 6)) {
      solid = between(*ends, inertial.frame);
    } else {
      inertial.frame = mjcf_pose(item_, values_, model_.settings);
      if (const auto half_lengths = sizes(mjcf_size_count(type_))) solid = mjcf_solid(type_, *half_lengths);
    }
    if (!solid) return std::nullopt;
    inertial.frame = joined(geom_.frame, inertial.frame);
    inertial.mass = mass_of(solid->volume);
    for (std::size_t i = 0; i < 3; ++i) {
      inertial.tensor[i][i] = (inertial.mass.number * solid->gyration_squared[i]).expand();
    }
    return inertial;
  }

  // From one end to the other: the first size is that across, and no orientation counts.
  std::optional<MjcfSolid> between(const FileNumbers& ends, Pose& pose) {
    const Vec3 from = as_vector(ends.numbers), to = {ends.numbers[3], ends.numbers[4], ends.numbers[5]};
    const Vec3 direction = to - from;
    const Vec3 position = values_.length_vector(item_, "pos");
    if (mjcf_size_count(type_) < 2 || !vanishes(dot(position, position))) {
      values_.diagnostics().error(
          ends.spot.place,
          ends.spot.what + (mjcf_size_count(type_) < 2 ? " of a " + type_ : " beside pos") + " has no meaning",
          "capsules, cylinders, boxes and ellipsoids can be given by fromto, instead of by pos");
      return std::nullopt;
    }
    if (vanishes(dot(direction, direction))) {
      values_.diagnostics().error(ends.spot.place, ends.spot.what + ": its two ends are the same", "write two points");
      return std::nullopt;
    }
    const auto across = sizes(1);
    if (!across) return std::nullopt;
    pose.place = geom_.element->place;
    pose.displacements.push_back(translation(Number(1) / 2 * (from + to)));
    for (const Displacement& turn : turn_from_z(direction, ends.spot, values_.text(item_, "fromto"), values_.context()))
      pose.displacements.push_back(turn);
    const Number half = rationalised(exact_root(dot(direction, direction)) / 2);
    std::vector<Number> half_lengths(mjcf_size_count(type_), (*across)[0]);
    half_lengths.back() = half;
    return mjcf_solid(type_, half_lengths);
  }

  const MjcfGeom& geom_;
  const MjcfModel& model_;
  const MjcfValues& values_;
  MjcfMeshes& meshes_;
  MjcfItem item_;
  std::string type_;
};

}  // namespace

std::vector<Inertial> inertials_of_geoms(const MjcfBody& body, const std::string& name, const MjcfModel& model,
                                         MjcfMeshes& meshes) {
  std::vector<Inertial> inertials;
  for (const MjcfGeom& geom : body.geoms) {
    if (const std::optional<Inertial> inertial = GeomReader(geom, name, model, meshes).read())
      inertials.push_back(*inertial);
  }
  return inertials;
}

}  // namespace flatdyn
