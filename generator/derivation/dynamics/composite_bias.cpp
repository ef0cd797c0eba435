// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/composite_bias.hpp"

#include <algorithm>

namespace flatdyn {
namespace {

// A composite body about joint i's origin, and the motion of the parent's body there, in axes that do not turn with it.
struct AtAxis {
  Vec3 h = zero_vector();
  Mat3 I = zero_matrix();
  Vec3 omega = zero_vector(), ddp = zero_vector();
  Mat3 U = zero_matrix();
  Number domega_z = 0, difference = 0;  // difference: I_xx - I_yy
};

AtAxis at_axis(Frames& frames, int i, const LinkMotion& parent, const InertialParameters& body) {
  Derivation& d = frames.derivation();
  const std::string n = frames.label(i);
  AtAxis here;
  here.h = frames.up_to_axis(i, body.first_moment, "hu_" + n);
  here.I = frames.up_to_axis(i, body.inertia, "Iu_" + n);
  here.difference = d.named(here.I[0][0] - here.I[1][1], "Iu_" + n + "_d");
  here.omega = frames.down_to_axis(i, parent.omega, "omega_o_" + n);
  here.ddp = frames.down_to_axis(i, d.named(parent.ddp + parent.U * frames.p(i), "ddp_o_" + n), "ddp_o_" + n);
  here.U = frames.down_to_axis(i, parent.U, "U_o_" + n);
  here.domega_z = d.named(dot(frames.axis_in_parent(i), parent.domega), "domega_r_" + n + "_z");
  return here;
}

// The moment about the axis of composite body i when its joint is locked.
Number carried_moment(Derivation& d, const AtAxis& here, const std::string& n) {
  const Number xy = d.named(here.omega[0] * here.omega[1], "omega_o_" + n + "_xy");
  const Number squares = d.named(here.U[1][1] - here.U[0][0], "U_o_" + n + "_yy_xx");
  return here.h[0] * here.ddp[1] - here.h[1] * here.ddp[0] + here.domega_z * here.I[2][2] - xy * here.difference -
         squares * here.I[0][1] - here.U[1][2] * here.I[0][2] + here.U[0][2] * here.I[1][2];
}

// The wrench on composite body i by the accelerations that its own joint's rate causes.
Wrench rate_wrench(Derivation& d, const AtAxis& here, const Number& qd, const std::string& n) {
  const Vec3 &h = here.h, &w = here.omega;
  const Mat3& I = here.I;
  const Number twice = d.named(2 * qd, "qd_2_" + n);
  const Number beta = d.named(qd * d.named(qd + 2 * w[2], "beta_" + n + "_f"), "beta_" + n);
  const Number dx = d.named(qd * w[0], "delta_" + n + "_x"), dy = d.named(qd * w[1], "delta_" + n + "_y");
  const Number gx = d.named(twice * w[0], "gamma_" + n + "_x"), gy = d.named(twice * w[1], "gamma_" + n + "_y");
  return {{-beta * h[0], -beta * h[1], gx * h[0] + gy * h[1]},
          {dy * d.named(I[2][2] + here.difference, "Iu_" + n + "_y") - gx * I[0][1] - beta * I[1][2],
           beta * I[0][2] - dx * d.named(I[2][2] - here.difference, "Iu_" + n + "_x") + gy * I[0][1], 0}};
}

}  // namespace

std::vector<Number> composite_bias_torques(Frames& frames, const Motion& motion,
                                           const std::vector<InertialParameters>& bodies) {
  Derivation& d = frames.derivation();
  const std::vector<LinkMotion> links = link_motions(frames, motion);
  std::vector<Wrench> wrenches = rotor_reactions(frames, motion, links);  // in the bodies' frames
  std::vector<Number> tau(links.size(), 0);
  const auto first = static_cast<std::size_t>(frames.mechanism().base_bodies());
  for (std::size_t k = links.size(); k-- > first;) {
    const int i = static_cast<int>(k), parent = frames.body(i).parent;
    const std::string n = frames.label(i);
    const LinkMotion before = parent < 0 ? base_motion(frames, motion) : links[static_cast<std::size_t>(parent)];
    const AtAxis here = at_axis(frames, i, before, bodies[k]);
    const Wrench own = rate_wrench(d, here, motion.qd[k], n);
    const Vec3 f = d.named(wrenches[k].f, "f_" + n), mu = d.named(wrenches[k].mu, "mu_" + n);
    const Wrench all = {d.named(own.f + frames.up_to_axis(i, f, "f_u_" + n), "f_a_" + n),
                        d.named(own.mu + frames.up_to_axis(i, mu, "mu_u_" + n), "mu_a_" + n)};
    const Number felt_here = d.named(carried_moment(d, here, n) + all.mu[2], "mu_z_" + n);
    tau[k] = joint_torque(frames, i, {zero_vector(), {0, 0, felt_here}}, links, motion);
    if (parent < 0) continue;
    Wrench& at_parent = wrenches[static_cast<std::size_t>(parent)];
    const Vec3 turned = frames.up_from_axis(i, all.f, "f_p_" + n);
    at_parent.f = at_parent.f + turned;
    at_parent.mu = at_parent.mu + frames.up_from_axis(i, all.mu, "mu_p_" + n) + cross(frames.p(i), turned);
  }
  if (first == 0) return tau;
  // The whole robot moves with a floating base as if all joints were locked.
  const LinkMotion& base = links[first - 1];
  const Wrench locked = inertial_wrench(d, bodies[first - 1], base, "cb"), &more = wrenches[first - 1];
  for (std::size_t k = 0; k < 3; ++k) {
    const int slide = static_cast<int>(k), turn = slide + 3;
    const Wrench force = {{0, 0, locked.f[k] + more.f[k]}, zero_vector()},
                 moment = {zero_vector(), {0, 0, locked.mu[k] + more.mu[k]}};
    tau[k] = joint_torque(frames, slide, force, links, motion);
    tau[k + 3] = joint_torque(frames, turn, moment, links, motion);
  }
  return tau;
}

}  // namespace flatdyn
