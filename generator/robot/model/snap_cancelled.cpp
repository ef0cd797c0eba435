// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/snap_cancelled.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "robot/model/physical_inertia.hpp"
#include "robot/model/rational_rotation.hpp"
#include "robot/model/snap_axis_angles.hpp"
#include "robot/model/snap_dust.hpp"

namespace flatdyn {
namespace {

// An inertial of the robot and the orientation of its axes in the frame of the body that it is part of.
struct Part {
  std::size_t link = 0, index = 0;
  Mat3 R = identity_matrix();

  Inertial& in(Robot& robot) const { return robot.links[link].inertials[index]; }
};

bool all_rational(const InertialParameters& body) {
  const auto rational = [](const Vec3& v) { return std::all_of(v.begin(), v.end(), is_rational); };
  return is_rational(body.mass) && rational(body.first_moment) &&
         std::all_of(body.inertia.begin(), body.inertia.end(), rational);
}

class CancelledDust {
 public:
  CancelledDust(const Number& part, Robot& robot)
      : part_(magnitude(part)), robot_(robot), size_(robot_size(robot)), mechanism_(make_mechanism(robot)) {}

  // The order matters: distances depend on the frames' orientations, moments on their origins, products on the centres
  // of mass.
  Mechanism run() {
    snap_axis_angles(part_, robot_, mechanism_);
    for (int body = 0; body < mechanism_.body_count(); ++body) snap_distances(body);
    for (int body = 0; body < mechanism_.body_count(); ++body) snap_first_moments(body);
    for (int body = 0; body < mechanism_.body_count(); ++body) snap_products(body);
    return mechanism_;
  }

 private:
  struct Subject {
    Snap::Kind kind;
    std::string what, label;
  };
  using Change = std::function<void(Inertial&, int sign)>;

  const InertialParameters& inertia(int body) const {
    return mechanism_.bodies[static_cast<std::size_t>(body)].inertia;
  }

  bool is_dust(const Number& a, const GiNaC::numeric& beside) const {
    return !a.is_zero() && magnitude(a) < part_ * beside;
  }

  const Vec3& distance(int body) const { return mechanism_.bodies[static_cast<std::size_t>(body)].p; }

  // Snaps the displacement of a joint's frame from its parent's.
  void snap_distances(int body) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Number found = distance(body)[k];
      if (is_rational(found) && is_dust(found, size_)) move_origin(body, k, found);
    }
  }

  void move_origin(int body, std::size_t k, const Number& found) {
    const std::string name = mechanism_.bodies[static_cast<std::size_t>(body)].joint;
    const auto joint = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&name](const Joint& each) { return each.name == name; });
    Pose& origin = joint->origin;
    const Mat3& R = mechanism_.links[static_cast<std::size_t>(joint->parent)].R;
    Vec3 missing = zero_vector();
    missing[k] = -found;
    Displacement step;
    step.translation = expanded(transpose(R * exact_rotation(origin)) * missing);
    origin.displacements.push_back(step);
    Mechanism moved = make_mechanism(robot_);
    if (!moved.bodies[static_cast<std::size_t>(body)].p[k].is_zero()) {
      origin.displacements.pop_back();
      return;
    }
    mechanism_ = std::move(moved);
    const std::size_t at = origin.displacements.size() - 1,
                      index = static_cast<std::size_t>(joint - robot_.joints.begin());
    record({Snap::Kind::length, fmt::format("joint \"{}\", distance from the joint before", name), {"xyz"[k]}}, found,
           joint->place,
           [index, at](Robot& robot) { robot.joints[index].origin.displacements[at].translation = zero_vector(); });
  }

  std::optional<Part> heaviest_part(int body) const {
    std::optional<Part> heaviest;
    GiNaC::numeric largest = 0;
    for (std::size_t l = 0; l < robot_.links.size(); ++l) {
      if (mechanism_.links[l].body != body) continue;
      for (std::size_t i = 0; i < robot_.links[l].inertials.size(); ++i) {
        const Inertial& inertial = robot_.links[l].inertials[i];
        if (!is_rational(inertial.mass.number) || magnitude(inertial.mass.number) <= largest) continue;
        largest = magnitude(inertial.mass.number);
        heaviest = Part{l, i, expanded(mechanism_.links[l].R * exact_rotation(inertial.frame))};
      }
    }
    return heaviest;
  }

  void snap_first_moments(int body) {
    const InertialParameters before = inertia(body);
    const std::optional<Part> part = heaviest_part(body);
    if (!part || !all_rational(before)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const Number& moment = before.first_moment[k];
      if (!is_dust(moment, magnitude(before.mass) * size_)) continue;
      Vec3 shift = zero_vector();
      shift[k] = -moment / part->in(robot_).mass.number;
      const Vec3 by = expanded(transpose(part->R) * shift);
      apply(*part, {Snap::Kind::first_moment, "first moment", std::string(1, "xyz"[k])}, moment,
            [by](Inertial& inertial, int sign) {
              inertial.centre_of_mass = expanded(inertial.centre_of_mass + Number(sign) * by);
            });
    }
  }

  void snap_products(int body) {
    const std::optional<Part> part = heaviest_part(body);
    for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>(0, 1), {0, 2}, {1, 2}}) {
      const InertialParameters now = inertia(body);
      if (!part || !all_rational(now)) return;
      const Number& product = now.inertia[a][b];
      if (!is_dust(product, std::min(magnitude(now.inertia[a][a]), magnitude(now.inertia[b][b])))) continue;
      Mat3 missing = zero_matrix();
      missing[a][b] = missing[b][a] = -product;
      const Mat3 by = expanded(transpose(part->R) * missing * part->R);
      apply(*part, {Snap::Kind::product_of_inertia, "inertia", {"xyz"[a], "xyz"[b]}}, product,
            [by](Inertial& inertial, int sign) {
              for (std::size_t row = 0; row < 3; ++row) {
                inertial.tensor[row] = expanded(inertial.tensor[row] + Number(sign) * by[row]);
              }
            });
    }
  }

  // Applies a change, unless a physically possible body would become an impossible one.
  void apply(const Part& part, const Subject& subject, const Number& moment, const Change& change) {
    Inertial& inertial = part.in(robot_);
    const bool could_exist = !fault_of_inertia(central_tensor(inertial));
    change(inertial, 1);
    if (could_exist && fault_of_inertia(central_tensor(inertial))) {
      change(inertial, -1);
      return;
    }
    mechanism_ = make_mechanism(robot_);
    const std::string what = fmt::format("what moves with link \"{}\", {}", robot_.links[part.link].name, subject.what);
    record({subject.kind, what, subject.label}, moment, inertial.place,
           [part, change](Robot& robot) { change(part.in(robot), -1); });
  }

  void record(const Subject& subject, const Number& found, const Place& place, std::function<void(Robot&)> undo) {
    constexpr int kDigits = 50;
    robot_.snaps.push_back({place, fmt::format("{}, {} of its frame in flatdyn", subject.what, subject.label),
                            fmt::format("{}", nearest_double(found)), 0, exact_decimal(to_decimal(-found, kDigits)),
                            subject.kind, std::move(undo)});
  }

  const GiNaC::numeric part_;
  Robot& robot_;
  const GiNaC::numeric size_;
  Mechanism mechanism_;
};

}  // namespace

Mechanism snap_cancelled(const Number& part, Robot& robot) {
  return part.is_zero() ? make_mechanism(robot) : CancelledDust(part, robot).run();
}

}  // namespace flatdyn
