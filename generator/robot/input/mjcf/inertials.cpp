// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/inertials.hpp"

#include "robot/input/common/poses.hpp"
#include "robot/input/mjcf/geoms.hpp"
#include "robot/model/exact_sign.hpp"

namespace flatdyn {

namespace {

void read_moments(const MjcfItem& item, const MjcfValues& values, Inertial& inertial) {
  const auto full = values.numbers(item, "fullinertia", 6, 6);
  const auto diagonal = values.numbers(item, "diaginertia", 3, 3);
  if (full) {
    const std::vector<Number>& m = full->numbers;
    inertial.tensor = {Vec3{m[0], m[3], m[4]}, Vec3{m[3], m[1], m[5]}, Vec3{m[4], m[5], m[2]}};
    for (const char* other : {"diaginertia", "quat", "axisangle", "euler", "xyaxes", "zaxis"}) {
      if (values.find(item, other) == nullptr) continue;
      values.diagnostics().error(values.find(item, other)->place, item.what + " has both fullinertia and " + other,
                                 "keep one");
    }
  } else if (diagonal) {
    for (std::size_t i = 0; i < 3; ++i) inertial.tensor[i][i] = diagonal->numbers[i];
  }
}

// Whether no eigenvalue of a symmetric matrix is negative: all principal minors are at least 0.
bool is_at_least_zero(const Mat3& m) {
  const auto minor = [&m](std::size_t i, std::size_t j) { return m[i][i] * m[j][j] - m[i][j] * m[j][i]; };
  const Number determinant = dot(m[0], cross(m[1], m[2]));
  for (const Number& value : {m[0][0], m[1][1], m[2][2], minor(0, 1), minor(0, 2), minor(1, 2), determinant}) {
    if (is_negative(value)) return false;
  }
  return true;
}

bool is_diagonal(const Mat3& m) { return vanishes(m[0][1]) && vanishes(m[0][2]) && vanishes(m[1][2]); }

Number larger(const Number& a, const Number& b) { return is_below(a, b) ? b : a; }

Mat3 multiple_of_one(const Number& a) { return {Vec3{a, 0, 0}, Vec3{0, a, 0}, Vec3{0, 0, a}}; }

// One body's inertia within the bounds.
class InertiaBounds {
 public:
  InertiaBounds(std::vector<Inertial>& inertials, const MjcfBody& body, const MjcfModel& model)
      : inertials_(inertials), body_(body), settings_(model.settings), diagnostics_(model.diagnostics()) {}

  void apply() {
    if (settings_.least_inertia) bound_inertia(*settings_.least_inertia);
    if (settings_.balances_inertia && inertials_.size() == 1) balance(inertials_.front().tensor);
    if (settings_.least_mass) bound_mass(*settings_.least_mass);
  }

 private:
  Number mass() const {
    Number sum = 0;
    for (const Inertial& each : inertials_) sum += each.mass.number;
    return sum;
  }

  Vec3 centre_of_mass() const {
    Vec3 moment = zero_vector();
    for (const Inertial& each : inertials_) moment = moment + each.mass.number * exact_place(each.frame).p;
    return vanishes(mass()) ? zero_vector() : (1 / mass()) * moment;
  }

  // A point of the missing mass at the centre.
  void bound_mass(const Value& least) {
    const Number missing = least.number - mass();
    if (nearest_double(missing) <= 0) return;
    Inertial point;
    point.mass = {missing, least.place};
    point.frame = {{translation(centre_of_mass())}, body_.element->place};
    point.place = body_.element->place;
    inertials_.push_back(point);
  }

  void bound_inertia(const Value& least) {
    if (inertials_.empty()) {
      Inertial none;
      none.place = body_.element->place;
      none.mass.place = none.place;
      inertials_.push_back(none);
    }
    if (inertials_.size() == 1 && is_diagonal(inertials_.front().tensor)) {
      Mat3& tensor = inertials_.front().tensor;
      for (std::size_t i = 0; i < 3; ++i) tensor[i][i] = larger(tensor[i][i], least.number);
    } else if (!is_at_least_zero(whole() - multiple_of_one(least.number))) {
      diagnostics_.unsupported(least.place,
                               "compiler, boundinertia: the bound on the inertia of " +
                                   name_in_messages(*body_.element) +
                                   ", which is not given along its principal axes, is not supported",
                               "give that body an <inertial> with diaginertia");
    }
  }

  // About the centre of mass, along the body's axes.
  Mat3 whole() const {
    const Vec3 centre = centre_of_mass();
    Mat3 sum = zero_matrix();
    for (const Inertial& each : inertials_) {
      const ExactPlace place = exact_place(each.frame);
      sum = sum + place.R * each.tensor * transpose(place.R) + steiner(each.mass.number, place.p - centre);
    }
    return expanded(sum);
  }

  // Where a moment is larger than the other two together, all become their mean.
  static void balance(Mat3& tensor) {
    const Number trace = tensor[0][0] + tensor[1][1] + tensor[2][2];
    if (!is_at_least_zero(multiple_of_one(trace / 2) - tensor)) tensor = multiple_of_one(trace / 3);
  }

  std::vector<Inertial>& inertials_;
  const MjcfBody& body_;
  const MjcfSettings& settings_;
  Diagnostics& diagnostics_;
};

std::vector<Inertial> inertials_of(const MjcfBody& body, const MjcfModel& model, MjcfMeshes& meshes) {
  const InertiaFromGeom from = model.settings.inertia_from_geom;
  const bool by_geoms = from == InertiaFromGeom::always || (from == InertiaFromGeom::where_missing && !body.inertial);
  // Meshes of what stands still may be missing.
  if (by_geoms && (body.moves || model.settings.total_mass)) {
    const std::string name = model.robot.links[static_cast<std::size_t>(body.link)].name;
    std::vector<Inertial> found = inertials_of_geoms(body, name, model, meshes);
    if (!found.empty() || !body.inertial) return found;
  }
  return body.inertial ? std::vector<Inertial>{*body.inertial} : std::vector<Inertial>{};
}

void scale_to_total(const Number& total, Robot& robot) {
  Number sum = 0;
  for (const Link& link : robot.links) {
    for (const Inertial& inertial : link.inertials) sum += inertial.mass.number;
  }
  if (vanishes(sum)) return;
  const Number factor = total / sum;
  for (Link& link : robot.links) {
    for (Inertial& inertial : link.inertials) {
      inertial.mass.number = factor * inertial.mass.number;
      for (Vec3& row : inertial.tensor) row = factor * row;
    }
  }
}

}  // namespace

Inertial mjcf_inertial(const FileNode& element, const Pose& frame, const std::string& body, bool moves,
                       const MjcfModel& model) {
  MjcfItem item = MjcfValues::plain(element);
  item.what = "body \"" + body + "\", inertial";
  Inertial inertial;
  inertial.place = element.place;
  for (const char* needed : {"pos", "mass"}) {
    if (element.attribute(needed) != nullptr) continue;
    model.diagnostics().error(element.place, item.what + " has no " + needed,
                              "write <inertial pos= mass= diaginertia=/>");
  }
  inertial.mass = model.values.number_or(item, "mass", 0);
  inertial.frame = joined(frame, mjcf_pose(item, model.values, model.settings));
  read_moments(item, model.values, inertial);
  if (moves && element.attribute("fullinertia") == nullptr && element.attribute("diaginertia") == nullptr) {
    model.diagnostics().warning(element.place, item.what + " has no diaginertia: it counts as a point mass",
                                "write diaginertia=\"...\" (kg m^2); all 0 for a point mass",
                                "bodies with a mass and no inertia, which count as point masses");
  }
  return inertial;
}

void add_mjcf_inertias(const MjcfModel& model) {
  MjcfMeshes meshes(model);
  for (const MjcfBody& body : model.bodies) {
    std::vector<Inertial> inertials = inertials_of(body, model, meshes);
    InertiaBounds(inertials, body, model).apply();
    model.robot.links[static_cast<std::size_t>(body.link)].inertials = inertials;
  }
  if (model.settings.total_mass) scale_to_total(model.settings.total_mass->number, model.robot);
}

}  // namespace flatdyn
