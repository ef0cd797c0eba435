// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/articulated.hpp"

#include "derivation/dynamics/dry_friction.hpp"
#include "derivation/dynamics/factorisation.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// An articulated body: the wrench needed by a body and its descendants for the accelerations a (of the origin, less
// g_0) and α of its frame, in its axes. The force is M a + G α + F, the moment about the frame's origin Gᵀ a + J α + N.
struct ArticulatedBody {
  Mat3 M = zero_matrix(), G = zero_matrix(), J = zero_matrix();
  Vec3 F = zero_vector(), N = zero_vector();
};

Vec3 matrix_column(const Mat3& m, std::size_t k) { return {m[0][k], m[1][k], m[2][k]}; }

Mat3 dyad(const Vec3& a, const Vec3& b) {
  Mat3 m;
  for (std::size_t i = 0; i < 3; ++i) m[i] = a[i] * b;
  return m;
}

Mat3 named_general(Derivation& d, const Mat3& m, const std::string& name) {
  static const char* const kRows[] = {"_x", "_y", "_z"};
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = d.named(m[i], name + kRows[i]);
  return result;
}

ArticulatedBody named_body(Derivation& d, const ArticulatedBody& a, const std::string& n) {
  return {d.named_symmetric(a.M, "Ma_" + n), named_general(d, a.G, "Ga_" + n), d.named_symmetric(a.J, "Ja_" + n),
          d.named(a.F, "Fa_" + n), d.named(a.N, "Na_" + n)};
}

// The same body about a reference point at -p from the old one; the old point's acceleration is the new one's plus
// -S(p) α + c.
ArticulatedBody shifted_reference_point(const ArticulatedBody& a, const Vec3& p, const Vec3& c) {
  const Mat3 S = skew(p);
  ArticulatedBody moved;
  moved.M = a.M;
  moved.G = a.G - a.M * S;
  moved.J = a.J + S * moved.G - transpose(a.G) * S;
  moved.F = a.F + a.M * c;
  moved.N = a.N + transpose(a.G) * c + cross(p, moved.F);
  return moved;
}

class ArticulatedRecursion {
 public:
  ArticulatedRecursion(Frames& frames, const Motion& motion, const std::vector<Number>& tau)
      : frames_(frames),
        d_(frames.derivation()),
        motion_(motion),
        tau_(tau),
        joints_(tau.size()),
        bodies_(tau.size()) {}

  ArticulatedSolution run() {
    for (int i = 0; i < size(); ++i) move(i);
    for (int i = 0; i < size(); ++i) add_body(i);
    for (int i = size() - 1; i >= 0; --i) reduce(i);
    ArticulatedSolution solution;
    for (int i = 0; i < size(); ++i) accelerate(i);
    for (const Joint& joint : joints_) {
      solution.qdd.push_back(joint.qdd);
      solution.pivots.push_back(joint.pivot);
    }
    return solution;
  }

 private:
  // Intermediate results for a joint and the body that it moves.
  struct Joint {
    Vec3 omega = zero_vector();  // the body's, in its axes
    Vec3 drift = zero_vector();  // q̇ ω × z for α, or 2 q̇ ω × z for a: the part that q̇ causes
    Vec3 c = zero_vector();      // ω × (ω × p), in the parent's axes
    Vec3 force = zero_vector();  // force and moment of the wrench per unit of q̈
    Vec3 moment = zero_vector();
    Vec3 rotor = zero_vector();     // k_r I_m z_m, on the parent
    Number pivot = 0, inverse = 0;  // the inertia at the joint, and its reciprocal
    Number rest = 0;                // τ less the torque that the body's bias needs
    Number qdd = 0;
    Vec3 alpha = zero_vector(), a = zero_vector();
  };

  int size() const { return static_cast<int>(joints_.size()); }
  int parent(int i) const { return frames_.body(i).parent; }
  Joint& joint(int i) { return joints_[static_cast<std::size_t>(i)]; }
  ArticulatedBody& body(int i) { return bodies_[static_cast<std::size_t>(i)]; }
  const Number& qd(int i) const { return motion_.qd[static_cast<std::size_t>(i)]; }

  Vec3 squared_swing(const Vec3& omega, const Vec3& p, const std::string& n) {
    const Vec3 turning = d_.named(cross(omega, p), "wp_" + n);
    return d_.named(cross(omega, turning), "wwp_" + n);
  }

  // The base's twist moves all bodies that are its motion, and there is no drift between them.
  void move_with_base(int i) {
    Vec3 omega = {qd(3), qd(4), qd(5)};
    for (int k = 0; k <= i; ++k) omega = frames_.to_child(k, omega, "omega_b" + frames_.label(k));
    joint(i).omega = omega;
  }

  // The first two bodies have no inertia, and all of the joint's drift, Rᵀ ω_parent × w, is the last one's.
  void move_spherical_joint(int first) {
    const int last = first + kSphericalBodies - 1;
    const std::string n = frames_.label(last);
    const Vec3 before = parent(first) < 0 ? zero_vector() : joint(parent(first)).omega;
    joint(first).c = squared_swing(before, frames_.p(first), n);
    Vec3 carried = before;
    for (int i = first; i <= last; ++i) carried = frames_.to_child(i, carried, "omega_r_" + n);
    const Vec3 w = {qd(first), qd(first + 1), qd(last)};
    joint(last).drift = d_.named(cross(carried, w), "drift_" + n);
    joint(last).omega = d_.named(carried + w, "omega_" + n);
  }

  void move(int i) {
    if (frames_.mechanism().is_of_base(i)) return move_with_base(i);
    if (frames_.body(i).spherical == 1) move_spherical_joint(i);
    if (frames_.body(i).spherical > 0) return;
    Joint& j = joint(i);
    const std::string n = frames_.label(i);
    const Vec3 before = parent(i) < 0 ? zero_vector() : joint(parent(i)).omega;
    j.c = squared_swing(before, frames_.p(i), n);
    const Vec3 carried = frames_.to_child(i, before, "omega_r_" + n);
    const bool prismatic = frames_.body(i).prismatic;
    const Number rate = prismatic ? d_.named(2 * qd(i), "qd_2_" + n) : qd(i);
    j.drift = d_.named(Vec3{rate * carried[1], -rate * carried[0], 0}, "drift_" + n);
    j.omega = prismatic ? carried : d_.named(carried + Vec3{0, 0, qd(i)}, "omega_" + n);
  }

  void add_body(int i) {
    const InertialParameters& own = frames_.inertia(i);
    const Vec3& omega = joint(i).omega;
    ArticulatedBody& all = body(i);
    const std::string n = frames_.label(i);
    const Mat3 mass = {Vec3{own.mass, 0, 0}, Vec3{0, own.mass, 0}, Vec3{0, 0, own.mass}};
    const Vec3 spin = d_.named(own.inertia * omega, "Iw_" + n);
    all.M = mass;
    all.G = transpose(skew(own.first_moment));
    all.J = own.inertia;
    all.F = squared_swing(omega, own.first_moment, "h" + n);
    all.N = all.N + cross(omega, spin);
    const auto& rotor = frames_.body(i).rotor;
    if (!rotor || rotor->carrier < 0) return;
    joint(i).rotor = rotor_momentum(frames_, i);
    ArticulatedBody& carrier = body(rotor->carrier);
    carrier.N = carrier.N + qd(i) * cross(joint(rotor->carrier).omega, joint(i).rotor);
  }

  Number driving_torque(int i) {
    const Body& moving = frames_.body(i);
    Number tau = tau_[static_cast<std::size_t>(i)];
    if (frames_.mechanism().is_of_base(i)) {  // what the armature of a base's slide needs for ω × v; q̈ is zero here
      tau -= d_.named(moving.armature, "I_r" + frames_.label(i)) * own_acceleration(frames_, i, motion_);
    }
    if (!motion_.passive) return tau;
    tau -= spring_torque(frames_, i);
    tau -= d_.named(moving.viscous, "F_v" + frames_.label(i)) * qd(i);
    return tau - dry_friction(d_, moving, qd(i), frames_.label(i));
  }

  // Lets joint i move freely, and adds the remaining inertia of the body to its parent.
  void reduce(int i) {
    const std::string n = frames_.label(i);
    ArticulatedBody all = named_body(d_, body(i), n);
    Joint& j = joint(i);
    const bool prismatic = frames_.body(i).prismatic;
    const Vec3 F = d_.named(all.F + (prismatic ? all.M : all.G) * j.drift, "Fd_" + n);
    const Vec3 N = d_.named(all.N + (prismatic ? transpose(all.G) : all.J) * j.drift, "Nd_" + n);
    j.force = prismatic ? matrix_column(all.M, 2) : matrix_column(all.G, 2);
    j.moment = prismatic ? matrix_column(transpose(all.G), 2) : matrix_column(all.J, 2);
    j.pivot = d_.named(
        (prismatic ? all.M[2][2] : all.J[2][2]) + d_.named(reflected_inertia(frames_.body(i)), "I_r" + n), "D_" + n);
    if (vanishes(j.pivot)) throw SingularInertia(frames_.body(i));
    j.inverse = d_.quotient(1, j.pivot, "d_" + n);
    j.rest = d_.named(driving_torque(i) - (prismatic ? F[2] : N[2]), "rest_" + n);
    if (parent(i) < 0) return;
    const Vec3 force = d_.named(j.inverse * j.force, "fd_" + n), moment = d_.named(j.inverse * j.moment, "mud_" + n);
    all.M = all.M - dyad(force, j.force);
    all.G = all.G - dyad(force, j.moment);
    all.J = all.J - dyad(moment, j.moment);
    all.F = F + j.rest * force;
    all.N = N + j.rest * moment;
    hang(i, named_body(d_, all, "r" + n));
  }

  void hang(int i, ArticulatedBody all) {
    const std::string n = frames_.label(i);
    const Joint& j = joint(i);
    Vec3 moment = j.moment;
    Number rest = j.rest;
    if (frames_.body(i).prismatic) {
      const Vec3 slide = {0, 0, frames_.slide(i)};
      const Vec3 swing = squared_swing(j.omega, slide, "s" + n);
      all = named_body(d_, shifted_reference_point(all, slide, swing), "s" + n);
      moment = moment + cross(slide, j.force);
      rest -= dot(j.force, swing);
    }
    all = shifted_reference_point(up(i, all), frames_.p(i), j.c);
    if (!vanishes(dot(j.rotor, j.rotor))) {
      // The rotor's reaction adds k_r I_m z_m to the column of q̈, which the dyads do not include.
      const Vec3 f = frames_.to_parent(i, j.force, "fu_" + n);
      const Vec3 mu = d_.named(frames_.to_parent(i, moment, "muu_" + n) + cross(frames_.p(i), f), "mup_" + n);
      const Vec3 spin = d_.named(j.inverse * j.rotor, "spin_" + n);
      all.G = all.G - dyad(f, spin);
      all.J = all.J - (dyad(mu, spin) + dyad(spin, mu) + dyad(spin, j.rotor));
      all.N = all.N + d_.named(rest - dot(f, j.c), "left_" + n) * spin;
    }
    ArticulatedBody& at_parent = body(parent(i));
    at_parent = {at_parent.M + all.M, at_parent.G + all.G, at_parent.J + all.J, at_parent.F + all.F,
                 at_parent.N + all.N};
  }

  ArticulatedBody up(int i, const ArticulatedBody& a) {
    const std::string n = frames_.label(i);
    Mat3 half, G;
    for (std::size_t k = 0; k < 3; ++k) half[k] = frames_.to_parent(i, a.G[k], "Gh" + std::to_string(k) + "_" + n);
    half = transpose(half);
    for (std::size_t k = 0; k < 3; ++k) G[k] = frames_.to_parent(i, half[k], "Gu" + std::to_string(k) + "_" + n);
    return {frames_.to_parent(i, a.M, "Mu_" + n), transpose(G), frames_.to_parent(i, a.J, "Ju_" + n),
            frames_.to_parent(i, a.F, "Fu_" + n), frames_.to_parent(i, a.N, "Nu_" + n)};
  }

  // That of the base's origin less g_0 while q̈ = 0.
  Vec3 acceleration_of_base() {
    Vec3 a = Number(-1) * motion_.gravity;
    if (frames_.mechanism().floating_base) a = a + cross({qd(3), qd(4), qd(5)}, {qd(0), qd(1), qd(2)});
    return d_.named(a, "ddp_0");
  }

  // Computes q̈_i and the accelerations of body i, from the base outwards.
  void accelerate(int i) {
    const std::string n = frames_.label(i);
    Joint& j = joint(i);
    const bool fixed = parent(i) < 0;
    const Vec3 alpha = fixed ? zero_vector() : joint(parent(i)).alpha;
    const Vec3 a = fixed ? acceleration_of_base() : joint(parent(i)).a;
    const Vec3 turned = frames_.to_child(i, alpha, "alpha_r_" + n);
    const Vec3 carried = frames_.to_child(i, d_.named(a + cross(alpha, frames_.p(i)) + j.c, "a_o_" + n), "a_r_" + n);
    const Vec3 slide = {0, 0, frames_.slide(i)};
    const Vec3 origin = d_.named(carried + cross(turned, slide) + squared_swing(j.omega, slide, "s" + n), "a_s_" + n);
    const Number taken = dot(j.force, origin) + dot(j.moment, turned) + dot(j.rotor, alpha);
    j.qdd = d_.named(j.inverse * d_.named(j.rest - taken, "free_" + n), "qdd_" + n);
    const Vec3 made = d_.named(j.drift + Vec3{0, 0, j.qdd}, "made_" + n);
    j.alpha = frames_.body(i).prismatic ? turned : d_.named(turned + made, "alpha_" + n);
    j.a = frames_.body(i).prismatic ? d_.named(origin + made, "a_" + n) : origin;
  }

  Frames& frames_;
  Derivation& d_;
  const Motion& motion_;
  const std::vector<Number>& tau_;
  std::vector<Joint> joints_;
  std::vector<ArticulatedBody> bodies_;
};

}  // namespace

bool has_articulated_form(const Mechanism& mechanism) {
  if (mechanism.is_coupled()) return false;
  for (const Body& body : mechanism.bodies) {
    if (body.rotor && body.rotor->carrier >= 0 && body.rotor->carrier != body.parent) return false;
  }
  return true;
}

ArticulatedSolution articulated_accelerations(Frames& frames, const Motion& motion, const std::vector<Number>& tau) {
  return ArticulatedRecursion(frames, motion, tau).run();
}

}  // namespace flatdyn
