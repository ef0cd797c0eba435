// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "flatdyn/reference/newton_euler.hpp"
#include "fuzz/byte_files.hpp"
#include "fuzz/readers.hpp"
#include "robot/input/reader.hpp"
#include "robot/model/mechanism.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn::testing {
namespace {

constexpr std::size_t kMostLinks = 8;  // largest robot that is processed further
constexpr int kMostBits = 1 << 16;     // largest size of a number from a file; a rotation has some hundred bits

bool is_small(const Number& value) {
  if (!is_rational(value)) return true;  // free symbols: the reader checks the size of their numbers
  const auto& number = GiNaC::ex_to<GiNaC::numeric>(value);
  return number.numer().int_length() <= kMostBits && number.denom().int_length() <= kMostBits &&
         std::isfinite(nearest_double(value));
}

void require_numbers(const Vec3& vector) {
  for (const Number& value : vector) require(is_small(value), "a number of the mechanism has grown beyond measure");
}

void require_rotation(const PlanarRotation& rotation) {
  if (!is_rational(rotation.c)) return;
  require(vanishes(rotation.c * rotation.c + rotation.s * rotation.s - 1), "a rotation is none");
  require(is_small(rotation.c) && is_small(rotation.s), "a rotation's numbers have grown beyond measure");
}

// Requires exact rotations, and numbers that doubles can hold.
void require_canonical(const Mechanism& mechanism) {
  for (const Body& body : mechanism.bodies) {
    for (const PlanarRotation& rotation : {body.beta, body.alpha, body.theta}) require_rotation(rotation);
    require_numbers(body.p);
    require_numbers(body.inertia.first_moment);
    for (const Vec3& row : body.inertia.inertia) require_numbers(row);
    require_numbers({body.inertia.mass, body.armature, body.viscous});
  }
}

// Requires that the torques of some motion are numbers.
void require_torques(const Robot& robot, Eigen::Index joints) {
  const reference::Robot<double> numbers = reference_robot<double>(robot, random_symbol_values(robot, 1));
  const Eigen::VectorXd motion = Eigen::VectorXd::LinSpaced(joints, -1, 1);
  const Eigen::VectorXd tau = reference::inverse_dynamics<double>(numbers, motion, motion, motion);
  require(robot.symbols.empty() == false || tau.allFinite(), "a torque is not finite");
}

void carry_further(const Robot& robot) {
  if (robot.links.size() > kMostLinks) return;
  try {
    const Mechanism mechanism = make_mechanism(robot);
    require_canonical(mechanism);
    // With loops, these may be open there, or singular.
    if (!mechanism.has_loops()) require_torques(robot, mechanism.size());
  } catch (const Failure& failure) {
    if (failure.kind() != FailureKind::unsupported) throw;
  }
}

void read(const std::string& path, const ReadOptions& options) {
  Diagnostics diagnostics;
  std::optional<Robot> robot;
  try {
    robot = read_robot(path, options, diagnostics);
  } catch (const Failure& failure) {
    if (failure.kind() != FailureKind::io) throw;  // about a file that it names
    return;
  }
  require(robot.has_value() == !diagnostics.has_errors(), "refused without an error, or accepted with one");
  for (const Diagnostic& found : diagnostics.all()) require(!found.message.empty(), "a diagnostic without a message");
  if (robot) carry_further(*robot);
}

}  // namespace

void read_urdf_bytes(std::string_view bytes) { read(file_of(bytes, "robot.urdf"), {}); }

void read_mjcf_bytes(std::string_view bytes) { read(file_of(bytes, "robot.xml"), {}); }
void read_sdf_bytes(std::string_view bytes) { read(file_of(bytes, "robot.sdf"), {}); }

void read_toml_bytes(std::string_view bytes) { read(file_of(bytes, "robot.toml"), {}); }

void read_scene_bytes(std::string_view bytes) {
  static const std::string arm = file_of(kArm, "arm.toml");
  ReadOptions options;
  options.scene_file = file_of(bytes, "scene.toml");
  read(arm, options);
}

}  // namespace flatdyn::testing
