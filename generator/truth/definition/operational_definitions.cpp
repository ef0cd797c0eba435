// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/operational_definitions.hpp"

#include "truth/definition/elimination_over_field.hpp"
#include "truth/definition/rules.hpp"
#include "truth/definition/task_definition.hpp"

namespace flatdyn::definitions {
namespace {

template <class F>
F trace(const Matrix<F>& A) {
  F sum(0);
  for (int i = 0; i < A.rows(); ++i) sum += A(i, i);
  return sum;
}

// Operational space at a point: J, B^-1 Jᵀ, M = J B^-1 Jᵀ + λ² 1 and its inverse B_A.
template <class Point>
class OperationalDefinition {
 public:
  using F = typename Point::F;
  using Values = typename Point::Values;

  explicit OperationalDefinition(Point& point)
      : point_(point), task_(point.function.task), J_(rows(), joints()), Jt_(joints(), rows()) {
    const Matrix<F> all = definition().jacobian();
    for (int i = 0; i < rows(); ++i) {
      for (int k = 0; k < joints(); ++k) J_(i, k) = Jt_(k, i) = all(task_.rows[static_cast<std::size_t>(i)], k);
    }
    X_ = solution(point.lagrangian.inertia(), Jt_);
    M_ = mobility();
    Matrix<F> unit(rows(), rows());
    for (int i = 0; i < rows(); ++i) unit(i, i) = F(1);
    B_A_ = solution(M_, unit);
  }

  Values inertia() const { return B_A_.entries(); }
  Values consistent_inverse() const { return times(X_, B_A_).entries(); }
  Values condition() const { return {F(static_cast<std::uint64_t>(rows() * rows())) / (trace(M_) * trace(B_A_))}; }
  Values gravity() { return force(acceleration(point_.lagrangian.gravity())); }

  Values coriolis() {
    const Values qd = point_.qd();
    Values c = acceleration(times(point_.coriolis_matrix(), qd));
    const Values drift = definition().drift(point_.jacobian_dot_qd(point_.frame()), qd);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += -drift[static_cast<std::size_t>(task_.rows[i])];
    return force(c);
  }

  Values null_space_torque() {
    const Values tau = point_.drawn(InputKind::tau);
    Values rest = times(Jt_, force(acceleration(tau)));
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = tau[k] + -rest[k];
    return rest;
  }

 private:
  int rows() const { return static_cast<int>(task_.rows.size()); }
  int joints() const { return point_.mechanism.size(); }

  TaskDefinition<F> definition() {
    const auto root = [this](const F& x) { return point_.arithmetic.sqrt(x); };
    return {task_, point_.lagrangian, point_.frame(), root};
  }

  Matrix<F> mobility() const {
    Matrix<F> M = times(J_, X_);
    const F damping = point_.arithmetic.constant(task_.damping);
    for (int i = 0; i < M.rows(); ++i) M(i, i) += damping * damping;
    return M;
  }

  // J B^-1 times joint torques, and B_A times accelerations of the task.
  Values acceleration(const Values& torques) { return times(J_, solution(point_.lagrangian.inertia(), torques)); }
  Values force(const Values& accelerations) const { return times(B_A_, accelerations); }

  Point& point_;
  const Task& task_;
  Matrix<F> J_, Jt_, X_, M_, B_A_;
};

template <class Point>
OperationalDefinition<Point> space_at(Point& point) {
  return OperationalDefinition<Point>(point);
}

// The factor by which Euler angles multiply degrees: up to seven entries of R times one of J, and a root, see
// root_factor().
constexpr double kAngleFactor = 32;

// B_A is the inverse of J B^-1 Jᵀ, which has at most six rows, and B^-1 is adj B / det B.
double operational_degree(const Mechanism& mechanism, const Function& function) {
  const double factor = 2.0 * static_cast<double>(function.task.rows.size()) * (mechanism.size() + 2);
  return function.task.has_angles() ? kAngleFactor * factor : factor;
}

template <class Generic>
constexpr Definition over_task(Generic expected) {
  return {rules(expected), kOwnValues, operational_degree};
}

}  // namespace

constinit const Definition operational_inertia = over_task([](auto& at, const Output& output) {
  const auto space = space_at(at);
  if (output.name == "condition") return space.condition();
  return output.name == "B_A" ? space.inertia() : space.consistent_inverse();
});

constinit const Definition operational_bias = over_task([](auto& at, const Output& output) {
  return output.name == "g_A" ? space_at(at).gravity() : space_at(at).coriolis();
});

constinit const Definition null_space_torque =
    over_task([](auto& at, const Output&) { return space_at(at).null_space_torque(); });

}  // namespace flatdyn::definitions
