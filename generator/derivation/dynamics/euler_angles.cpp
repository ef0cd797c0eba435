// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/euler_angles.hpp"

#include <fmt/format.h>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/dynamics/kinematics.hpp"

namespace flatdyn {
namespace {

Vec3 last_axis(DerivationContext& context, Orientation orientation) {
  const Mat3 R = pose(context.frames, context.mechanism.tip).R;
  const std::size_t column = orientation == Orientation::zyz ? 2 : 0;
  return context.derivation.named(Vec3{R[0][column], R[1][column], R[2][column]}, "axis_e");
}

}  // namespace

void fail_without_angles(Orientation orientation) {
  const bool is_zyz = orientation == Orientation::zyz;
  throw Failure(FailureKind::unsupported,
                fmt::format("orientation: at every position of the robot the {} angles are singular",
                            is_zyz ? "ZYZ" : "roll, pitch and yaw"),
                fmt::format("write `orientation = \"{}\"`, or leave it out and name rx, ry, rz in `task`",
                            is_zyz ? "rpy" : "zyz"));
}

EulerRates::EulerRates(DerivationContext& context, Orientation orientation) : derivation_(context.derivation) {
  Derivation& d = derivation_;
  const Vec3 a = last_axis(context, orientation);
  w_ = a[2];
  s2_ = d.named(a[0] * a[0] + a[1] * a[1], "s2_e");
  if (vanishes(s2_)) fail_without_angles(orientation);
  s_ = d.sqrt(s2_, "s_e");
  const Number inverse = d.quotient(1, s2_, "d_e");
  along_x_ = d.named(a[0] * inverse, "along_x");
  along_y_ = d.named(a[1] * inverse, "along_y");
  across_x_ = d.named(along_x_ * s_, "across_x");
  across_y_ = d.named(along_y_ * s_, "across_y");
}

Vec3 EulerRates::of(const Vec3& omega) const {
  const Number psi = derivation_.named(along_x_ * omega[0] + along_y_ * omega[1], "dpsi");
  const Number theta = across_x_ * omega[1] - across_y_ * omega[0];
  return derivation_.named(Vec3{omega[2] - w_ * psi, theta, psi}, "dphi");
}

// Differentiates the rates, with ȧ = ω × a. The remaining term of ψ's is (θ̇ / s) (φ̇ - w ψ̇), where θ̇ / s needs no
// root.
Vec3 EulerRates::changes(const Vec3& omega, const Vec3& alpha) const {
  Derivation& d = derivation_;
  const Vec3 rates = of(omega);
  const Number turn = d.named(along_x_ * omega[1] - along_y_ * omega[0], "turn");
  const Number psi = d.named(along_x_ * alpha[0] + along_y_ * alpha[1] + turn * (rates[0] - w_ * rates[2]), "ddpsi");
  const Number theta = across_x_ * alpha[1] - across_y_ * alpha[0] - s_ * rates[2] * rates[0];
  const Number phi = alpha[2] + d.named(s2_ * turn, "tilt") * rates[2] - w_ * psi;
  return d.named(Vec3{phi, theta, psi}, "ddphi");
}

std::string describe_angles(Orientation orientation) {
  return orientation == Orientation::zyz
             ? "phi, theta, psi are the tip's ZYZ Euler angles, R = R_z(phi) R_y(theta) R_z(psi), 0 < theta < pi"
             : "phi, theta, psi are the tip's roll, pitch and yaw, R = R_z(phi) R_y(theta) R_x(psi), "
               "-pi/2 < theta < pi/2";
}

}  // namespace flatdyn
