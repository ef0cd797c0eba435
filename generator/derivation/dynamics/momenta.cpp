// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/momenta.hpp"

namespace flatdyn {
namespace {

// The momenta about another reference point, from which the old one is at p and moves with u. `first_moment`: about the
// old point.
Momenta shifted_momenta(const Momenta& a, const Number& mass, const Vec3& first_moment, const Vec3& p, const Vec3& u) {
  const Vec3 about_new = first_moment + mass * p;
  Momenta moved;
  moved.P = a.P + mass * u;
  moved.L = a.L + cross(p, a.P) + cross(about_new, u);
  moved.dI = a.dI + inertia_between(u, about_new) + inertia_between(p, a.P);
  return moved;
}

Momenta named_momenta(Derivation& d, const Momenta& a, const std::string& n) {
  return {d.named(a.P, "P_" + n), d.named(a.L, "L_" + n), d.named_symmetric(a.dI, "dI_" + n)};
}

// The momenta of body i alone: u = ω × r.
Momenta own_momenta(Frames& frames, int i, const LinkMotion& link) {
  const InertialParameters& body = frames.inertia(i);
  const Mat3 turned = skew(link.omega) * body.inertia;
  return {cross(link.omega, body.first_moment), body.inertia * link.omega, turned + transpose(turned)};
}

// The contribution of composite body i to its parent's.
Momenta in_parent(Frames& frames, int i, const Momenta& composite, const InertialParameters& body, const Vec3& slide_u,
                  const Vec3& omega) {
  Derivation& d = frames.derivation();
  const std::string n = frames.label(i);
  const Vec3 slide = {0, 0, frames.slide(i)};
  const Momenta slid =
      named_momenta(d, shifted_momenta(composite, body.mass, body.first_moment, slide, slide_u), "s" + n);
  const Vec3 first_moment = d.named(body.first_moment + body.mass * slide, "hs_" + n);
  const Momenta turned = {frames.to_parent(i, slid.P, "P_u" + n), frames.to_parent(i, slid.L, "L_u" + n),
                          frames.to_parent(i, slid.dI, "dI_u" + n)};
  const Vec3 u = d.named(cross(omega, frames.p(i)), "u_p_" + n);
  return shifted_momenta(turned, body.mass, frames.to_parent(i, first_moment, "hu_" + n), frames.p(i), u);
}

}  // namespace

Vec3 slide_rate(Frames& frames, int i, const Motion& motion, const LinkMotion& link) {
  if (!frames.body(i).prismatic || frames.mechanism().is_of_base(i)) return zero_vector();
  const Number q = frames.slide(i);
  return frames.derivation().named(Vec3{q * link.omega[1], -q * link.omega[0], motion.qd[static_cast<std::size_t>(i)]},
                                   "u_s_" + frames.label(i));
}

std::vector<Momenta> composite_momenta(Frames& frames, const Motion& motion, const std::vector<LinkMotion>& links,
                                       const std::vector<InertialParameters>& bodies) {
  Derivation& d = frames.derivation();
  std::vector<Momenta> result;
  for (std::size_t i = 0; i < links.size(); ++i) {
    result.push_back(own_momenta(frames, static_cast<int>(i), links[i]));
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto& rotor = frames.body(static_cast<int>(i)).rotor;
    if (!rotor || rotor->carrier < 0) continue;
    const Number spin = rotor->gear_ratio * rotor->inertia * motion.qd[i];
    Momenta& carrier = result[static_cast<std::size_t>(rotor->carrier)];
    carrier.L =
        carrier.L + d.named(spin, "kIqd_" + frames.label(static_cast<int>(i))) * frames.rotor_axis(static_cast<int>(i));
  }
  for (std::size_t i = links.size(); i-- > 0;) {
    const int k = static_cast<int>(i), parent = frames.body(k).parent;
    result[i] = named_momenta(d, result[i], frames.label(k));
    if (parent < 0) continue;
    const auto p = static_cast<std::size_t>(parent);
    const Momenta carried =
        in_parent(frames, k, result[i], bodies[i], slide_rate(frames, k, motion, links[i]), links[p].omega);
    result[p] = {result[p].P + carried.P, result[p].L + carried.L, result[p].dI + carried.dI};
  }
  return result;
}

}  // namespace flatdyn
