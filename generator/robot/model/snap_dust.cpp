// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/snap_dust.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "robot/model/physical_inertia.hpp"

namespace flatdyn {
namespace {

constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};

bool is_number(const Number& a) { return !has_symbols(a); }

GiNaC::numeric largest_of(const Vec3& v) {
  GiNaC::numeric largest = 0;
  for (const Number& each : v) {
    if (is_number(each)) largest = std::max(largest, magnitude(each));
  }
  return largest;
}

GiNaC::numeric largest_of(const Pose& pose) {
  GiNaC::numeric largest = 0;
  for (const Displacement& displacement : pose.displacements) {
    largest = std::max(largest, largest_of(displacement.translation));
  }
  return largest;
}

// The largest length in the parts that joints move, and the largest of all.
struct Sizes {
  GiNaC::numeric moving = 0, all = 0;

  void add(const GiNaC::numeric& length, bool moves) {
    all = std::max(all, length);
    if (moves) moving = std::max(moving, length);
  }
};

Sizes sizes_of(const Robot& robot) {
  const std::vector<bool> moves = moving_links(robot);
  Sizes sizes;
  for (const Joint& joint : robot.joints) {
    sizes.add(largest_of(joint.origin), moves[static_cast<std::size_t>(joint.parent)]);
    sizes.add(largest_of(joint.link_offset), moves[static_cast<std::size_t>(joint.child)]);
  }
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    for (const Inertial& inertial : robot.links[l].inertials) {
      sizes.add(largest_of(inertial.frame), moves[l]);
      sizes.add(largest_of(inertial.centre_of_mass), moves[l]);
    }
  }
  sizes.add(largest_of(robot.tip_offset), moves[static_cast<std::size_t>(robot.tip)]);
  return sizes;
}

// The direction at the nearest multiple of pi/12 in the plane of two axes, if (x, y), of length 1, is close enough to
// it.
std::optional<std::pair<Number, Number>> twelfth_near(double x, double y, double part) {
  const auto n = static_cast<int>(std::lround(std::atan2(y, x) * 12 / std::numbers::pi));
  const Number angle = n * GiNaC::Pi / 12;
  const std::pair<Number, Number> exact = {GiNaC::cos(angle), GiNaC::sin(angle)};
  const double distance = std::hypot(x - nearest_double(exact.first), y - nearest_double(exact.second));
  if (distance >= part) return std::nullopt;
  return exact;
}

class DustSnapper {
 public:
  DustSnapper(const Number& part, Robot& robot) : part_(magnitude(part)), robot_(robot), size_(robot_size(robot)) {}

  void run() {
    snap_gravity();
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) snap_joint(j);
    for (std::size_t l = 0; l < robot_.links.size(); ++l) snap_link(l);
    for (std::size_t l = 0; l < robot_.loops.size(); ++l) snap_loop(l);
    snap_pose([](Robot& robot) -> Pose& { return robot.tip_offset; }, "tip");
  }

 private:
  // Finds a vector or a pose in this robot or in a copy of it.
  using VectorIn = std::function<Vec3&(Robot&)>;
  using PoseIn = std::function<Pose&(Robot&)>;

  struct Subject {
    Snap::Kind kind;
    std::string what;
    Place place;
  };

  bool is_dust(const Number& a, const GiNaC::numeric& beside) const {
    return is_rational(a) && !a.is_zero() && magnitude(a) < part_ * beside;
  }

  // `label`: the name of the component. `shown`: the number as written; for an axis, divided by the axis's length.
  void record(const Subject& subject, const std::string& label, const Number& shown, const Number& exact,
              std::function<void(Robot&)> undo) {
    constexpr int kDigits = 50;
    robot_.snaps.push_back({subject.place, subject.what + ", " + label, fmt::format("{}", nearest_double(shown)), exact,
                            exact_decimal(to_decimal(exact - shown, kDigits)), subject.kind, std::move(undo)});
  }

  void clear_dust(const VectorIn& at, const GiNaC::numeric& beside, const Subject& subject) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Number written = at(robot_)[k];
      if (!is_dust(written, beside)) continue;
      record(subject, kAxisNames[k], written, 0, [at, k, written](Robot& robot) { at(robot)[k] = written; });
      at(robot_)[k] = 0;
    }
  }

  void snap_gravity() {
    clear_dust([](Robot& robot) -> Vec3& { return robot.gravity; }, largest_of(robot_.gravity),
               {Snap::Kind::gravity, "gravity", {robot_.file, 0}});
  }

  void snap_lengths(const VectorIn& at, const std::string& what, const Place& place) {
    clear_dust(at, size_, {Snap::Kind::length, what, place});
  }

  void snap_pose(const PoseIn& at, const std::string& what) {
    for (std::size_t d = 0; d < at(robot_).displacements.size(); ++d) {
      snap_lengths([at, d](Robot& robot) -> Vec3& { return at(robot).displacements[d].translation; }, what,
                   at(robot_).place);
    }
  }

  void snap_axis(const VectorIn& at, const std::string& what, const Place& place) {
    const Vec3 written = at(robot_);
    if (!std::all_of(written.begin(), written.end(), is_rational) || vanishes(dot(written, written))) return;
    const Vec3 unit = Number(1 / GiNaC::sqrt(dot(written, written))) * written;
    const Vec3 exact = exact_axis(written, unit);
    for (std::size_t k = 0; k < 3; ++k) {
      if (exact[k].is_equal(written[k])) continue;
      // The undo restores the whole axis: a single component as written would belong to an axis of another length.
      record({Snap::Kind::axis, what, place}, kAxisNames[k], unit[k], exact[k],
             [at, written](Robot& robot) { at(robot) = written; });
    }
    at(robot_) = exact;
  }

  // `written` without dust, or a unit vector if its direction is one of the exact ones. `unit`: `written` at length 1.
  Vec3 exact_axis(const Vec3& written, const Vec3& unit) const {
    Vec3 exact = written;
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(nearest_double(unit[k])) < part_.to_double()) exact[k] = 0;
      if (!exact[k].is_zero()) left.push_back(k);
    }
    if (left.size() != 2) return exact;
    const std::size_t i = left[0], j = left[1];
    const auto twelfth = twelfth_near(nearest_double(unit[i]), nearest_double(unit[j]), part_.to_double());
    const bool is_there = !twelfth || vanishes(written[i] * twelfth->second - written[j] * twelfth->first);
    if (!is_there) std::tie(exact[i], exact[j]) = *twelfth;
    return exact;
  }

  void snap_joint(std::size_t j) {
    const Joint& joint = robot_.joints[j];
    const std::string what = "joint \"" + joint.name + "\"";
    snap_pose([j](Robot& robot) -> Pose& { return robot.joints[j].origin; }, what + ", origin");
    snap_pose([j](Robot& robot) -> Pose& { return robot.joints[j].link_offset; }, what + ", frame of its link");
    if (joint.type != JointType::fixed || joint.held) {
      snap_axis([j](Robot& robot) -> Vec3& { return robot.joints[j].axis; }, what + ", axis", joint.place);
    }
    if (!joint.motor) return;
    const Place place = joint.motor->place;
    snap_axis([j](Robot& robot) -> Vec3& { return robot.joints[j].motor->axis; }, what + ", motor, axis", place);
    snap_lengths([j](Robot& robot) -> Vec3& { return robot.joints[j].motor->position; }, what + ", motor, position",
                 place);
  }

  void snap_link(std::size_t l) {
    const std::string what = "link \"" + robot_.links[l].name + "\"";
    for (std::size_t i = 0; i < robot_.links[l].inertials.size(); ++i) {
      const Place place = robot_.links[l].inertials[i].place;
      snap_pose([l, i](Robot& robot) -> Pose& { return robot.links[l].inertials[i].frame; }, what + ", inertial");
      snap_lengths([l, i](Robot& robot) -> Vec3& { return robot.links[l].inertials[i].centre_of_mass; },
                   what + ", centre of mass", place);
      snap_products(l, i, {Snap::Kind::product_of_inertia, what + ", inertia", place});
    }
  }

  // The reference for a product of inertia: the smaller moment about its two axes. A body without a moment about an
  // axis has no products with it.
  static GiNaC::numeric beside_product(const Mat3& tensor, std::size_t a, std::size_t b) {
    if (!is_number(tensor[a][a]) || !is_number(tensor[b][b])) return 0;
    const GiNaC::numeric first = magnitude(tensor[a][a]), second = magnitude(tensor[b][b]);
    return first.is_zero() || second.is_zero() ? std::max(first, second) : std::min(first, second);
  }

  void snap_products(std::size_t l, std::size_t i, const Subject& subject) {
    Inertial& inertial = robot_.links[l].inertials[i];
    const Inertial written = inertial;
    const std::size_t before = robot_.snaps.size();
    for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>(0, 1), {0, 2}, {1, 2}}) {
      if (is_dust(written.tensor[a][b], beside_product(written.tensor, a, b))) clear_product(l, i, a, b, subject);
    }
    if (fault_of_inertia(central_tensor(written)) || !fault_of_inertia(central_tensor(inertial))) return;
    inertial = written;
    robot_.snaps.erase(robot_.snaps.begin() + static_cast<std::ptrdiff_t>(before), robot_.snaps.end());
  }

  void clear_product(std::size_t l, std::size_t i, std::size_t a, std::size_t b, const Subject& subject) {
    const auto put = [l, i, a, b](Robot& robot, const Number& number) {
      Mat3& tensor = robot.links[l].inertials[i].tensor;
      tensor[a][b] = tensor[b][a] = number;
    };
    const Number product = robot_.links[l].inertials[i].tensor[a][b];
    record(subject, std::string(kAxisNames[a]) + kAxisNames[b], product, 0,
           [put, product](Robot& robot) { put(robot, product); });
    put(robot_, 0);
  }

  // Finds a loop. By the time that a snap is undone, a loop may have become coupled joints and left the robot: nothing
  // depends on its points then, and a copy that belongs to no robot stands in for it.
  std::function<Loop&(Robot&)> loop_at(std::size_t l) const {
    return [copy = std::make_shared<Loop>(robot_.loops[l])](Robot& robot) -> Loop& {
      const auto found = std::find_if(robot.loops.begin(), robot.loops.end(), [&copy](const Loop& loop) {
        return loop.place == copy->place && name_of(loop) == name_of(*copy);
      });
      return found == robot.loops.end() ? *copy : *found;
    };
  }

  void snap_loop(std::size_t l) {
    const auto at = loop_at(l);
    const Place place = robot_.loops[l].place;
    for (std::size_t e = 0; e < 2; ++e) {
      const std::string what = std::string("loop, ") + (e == 0 ? "from" : "to");
      snap_lengths([at, e](Robot& robot) -> Vec3& { return at(robot).points[e]; }, what, place);
      if (!robot_.loops[l].axes) continue;
      snap_axis([at, e](Robot& robot) -> Vec3& { return (*at(robot).axes)[e]; }, what + ", axis", place);
    }
  }

  const GiNaC::numeric part_;
  Robot& robot_;
  const GiNaC::numeric size_;
};

}  // namespace

GiNaC::numeric robot_size(const Robot& robot) {
  const GiNaC::numeric of_dust(1, 1000000), largest = 100;
  const Sizes sizes = sizes_of(robot);
  const GiNaC::numeric size = sizes.moving < sizes.all * of_dust ? sizes.all : sizes.moving;
  return std::min(size, largest);
}

void snap_dust(const Number& part, Robot& robot) {
  if (!part.is_zero()) DustSnapper(part, robot).run();
}

}  // namespace flatdyn
