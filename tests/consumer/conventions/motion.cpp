// SPDX-License-Identifier: BSD-3-Clause
// Conventions in motion: v and a are what integrate() makes of them. Derivatives by time are central differences, and
// a long way is compared with many short steps of the kinematics.
#include <algorithm>
#include <cmath>

#include "robot.hpp"

namespace {

constexpr double kStep = 1e-5, kClose = 2e-8;  // of the largest entry, for central differences

template <std::size_t n>
double largest(const std::array<double, n>& x) {
  double most = 0;
  for (const double each : x) most = std::fmax(most, std::fabs(each));
  return most;
}

template <std::size_t n>
bool are_close(const std::array<double, n>& a, const std::array<double, n>& b, double tolerance) {
  std::array<double, n> difference;
  for (std::size_t k = 0; k < n; ++k) difference[k] = a[k] - b[k];
  return largest(difference) <= tolerance * std::fmax(1, largest(b));
}

Quaternion<double> of_unit_length(Quaternion<double> e) {
  const double length = std::sqrt(product(e, {e[0], -e[1], -e[2], -e[3]})[0]);
  for (double& each : e) each /= length;
  return e;
}

State<double> state(int k) {
  State<double> s;
  s.p = {0.3 * k, -0.7, 1.1};
  s.e = of_unit_length({0.1 + 0.3 * k, -0.5, 0.7, 0.4});
  const Quaternion<double> ball = of_unit_length({0.6, 0.2 * k, -0.9, 0.5 - 0.1 * k});
  s.q = {0.4 - k, ball[0], ball[1], ball[2], ball[3], 0.2 * k};
  for (std::size_t i = 0; i < kSize; ++i) {
    s.v[i] = std::sin(1.7 * double(i) + k);
    s.a[i] = 2 * std::cos(2.3 * double(i) - k);
  }
  return s;
}

// Velocity of the origin and angular velocity, both in world axes.
template <class C>
void velocities(const Pose<double>& q, const Vector<double>& v, Three<double>& linear, Three<double>& angular) {
  constexpr Meaning m = C::meaning;
  const Quaternion<double> e = quaternion_in(m, q, 3);
  linear = part(v, m.angular_first ? 3 : 0);
  angular = part(v, m.angular_first ? 0 : 3);
  if (m.linear == Axes::base) linear = turned(e, linear);
  if (m.angular == Axes::base) angular = turned(e, angular);
}

// The derivatives of positions and quaternions: the origin's velocity; omega times the base's quaternion by 2, with
// omega in world axes; the ball's times omega by 2, with omega in axes of its child.
template <class C>
Pose<double> rate(const Pose<double>& q, const Vector<double>& v) {
  constexpr Meaning m = C::meaning;
  Three<double> linear, omega;
  velocities<C>(q, v, linear, omega);
  Pose<double> result = {linear[0], linear[1], linear[2]};
  write_quaternion(m, product({0, omega[0] / 2, omega[1] / 2, omega[2] / 2}, quaternion_in(m, q, 3)), result, 3);
  result[7] = v[6];
  const Three<double> turn = part(v, kBallVelocity);
  write_quaternion(m, product(quaternion_in(m, q, 7 + kBall), {0, turn[0] / 2, turn[1] / 2, turn[2] / 2}), result,
                   7 + kBall);
  result[kPositions - 1] = v[kSize - 1];
  return result;
}

Pose<double> plus(Pose<double> q, const Pose<double>& rate, double dt) {
  for (std::size_t k = 0; k < q.size(); ++k) q[k] += dt * rate[k];
  return q;
}

// The way of time 1 by Runge and Kutta's method of fourth order.
template <class C>
Pose<double> by_short_steps(Pose<double> q, const Vector<double>& v) {
  constexpr int kSteps = 2000;
  constexpr double dt = 1.0 / kSteps;
  for (int step = 0; step < kSteps; ++step) {
    const Pose<double> k1 = rate<C>(q, v), k2 = rate<C>(plus(q, k1, dt / 2), v), k3 = rate<C>(plus(q, k2, dt / 2), v),
                       k4 = rate<C>(plus(q, k3, dt), v);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += dt / 6 * (k1[k] + 2 * k2[k] + 2 * k3[k] + k4[k]);
  }
  return q;
}

template <class C>
struct Motion {
  static constexpr Meaning meaning = C::meaning;
  const State<double> s;
  Checks& checks;
  Pose<double> q = pose_in(meaning, s);
  Vector<double> v = velocity_in(meaning, s), a = acceleration_in(meaning, s);

  void expect(bool holds, const char* what) const { checks.expect(holds, meaning, what); }

  // The derivative by time, at constant v, of what a function makes of q.
  template <class Function>
  auto derivative(Function of_q) const {
    auto result = of_q(C::integrated(q, v, kStep));
    const auto before = of_q(C::integrated(q, v, -kStep));
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = (result[k] - before[k]) / (2 * kStep);
    return result;
  }

  template <std::size_t rows>
  static std::array<double, rows> times_v(const std::array<double, rows * kSize>& matrix, const Vector<double>& v) {
    std::array<double, rows> result = {};
    for (std::size_t k = 0; k < matrix.size(); ++k) result[k / kSize] += matrix[k] * v[k % kSize];
    return result;
  }

  // Linear, angular: in the convention's order.
  static Three<double> linear(const std::array<double, 6>& x) {
    const std::size_t at = meaning.angular_first ? 3 : 0;
    return {x[at], x[at + 1], x[at + 2]};
  }
  static Three<double> angular(const std::array<double, 6>& x) {
    const std::size_t at = meaning.angular_first ? 0 : 3;
    return {x[at], x[at + 1], x[at + 2]};
  }

  static std::array<double, 6> tip_velocity(const Pose<double>& at, const Vector<double>& v) {
    std::array<double, 6 * kSize> J;
    C::of.jacobian(at.data(), J.data());
    return times_v<6>(J, v);
  }

  void move_the_tip() const {
    std::array<double, 9> R;
    Three<double> p;
    C::of.forward_kinematics(q.data(), R.data(), p.data());
    const Three<double> rate_of_p = derivative([](const Pose<double>& at) {
      std::array<double, 9> R_at;
      Three<double> p_at;
      C::of.forward_kinematics(at.data(), R_at.data(), p_at.data());
      return p_at;
    });
    const std::array<double, 9> rate_of_R = derivative([](const Pose<double>& at) {
      std::array<double, 9> R_at;
      Three<double> p_at;
      C::of.forward_kinematics(at.data(), R_at.data(), p_at.data());
      return R_at;
    });
    const std::array<double, 6> twist = tip_velocity(q, v);
    expect(are_close(rate_of_p, linear(twist), kClose), "J v is the tip's velocity");
    for (std::size_t k = 0; k < 3; ++k) {
      const Three<double> wanted = cross(angular(twist), {R[k], R[k + 3], R[k + 6]});
      expect(are_close({rate_of_R[k], rate_of_R[k + 3], rate_of_R[k + 6]}, wanted, kClose), "J v turns the tip");
    }
    std::array<double, 6> b;
    C::of.jacobian_dot_qd(q.data(), v.data(), b.data());
    expect(are_close(derivative([this](const Pose<double>& at) { return tip_velocity(at, v); }), b, kClose),
           "jacobian_dot_qd is the derivative of J v");
  }

  void move_the_centre_of_mass() const {
    const auto momentum = [this](const Pose<double>& at) {
      std::array<double, 6 * kSize> A;
      C::of.centroidal_momentum_matrix(at.data(), A.data());
      return times_v<6>(A, v);
    };
    std::array<double, 6> b;
    C::of.centroidal_bias(q.data(), v.data(), b.data());
    expect(are_close(derivative(momentum), b, kClose), "centroidal_bias is the derivative of A_G v");
    Three<double> r, velocity, p;
    std::array<double, 3 * kSize> J;
    C::of.centre_of_mass(q.data(), r.data(), J.data());
    velocity = times_v<3>(J, v);
    const Three<double> rate_of_r = derivative([](const Pose<double>& at) {
      Three<double> r_at;
      std::array<double, 3 * kSize> J_at;
      C::of.centre_of_mass(at.data(), r_at.data(), J_at.data());
      return r_at;
    });
    expect(are_close(rate_of_r, velocity, kClose), "J_G v is the velocity of the centre of mass");
    constexpr double kMass = 32;
    for (std::size_t k = 0; k < 3; ++k) p[k] = kMass * velocity[k];
    expect(are_close(linear(momentum(q)), p, 1e-13), "momentum is m v");
  }

  // B - 2 C is skew-symmetric, as C is that of this convention's velocities.
  void differentiate_inertia() const {
    Matrix<double> C_of_v, wanted;
    C::of.coriolis_matrix(q.data(), v.data(), C_of_v.data());
    for (std::size_t i = 0; i < kSize; ++i) {
      for (std::size_t k = 0; k < kSize; ++k) wanted[kSize * i + k] = C_of_v[kSize * i + k] + C_of_v[kSize * k + i];
    }
    const Matrix<double> rate_of_B = derivative([](const Pose<double>& at) {
      Matrix<double> B;
      C::of.inertia_matrix(at.data(), B.data());
      return B;
    });
    expect(are_close(rate_of_B, wanted, kClose), "dB/dt = C + C^T");
  }

  void integrate_far() const {
    const Pose<double> found = C::integrated(q, v, 1.0);
    expect(are_close(found, by_short_steps<C>(q, v), 1e-11), "integrate is the sum of short steps");
    Pose<double> in_place = q;
    C::integrated_in_place(in_place, v, 1.0);
    expect(in_place == found, "integrate in place");
    expect(are_close(C::difference(q, found), v, 1e-14), "difference is its inverse");
    Pose<double> other = pose_in(meaning, state(7));
    const Pose<double> again = C::integrated(q, C::difference(q, other), 1.0);
    for (const std::size_t first : {std::size_t{3}, 7 + kBall}) {
      double sense = 0;
      for (std::size_t k = first; k < first + 4; ++k) sense += again[k] * other[k];
      for (std::size_t k = first; k < first + 4 && sense < 0; ++k) other[k] = -other[k];
    }
    expect(are_close(again, other, 1e-14), "integrate is the inverse of difference");
  }

  // Turns so small that their squares vanish, turns by nearly pi, and none.
  void integrate_by(double size) const {
    Vector<double> small = v;
    const std::size_t at = meaning.angular_first ? 0 : 3;
    const double length = std::sqrt(v[at] * v[at] + v[at + 1] * v[at + 1] + v[at + 2] * v[at + 2]);
    for (std::size_t k = at; k < at + 3; ++k) small[k] *= size / length;
    const Vector<double> found = C::difference(C::integrated(q, small, 1.0), q);
    Vector<double> wanted = C::difference(q, C::integrated(q, small, 1.0));
    bool same = true;
    for (std::size_t k = 0; k < kSize; ++k) {
      same = same && std::fabs(wanted[k] - small[k]) <= 4e-15;
      if (meaning.linear == Axes::world || k < at || k > at + 2) continue;
      same = same && std::fabs(found[k] + small[k]) <= 4e-15;
    }
    expect(same, "difference after small, large and no turns");
  }

  // The quaternion's length is used as it is: 1e-7 more makes at most 4.1e-7 more of a term.
  void stretch() const {
    Pose<double> longer = q;
    for (std::size_t k = 3; k < 7; ++k) longer[k] *= 1 + 1e-7;
    Vector<double> g, of_longer;
    C::of.gravity(q.data(), g.data());
    C::of.gravity(longer.data(), of_longer.data());
    const double off = std::fabs(largest(of_longer) / largest(g) - 1);
    expect(off > 1.9e-7 && off < 4.1e-7, "a quaternion of another length");
    const Pose<double> next = C::integrated(longer, v, 0.1);
    expect(std::fabs(next[3] * next[3] + next[4] * next[4] + next[5] * next[5] + next[6] * next[6] - 1) < 1e-15,
           "integrate returns quaternions of unit length");
  }

  // Everything in float, with a few of its units in the last place.
  void repeat_in_float() const {
    Pose<float> q_f;
    Vector<float> v_f, a_f, tau_f;
    Vector<double> tau;
    std::copy(q.begin(), q.end(), q_f.begin());
    std::copy(v.begin(), v.end(), v_f.begin());
    std::copy(a.begin(), a.end(), a_f.begin());
    C::of.inverse_dynamics(q.data(), v.data(), a.data(), tau.data());
    C::of.inverse_dynamics(q_f.data(), v_f.data(), a_f.data(), tau_f.data());
    Vector<double> found;
    std::copy(tau_f.begin(), tau_f.end(), found.begin());
    expect(are_close(found, tau, 2e-6), "inverse_dynamics in float");
    const Vector<float> back = C::difference(q_f, C::integrated(q_f, v_f, 1.0f));
    std::copy(back.begin(), back.end(), found.begin());
    expect(are_close(found, v, 4e-6), "difference in float");
  }
};

template <class C>
void move(const State<double>& s, Checks& checks) {
  const Motion<C> motion{s, checks};
  motion.move_the_tip();
  motion.move_the_centre_of_mass();
  motion.differentiate_inertia();
  motion.integrate_far();
  for (const double size : {0.0, 1e-300, 1e-160, 1e-20, 1e-8, 1e-3, 0.999, 1.001, 3.1}) motion.integrate_by(size);
  motion.stretch();
  motion.repeat_in_float();
}

}  // namespace

int main() {
  Checks checks;
  for (int k = 0; k < 3; ++k) {
    const State<double> s = state(k);
    move<pose>(s, checks);
    move<pinocchio>(s, checks);
    move<mujoco>(s, checks);
    move<mixed>(s, checks);
    move<featherstone>(s, checks);
  }
  std::printf("%d hold, %d do not\n", checks.held, checks.failed);
  return checks.failed == 0 ? 0 : 1;
}
