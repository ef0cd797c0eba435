// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/derivatives.hpp"

#include "derivation/dynamics/composite.hpp"
#include "derivation/dynamics/dry_friction.hpp"
#include "derivation/dynamics/momenta.hpp"
#include "robot/model/floating_base.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

// The vectors e, y, w of a field of accelerations e + y × r + 2 w × u.
struct Field {
  Vec3 e = zero_vector(), y = zero_vector(), w = zero_vector();
};

Vec3 z_column(const Mat3& m) { return {m[0][2], m[1][2], m[2][2]}; }

class TorqueDerivation {
 public:
  TorqueDerivation(Frames& frames, const Motion& motion, BaseColumns base_columns)
      : frames_(frames),
        d_(frames.derivation()),
        motion_(motion),
        base_columns_(base_columns),
        links_(link_motions(frames, motion)),
        wrenches_(joint_wrenches(frames, motion, links_)),
        bodies_(composites(frames)),
        momenta_(composite_momenta(frames, motion, links_, bodies_)) {
    const auto n = links_.size();
    result_.dq.assign(n, std::vector<Number>(n, 0));
    result_.dqd = result_.dq;
  }

  TorqueDerivatives run() {
    for (int i = 0; i < static_cast<int>(links_.size()); ++i) {
      row(i);
      column_of_position(i);
      column_of_rate(i);
    }
    if (has_base_armature(frames_.mechanism())) add_armature_of_base();
    return std::move(result_);
  }

 private:
  template <class T>
  static T& at(std::vector<T>& values, int i) {
    return values[static_cast<std::size_t>(i)];
  }

  Vec3 w_of(int k) {
    const Vec3& omega = at(links_, k).omega;
    return {omega[1], -omega[0], 0};
  }

  // A vector in base axes, in the axes of a body of the base's motion.
  Vec3 in_base_frame(int k, Vec3 v, const std::string& name) {
    for (int i = frames_.mechanism().base_bodies() - 1; i > k; --i) v = frames_.to_parent(i, v, name);
    return v;
  }

  // The fields of the base's columns, see the header.
  Field field_of_base_position(int k) {
    if (frames_.body(k).prismatic || base_columns_ != BaseColumns::derivatives) return {};
    const Vec3 g = in_base_frame(k, motion_.gravity, "g_b");
    return {{-g[1], g[0], 0}, zero_vector(), zero_vector()};
  }

  Field field_of_base_rate(int k) {
    const bool accelerates = base_columns_ == BaseColumns::derivatives;
    if (frames_.body(k).prismatic) return {accelerates ? w_of(k) : zero_vector(), zero_vector(), zero_vector()};
    const Vec3 v = in_base_frame(k, {motion_.qd[0], motion_.qd[1], motion_.qd[2]}, "v_b");
    return {accelerates ? Vec3{-v[1], v[0], 0} : zero_vector(), w_of(k), {0, 0, 1}};
  }

  // The motion of the link that a spherical joint moves, in the axes of the joint's body k.
  LinkMotion in_axes_of_spherical(int k) {
    int i = k + kSphericalBodies - frames_.body(k).spherical;
    LinkMotion link = at(links_, i);
    for (; i > k; --i) {
      for (Vec3* v : {&link.omega, &link.omega_r, &link.domega_r, &link.ddp}) *v = frames_.to_parent(i, *v, "turned");
    }
    return link;
  }

  Field field_of_spherical_position(int k) {
    const LinkMotion link = in_axes_of_spherical(k);
    const Vec3 w = d_.named(Vec3{link.omega_r[1], -link.omega_r[0], 0}, "w_r_" + frames_.label(k));
    return {{link.ddp[1], -link.ddp[0], 0}, Vec3{link.domega_r[1], -link.domega_r[0], 0} + cross(link.omega_r, w), w};
  }

  Field field_of_spherical_rate(int k) {
    const LinkMotion link = in_axes_of_spherical(k);
    const Vec3 other = base_columns_ == BaseColumns::coriolis ? link.omega : link.omega_r;
    const Vec3 sum = d_.named(link.omega + other, "omega_s_" + frames_.label(k));
    return {zero_vector(), {sum[1], -sum[0], 0}, {0, 0, 1}};
  }

  Field field_of_position(int k) {
    if (frames_.mechanism().is_of_base(k)) return field_of_base_position(k);
    if (frames_.body(k).spherical > 0) return field_of_spherical_position(k);
    const LinkMotion& link = at(links_, k);
    if (frames_.body(k).prismatic) return {z_column(link.U), zero_vector(), zero_vector()};
    return {{link.ddp[1], -link.ddp[0], 0}, z_column(link.U), w_of(k)};
  }

  Field field_of_rate(int k) {
    if (frames_.mechanism().is_of_base(k) && base_columns_ != BaseColumns::coriolis) return field_of_base_rate(k);
    if (frames_.body(k).spherical > 0) return field_of_spherical_rate(k);
    const Vec3 twice = d_.named(Number(2) * w_of(k), "w_2_" + frames_.label(k));
    if (frames_.body(k).prismatic) return {twice, zero_vector(), zero_vector()};
    return {zero_vector(), twice, {0, 0, 1}};
  }

  // The wrench that gives composite body k these accelerations.
  Wrench applied(int k, const Field& field) {
    const InertialParameters& body = at(bodies_, k);
    const Momenta& momenta = at(momenta_, k);
    const Vec3& H = body.first_moment;
    const Vec3 force = body.mass * field.e + cross(field.y, H) + Number(2) * cross(field.w, momenta.P);
    return {force, cross(H, field.e) + body.inertia * field.y + momenta.dI * field.w + cross(field.w, momenta.L)};
  }

  // The linear map from a field of accelerations to a torque: τ = f·e + μ·y + κ·w.
  struct Row {
    Wrench wrench;
    Vec3 kappa = zero_vector();
  };

  // The torque of joint i as a function of a field of accelerations of composite body i.
  Row component_at(int i) {
    const Momenta& momenta = at(momenta_, i);
    const Wrench wrench = unit_wrench(frames_, i, at(bodies_, i));
    if (frames_.body(i).prismatic) return {wrench, {2 * momenta.P[1], -2 * momenta.P[0], 0}};
    return {wrench, z_column(momenta.dI) + Vec3{momenta.L[1], -momenta.L[0], 0}};
  }

  // Computes ∂τ_i/∂q_k and ∂τ_i/∂q̇_k for k = i and every joint before it.
  void row(int i) {
    Row row = component_at(i);
    const Body& body = frames_.body(i);
    for (int k = i, below = i; k >= 0; below = k, k = frames_.body(k).parent) {
      const std::string n = frames_.label(i) + "_" + frames_.label(k);
      if (k != i) row = in_parent(below, row, n);
      if (k != i && body.rotor && body.rotor->carrier == k) add_rotor(i, row);
      row = {{d_.named(row.wrench.f, "f_" + n), d_.named(row.wrench.mu, "mu_" + n)}, d_.named(row.kappa, "kappa_" + n)};
      const bool has_passive = i == k && motion_.passive;
      const Number stiffness = has_passive ? d_.named(body.stiffness, "k_" + frames_.label(i)) : Number(0);
      const Number damping = has_passive ? friction_slope(i) : Number(0);
      set(result_.dq, i, k, times(row, field_of_position(k)) + stiffness, "dtau_");
      set(result_.dqd, i, k, times(row, field_of_rate(k)) + damping, "dtaud_");
    }
  }

  // The derivative of the friction of joint i by its rate.
  Number friction_slope(int i) {
    const Body& body = frames_.body(i);
    return d_.named(body.viscous, "F_v" + frames_.label(i)) +
           dry_friction_slope(d_, body, motion_.qd[static_cast<std::size_t>(i)], frames_.label(i));
  }

  // Transforms a row from the origin of frame k to that of its parent.
  Row in_parent(int k, const Row& row, const std::string& n) {
    const std::string from = n + "k";
    const Vec3 slid = row.kappa + Number(2) * cross(slide_rate(frames_, k, motion_, at(links_, k)), row.wrench.f);
    const Wrench wrench = to_parent(frames_, k, row.wrench, from);
    const Vec3 carried =
        d_.named(cross(at(links_, frames_.body(k).parent).omega, frames_.p(k)), "u_p_" + frames_.label(k));
    return {wrench, frames_.to_parent(k, d_.named(slid, "kappa_s_" + from), "kappa_u_" + from) +
                        Number(2) * cross(carried, wrench.f)};
  }

  // Adds the torque on the rotor of joint i by its carrier's rotation, last term of (7.114).
  void add_rotor(int i, Row& row) {
    const Vec3 unit = rotor_momentum(frames_, i);
    row.wrench.mu = row.wrench.mu + unit;
    row.kappa = row.kappa + cross(at(links_, frames_.body(i).rotor->carrier).omega, unit);
  }

  static Number times(const Row& row, const Field& field) {
    return dot(row.wrench.f, field.e) + dot(row.wrench.mu, field.y) + dot(row.kappa, field.w);
  }

  // Computes ∂τ_i/∂q_k for the joints i before k.
  void column_of_position(int k) {
    add_along_path(k, applied(k, field_of_position(k)), turned_wrench(k), zero_vector(), result_.dq, "q");
  }

  // How the wrench on joint k's link turns with it, in the axes of the joint's first body. The forces of a base and of
  // a spherical joint are in axes that turn with the link, but not those on the joint's parent.
  Wrench turned_wrench(int k) {
    if (frames_.mechanism().is_of_base(k)) return {};
    const int first = first_body_of_joint(frames_.mechanism(), k);
    const Wrench& wrench = at(wrenches_, first);
    if (k == first) return derivative_by_joint(frames_.body(k), wrench);
    Vec3 axis = {0, 0, 1};
    for (int i = k; i > first; --i) axis = frames_.to_parent(i, axis, "axis");
    return {cross(axis, wrench.f), cross(axis, wrench.mu)};
  }

  void column_of_rate(int k) {
    const auto& rotor = frames_.body(k).rotor;
    const bool carried = rotor && rotor->carrier >= 0;
    const Vec3 at_carrier =
        carried ? cross(at(links_, rotor->carrier).omega, rotor_momentum(frames_, k)) : zero_vector();
    add_along_path(k, applied(k, field_of_rate(k)), {}, at_carrier, result_.dqd, "qd");
  }

  // The torques at the joints before k of a wrench on composite body k, of another one beyond joint k's first body,
  // in the axes of that body, and of a moment on the carrier of its rotor.
  void add_along_path(int k, Wrench wrench, const Wrench& beyond, const Vec3& at_carrier, Rows& result,
                      const std::string& what) {
    const int first = first_body_of_joint(frames_.mechanism(), k);
    for (int i = k; frames_.body(i).parent >= 0;) {
      if (i == first) wrench = {wrench.f + beyond.f, wrench.mu + beyond.mu};
      const std::string n = what + frames_.label(k) + "_" + frames_.label(i);
      wrench = {d_.named(wrench.f, "df_" + n), d_.named(wrench.mu, "dmu_" + n)};
      wrench = to_parent(frames_, i, wrench, n);
      i = frames_.body(i).parent;
      const auto& rotor = frames_.body(k).rotor;
      if (rotor && rotor->carrier == i) wrench.mu = wrench.mu + at_carrier;
      set(result, i, k, joint_component(frames_, i, wrench), "dtau_" + what);
    }
  }

  // The armature of a floating base adds its multiple of v̇ + ω × v to the force, and of ω̇ to the moment, without
  // gravity: of p̈ + g_b where p̈ is held fixed. The moment is that of a sphere's inertia, with the C of one.
  void add_armature_of_base() {
    const Number armature = d_.named(frames_.body(0).armature, "I_r" + frames_.label(0));
    const std::vector<Number>& twist = motion_.qd;
    const Mat3 of_v = skew({twist[0], twist[1], twist[2]}), of_omega = skew({twist[3], twist[4], twist[5]}),
               of_g = skew(motion_.gravity);
    constexpr int kOfTranslation = 3;
    for (int i = 0; i < kOfTranslation; ++i) {
      for (int j = 0; j < kOfTranslation; ++j) {
        const auto r = static_cast<std::size_t>(i), c = static_cast<std::size_t>(j);
        const int turn = j + kOfTranslation;
        switch (base_columns_) {
          case BaseColumns::derivatives:
            add(result_.dqd, i, j, armature * of_omega[r][c]);  // ω × e_j
            add(result_.dqd, i, turn, -armature * of_v[r][c]);  // e_j × v
            break;
          case BaseColumns::at_origin_acceleration:
            add(result_.dq, i, turn, armature * of_g[r][c]);  // g_b × e_j
            break;
          case BaseColumns::coriolis:
            add(result_.dqd, i, j, 2 * armature * of_omega[r][c]);
            add(result_.dqd, i + kOfTranslation, turn, armature * of_omega[r][c]);
            break;
        }
      }
    }
  }

  void add(Rows& result, int i, int k, const Number& value) {
    set(result, i, k, at(at(result, i), k) + value, "dtau_a_");
  }

  void set(Rows& result, int i, int k, const Number& value, const std::string& name) {
    at(at(result, i), k) = d_.named(value, name + frames_.label(i) + "_" + frames_.label(k));
  }

  Frames& frames_;
  Derivation& d_;
  const Motion& motion_;
  const BaseColumns base_columns_;
  std::vector<LinkMotion> links_;
  std::vector<Wrench> wrenches_;
  std::vector<InertialParameters> bodies_;
  std::vector<Momenta> momenta_;
  TorqueDerivatives result_;
};

}  // namespace

TorqueDerivatives torque_derivatives(Frames& frames, const Motion& motion, BaseColumns base_columns) {
  return TorqueDerivation(frames, motion, base_columns).run();
}

}  // namespace flatdyn
