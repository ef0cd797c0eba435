// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/regressor.hpp"

#include "derivation/dynamics/centres.hpp"
#include "derivation/dynamics/dry_friction.hpp"
#include "derivation/dynamics/twists.hpp"

namespace flatdyn {
namespace {

// Î ω̇ + ω × Î ω for a unit entry of Î, from products that the parameters of a body share.
Vec3 unit_moment(Derivation& d, Parameter parameter, const BodyMotion& body, const std::string& n) {
  const Mat3 &W = body.products, &U = body.U;
  const Vec3& dw = body.domega;
  const auto difference = [&](std::size_t a, std::size_t b) {
    return d.named(U[a][a] - U[b][b], "U_" + n + "_" + std::to_string(a) + std::to_string(b));
  };
  switch (parameter) {
    case Parameter::Ixx:
      return {dw[0], W[0][2], -W[0][1]};
    case Parameter::Iyy:
      return {-W[1][2], dw[1], W[0][1]};
    case Parameter::Izz:
      return {W[1][2], -W[0][2], dw[2]};
    case Parameter::Ixy:
      return {-U[2][0], U[2][1], difference(0, 1)};
    case Parameter::Ixz:
      return {U[1][0], difference(2, 0), -U[1][2]};
    case Parameter::Iyz:
      return {difference(1, 2), -U[0][1], U[0][2]};
    default:
      return zero_vector();
  }
}

// The wrench for a unit parameter of a body, about the origin of its frame.
Wrench unit_wrench(Derivation& d, Parameter parameter, const BodyMotion& body, const std::string& n) {
  const Mat3& U = body.U;
  const Vec3& a = body.ddp;
  switch (parameter) {
    case Parameter::m:
      return {a, zero_vector()};
    case Parameter::mlx:
      return {{U[0][0], U[1][0], U[2][0]}, {0, -a[2], a[1]}};
    case Parameter::mly:
      return {{U[0][1], U[1][1], U[2][1]}, {a[2], 0, -a[0]}};
    case Parameter::mlz:
      return {{U[0][2], U[1][2], U[2][2]}, {-a[1], a[0], 0}};
    default:
      return {zero_vector(), unit_moment(d, parameter, body, n)};
  }
}

bool is_zero(const Vec3& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

class Columns {
 public:
  Columns(Frames& frames, const JointMotion& motion)
      : frames_(frames),
        motion_(motion),
        bodies_(body_motions(frames, motion)),
        twists_(unit_twists(frames)),
        centres_(frames),
        zeros_(bodies_.size(), 0) {}

  std::vector<Number> column(int index) {
    const int j = joint_of(index);
    const auto jj = static_cast<std::size_t>(j);
    std::vector<Number> entries = zeros_;
    switch (parameter_of(index)) {
      case Parameter::Im:
        return rotor_column(j);
      case Parameter::Fv:
        entries[jj] = motion_.qd_r[jj];
        return entries;
      case Parameter::Fs:
        entries[jj] = sliding_sign(frames_.derivation(), frames_.body(j), motion_.qd_r[jj], frames_.label(j));
        return entries;
      default:
        break;
    }
    const Wrench wrench = unit_wrench(frames_.derivation(), parameter_of(index), bodies_[jj], frames_.label(j));
    for (const auto& [i, twist] : twists_[jj]) {
      const int centre = is_zero(twist.v) ? -1 : centres_.centre_of(i);
      entries[static_cast<std::size_t>(i)] =
          centre < 0 ? power(twist, wrench) : dot(twist.omega, moment_about(centre, wrench, index));
    }
    return named(entries, index);
  }

 private:
  // The moment of a unit parameter's wrench about a point where axes meet.
  Vec3 moment_about(int centre, const Wrench& wrench, int index) {
    const Vec3 lever = centres_.lever(centre, joint_of(index));
    return frames_.derivation().named(wrench.mu + cross(lever, wrench.f),
                                      "n_" + frames_.label(centre) + "_" + name_of(index));
  }

  // The rotor's column: the last two terms of (7.105), and k_r (ω̇_c · z_m + k_r q̈) at the joint itself, (7.114).
  std::vector<Number> rotor_column(int j) {
    Derivation& d = frames_.derivation();
    const auto jj = static_cast<std::size_t>(j);
    const auto& rotor = frames_.mechanism().bodies[jj].rotor;
    std::vector<Number> entries = zeros_;
    const Number ratio = rotor ? d.named(rotor->gear_ratio, "k_r" + frames_.label(j)) : Number(1);
    const Number spin = d.named(ratio * motion_.qdd_r[jj], "spin_" + frames_.label(j));
    entries[jj] = ratio * spin;
    if (rotor && rotor->carrier >= 0) {
      const auto c = static_cast<std::size_t>(rotor->carrier);
      const BodyMotion& carrier = bodies_[c];
      const Vec3& z = frames_.rotor_axis(j);
      entries[jj] += ratio * d.named(dot(z, carrier.domega), "domega_m" + frames_.label(j));
      const Vec3 momentum = ratio * rate_times_omega(motion_, j, carrier.omega, carrier.omega_r);
      const Vec3 reaction = d.named(spin * z + cross(momentum, z), "mu_m" + frames_.label(j));
      for (const auto& [i, twist] : twists_[c]) {
        entries[static_cast<std::size_t>(i)] += power(twist, {zero_vector(), reaction});
      }
    }
    return named(entries, index_of(j, Parameter::Im));
  }

  std::string name_of(int index) const { return parameter_name(index, frames_.mechanism().base_bodies()); }

  std::vector<Number> named(std::vector<Number> entries, int index) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i] =
          frames_.derivation().named(entries[i], "y_" + frames_.label(static_cast<int>(i)) + "_" + name_of(index));
    }
    return entries;
  }

  Frames& frames_;
  const JointMotion& motion_;
  std::vector<BodyMotion> bodies_;
  std::vector<std::map<int, Twist>> twists_;
  Centres centres_;
  std::vector<Number> zeros_;
};

}  // namespace

Rows regressor(Frames& frames, const JointMotion& motion, const std::vector<int>& columns) {
  Columns source(frames, motion);
  Rows Y(static_cast<std::size_t>(frames.mechanism().body_count()));
  for (const int index : columns) {
    const std::vector<Number> column = source.column(index);
    for (std::size_t i = 0; i < Y.size(); ++i) Y[i].push_back(column[i]);
  }
  return Y;
}

}  // namespace flatdyn
