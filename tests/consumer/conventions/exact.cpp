// SPDX-License-Identifier: BSD-3-Clause
// Conventions in rational arithmetic: every function, at quaternions and joint angles whose sines are rational, against
// the satellite's own functions and what the convention means. Both sides are exact.
#include <boost/multiprecision/cpp_int.hpp>

#include "robot.hpp"

namespace {

namespace mp = boost::multiprecision;
using Rational = mp::number<mp::cpp_rational_backend, mp::et_off>;
using Sines = satellite::GivenSinCos<Rational>;

Rational of(int n, int d) { return Rational(n) / Rational(d); }

// With v, a and the torques of flatdyn's own functions.
struct ExactState : State<Rational> {
  Rational sine[kJointPositions], cosine[kJointPositions], g_b[3], h_b[6];
  Vector<Rational> tau;

  Sines sines() const { return {sine, cosine}; }
};

ExactState state(const Quaternion<Rational>& e, int k) {
  ExactState s;
  s.p = {of(k, 3), of(-2, 7), of(5, 4 + k)};
  s.e = e;
  const Quaternion<Rational> ball = k == 1 ? Quaternion<Rational>{of(2, 9), of(-5, 9), of(4, 9), of(6, 9)}
                                           : Quaternion<Rational>{of(4, 9), of(-4, 9), of(7, 9), 0};
  s.q = {of(1, 2), ball[0], ball[1], ball[2], ball[3], of(k, 9)};  // the first by its sine and cosine only
  const Rational t = of(k, 5);
  s.sine[0] = 2 * t / (1 + t * t);
  s.cosine[0] = (1 - t * t) / (1 + t * t);
  for (int i = 0; i < kSize; ++i) {
    const auto at = static_cast<std::size_t>(i);
    s.v[at] = of(3 * i - 7 + k, 5 + i);
    s.a[at] = of(11 - 4 * i + k, 3 + i);
  }
  const Three<Rational> gravity = turned(e, {0, 0, Rational(-9.75)}, -1);
  const Three<Rational> force = turned(e, {of(1, 3), 2, of(-k, 2)}, -1),
                        moment = turned(e, {of(k, 4), 1, of(3, 7)}, -1);
  for (std::size_t i = 0; i < 3; ++i) {
    s.g_b[i] = gravity[i];
    s.h_b[i] = force[i];
    s.h_b[i + 3] = moment[i];
  }
  satellite::inverse_dynamics(s.q.data(), s.g_b, s.v.data(), s.a.data(), s.tau.data(), s.sines());
  return s;
}

// Vectors of the world as rows by v, so that `of_v` v is the same for flatdyn's and for the convention's.
template <std::size_t rows>
std::array<Rational, rows> times_v(const std::array<Rational, rows * kSize>& of_v, const Vector<Rational>& v) {
  std::array<Rational, rows> result;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < kSize; ++k) result[i] = result[i] + of_v[kSize * i + k] * v[k];
  }
  return result;
}

// Two vectors of base axes in world axes, in the convention's order.
std::array<Rational, 6> in_world(const Meaning& meaning, const ExactState& s, const std::array<Rational, 6>& x) {
  const Three<Rational> linear = turned(s.e, {x[0], x[1], x[2]}), angular = turned(s.e, {x[3], x[4], x[5]});
  std::array<Rational, 6> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = meaning.angular_first ? angular[k] : linear[k];
    result[k + 3] = meaning.angular_first ? linear[k] : angular[k];
  }
  return result;
}

template <class C>
struct Comparison {
  static constexpr Meaning meaning = C::meaning;
  const ExactState& s;
  Checks& checks;
  Pose<Rational> q = pose_in(meaning, s);
  Vector<Rational> v = velocity_in(meaning, s), a = acceleration_in(meaning, s), tau = force_in(meaning, s, s.tau);

  void compare_torques() const {
    Vector<Rational> found, still = {}, rest;
    C::of.inverse_dynamics(q.data(), v.data(), a.data(), found.data(), s.sines());
    checks.expect(found == tau, meaning, "inverse_dynamics");
    C::of.bias(q.data(), v.data(), found.data(), s.sines());
    C::of.inverse_dynamics(q.data(), v.data(), still.data(), rest.data(), s.sines());
    checks.expect(found == rest, meaning, "bias is the torque without acceleration");
    satellite::gravity(s.q.data(), s.g_b, rest.data(), s.sines());
    C::of.gravity(q.data(), found.data(), s.sines());
    checks.expect(found == force_in(meaning, s, rest), meaning, "gravity");
    checks.expect(C::of.forward_dynamics(q.data(), v.data(), tau.data(), found.data(), s.sines()), meaning, "valid");
    checks.expect(found == a, meaning, "forward_dynamics");
    checks.expect(dot(v, tau) == dot(s.v, s.tau), meaning, "power");
  }

  // A robot that nothing touches moves its base as forward dynamics do for the same torques.
  void compare_free_motion() const {
    std::array<Rational, 6> of_base;
    Vector<Rational> driven, found;
    C::of.inverse_dynamics_floating(q.data(), v.data(), a.data(), of_base.data(), driven.data(), s.sines());
    (void)C::of.forward_dynamics(q.data(), v.data(), driven.data(), found.data(), s.sines());
    bool same = true;
    for (std::size_t k = 0; k < kSize; ++k) same = same && found[k] == (k < 6 ? of_base[k] : a[k]);
    checks.expect(same, meaning, "inverse_dynamics_floating");
  }

  void compare_tip_force() const {
    const std::array<Rational, 6> h =
        in_world(meaning, s, {s.h_b[0], s.h_b[1], s.h_b[2], s.h_b[3], s.h_b[4], s.h_b[5]});
    Vector<Rational> found, wanted;
    satellite::inverse_dynamics_tip_force(s.q.data(), s.g_b, s.v.data(), s.a.data(), s.h_b, wanted.data(), s.sines());
    C::of.inverse_dynamics_tip_force(q.data(), v.data(), a.data(), h.data(), found.data(), s.sines());
    checks.expect(found == force_in(meaning, s, wanted), meaning, "inverse_dynamics_tip_force");
  }

  void compare_matrices() const {
    Matrix<Rational> B, C_of_v;
    Vector<Rational> n, gravity;
    C::of.inertia_matrix(q.data(), B.data(), s.sines());
    C::of.coriolis_matrix(q.data(), v.data(), C_of_v.data(), s.sines());
    C::of.bias(q.data(), v.data(), n.data(), s.sines());
    C::of.gravity(q.data(), gravity.data(), s.sines());
    const Vector<Rational> inertial = times(B, a), coriolis = times(C_of_v, v);
    bool adds_up = true, has_coriolis = true;
    for (std::size_t k = 0; k < kSize; ++k) {
      const Rational friction = k == 6 ? Rational(0.25) * v[k] : Rational(0);
      adds_up = adds_up && inertial[k] + n[k] == tau[k];
      has_coriolis = has_coriolis && coriolis[k] + gravity[k] + friction == n[k];
    }
    checks.expect(adds_up, meaning, "B a + bias is the torque");
    checks.expect(has_coriolis, meaning, "C v + gravity + friction is the bias");
    const Rational energy = C::of.kinetic_energy(q.data(), v.data(), s.sines());
    checks.expect(energy == dot(v, times(B, v)) / 2, meaning, "v^T B v / 2 is the kinetic energy");
    checks.expect(energy == satellite::kinetic_energy(s.q.data(), s.v.data(), s.sines()), meaning, "kinetic_energy");
  }

  void compare_tip() const {
    std::array<Rational, 9> R, R_b;
    Three<Rational> p, p_b;
    std::array<Rational, 6 * kSize> J, J_b;
    C::of.forward_kinematics(q.data(), R.data(), p.data(), s.sines());
    satellite::forward_kinematics(s.q.data(), R_b.data(), p_b.data(), s.sines());
    checks.expect(p == sum(s.p, turned(s.e, p_b)), meaning, "position of the tip");
    bool same = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Three<Rational> column = turned(s.e, {R_b[k], R_b[k + 3], R_b[k + 6]});
      same = same && column == Three<Rational>{R[k], R[k + 3], R[k + 6]};
    }
    checks.expect(same, meaning, "axes of the tip");
    C::of.jacobian(q.data(), J.data(), s.sines());
    satellite::jacobian(s.q.data(), J_b.data(), s.sines());
    checks.expect(times_v<6>(J, v) == in_world(meaning, s, times_v<6>(J_b, s.v)), meaning, "velocity of the tip");
    std::array<Rational, 6> b, b_b, found = times_v<6>(J, a), wanted = times_v<6>(J_b, s.a);
    C::of.jacobian_dot_qd(q.data(), v.data(), b.data(), s.sines());
    satellite::jacobian_dot_qd(s.q.data(), s.v.data(), b_b.data(), s.sines());
    checks.expect(plus(found, b) == in_world(meaning, s, plus(wanted, b_b)), meaning, "acceleration of the tip");
  }

  void compare_momentum() const {
    std::array<Rational, 6 * kSize> A, A_b;
    std::array<Rational, 6> b, b_b;
    C::of.centroidal_momentum_matrix(q.data(), A.data(), s.sines());
    satellite::centroidal_momentum_matrix(s.q.data(), A_b.data(), s.sines());
    checks.expect(times_v<6>(A, v) == in_world(meaning, s, times_v<6>(A_b, s.v)), meaning, "momentum");
    C::of.centroidal_bias(q.data(), v.data(), b.data(), s.sines());
    satellite::centroidal_bias(s.q.data(), s.v.data(), b_b.data(), s.sines());
    const std::array<Rational, 6> wanted = plus(times_v<6>(A_b, s.a), b_b);
    checks.expect(plus(times_v<6>(A, a), b) == in_world(meaning, s, wanted), meaning, "forces on the robot");
    Three<Rational> r, r_b;
    std::array<Rational, 3 * kSize> J, J_b;
    C::of.centre_of_mass(q.data(), r.data(), J.data(), s.sines());
    satellite::centre_of_mass(s.q.data(), r_b.data(), J_b.data(), s.sines());
    checks.expect(r == sum(s.p, turned(s.e, r_b)), meaning, "centre of mass");
    checks.expect(times_v<3>(J, v) == turned(s.e, times_v<3>(J_b, s.v)), meaning, "velocity of the centre of mass");
  }

  // Forces and impulses on the surface and at the point, in world axes.
  static constexpr std::size_t kRows = 9;
  std::array<Rational, kRows> turned_rows(const std::array<Rational, kRows>& x) const {
    std::array<Rational, kRows> result;
    for (std::size_t k = 0; k < kRows; k += 3) {
      const Three<Rational> in_world = turned(s.e, {x[k], x[k + 1], x[k + 2]});
      for (std::size_t i = 0; i < 3; ++i) result[k + i] = in_world[i];
    }
    return result;
  }

  void compare_contacts() const {
    std::array<Rational, kRows> f, f_b;
    std::array<Rational, 1> condition, condition_b;
    Vector<Rational> found;
    ExactState other = s;
    (void)satellite::contact_inverse_dynamics(s.q.data(), s.g_b, s.v.data(), s.a.data(), other.tau.data(), f_b.data(),
                                              condition_b.data(), s.sines());
    (void)C::of.contact_inverse_dynamics(q.data(), v.data(), a.data(), found.data(), f.data(), condition.data(),
                                         s.sines());
    checks.expect(found == force_in(meaning, s, other.tau) && f == turned_rows(f_b) && condition == condition_b,
                  meaning, "contact_inverse_dynamics");
    (void)satellite::constrained_forward_dynamics(s.q.data(), s.g_b, s.v.data(), s.tau.data(), other.a.data(),
                                                  f_b.data(), condition_b.data(), s.sines());
    (void)C::of.constrained_forward_dynamics(q.data(), v.data(), tau.data(), found.data(), f.data(), condition.data(),
                                             s.sines());
    checks.expect(found == acceleration_in(meaning, other) && f == turned_rows(f_b) && condition == condition_b,
                  meaning, "constrained_forward_dynamics");
    (void)satellite::contact_impact(s.q.data(), s.v.data(), other.v.data(), f_b.data(), condition_b.data(), s.sines());
    (void)C::of.contact_impact(q.data(), v.data(), found.data(), f.data(), condition.data(), s.sines());
    checks.expect(found == velocity_in(meaning, other) && f == turned_rows(f_b) && condition == condition_b, meaning,
                  "contact_impact");
  }

  void compare_contact_motion() const {
    std::array<Rational, 6> p, p_b;
    std::array<Rational, kRows * kSize> J, J_b;
    std::array<Rational, kRows> b, b_b;
    C::of.contact_jacobian(q.data(), p.data(), J.data(), s.sines());
    satellite::contact_jacobian(s.q.data(), p_b.data(), J_b.data(), s.sines());
    const Three<Rational> first = sum(s.p, turned(s.e, {p_b[0], p_b[1], p_b[2]})),
                          second = sum(s.p, turned(s.e, {p_b[3], p_b[4], p_b[5]}));
    const bool are_there = p == std::array<Rational, 6>{first[0], first[1], first[2], second[0], second[1], second[2]};
    checks.expect(are_there && times_v<kRows>(J, v) == turned_rows(times_v<kRows>(J_b, s.v)), meaning,
                  "velocity of the contacts");
    C::of.contact_bias(q.data(), v.data(), b.data(), s.sines());
    satellite::contact_bias(s.q.data(), s.v.data(), b_b.data(), s.sines());
    checks.expect(added(times_v<kRows>(J, a), b) == turned_rows(added(times_v<kRows>(J_b, s.a), b_b)), meaning,
                  "acceleration of the contacts");
  }

  static std::array<Rational, kRows> added(std::array<Rational, kRows> x, const std::array<Rational, kRows>& y) {
    for (std::size_t k = 0; k < kRows; ++k) x[k] = x[k] + y[k];
    return x;
  }

  static std::array<Rational, 6> plus(std::array<Rational, 6> x, const std::array<Rational, 6>& y) {
    for (std::size_t k = 0; k < 6; ++k) x[k] = x[k] + y[k];
    return x;
  }
};

template <class C>
void compare(const ExactState& s, Checks& checks) {
  const Comparison<C> comparison{s, checks};
  comparison.compare_torques();
  comparison.compare_free_motion();
  comparison.compare_tip_force();
  comparison.compare_matrices();
  comparison.compare_tip();
  comparison.compare_momentum();
  comparison.compare_contacts();
  comparison.compare_contact_motion();
}

}  // namespace

int main() {
  Checks checks;
  const Quaternion<Rational> unit[] = {{of(1, 5), of(2, 5), of(2, 5), of(4, 5)}, {of(-2, 7), of(3, 7), of(6, 7), 0}};
  for (int k = 0; k < 2; ++k) {
    const ExactState s = state(unit[k], k + 1);
    compare<pose>(s, checks);
    compare<pinocchio>(s, checks);
    compare<mujoco>(s, checks);
    compare<mixed>(s, checks);
    compare<featherstone>(s, checks);
  }
  std::printf("%d hold, %d do not\n", checks.held, checks.failed);
  return checks.failed == 0 ? 0 : 1;
}
