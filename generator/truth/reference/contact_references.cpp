// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/contact_references.hpp"

#include "flatdyn/reference/contacts.hpp"
#include "truth/reference/acceleration_magnitude.hpp"
#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_point.hpp"

namespace flatdyn::references {
namespace {

namespace ref = reference;
using At = ReferencePoint<double>;
using RealVector = ref::VectorX<double>;
using RealMatrix = ref::MatrixX<double>;

template <class S>
std::vector<S> joined(std::initializer_list<ref::VectorX<S>> parts) {
  std::vector<S> entries;
  for (const ref::VectorX<S>& part : parts) entries.insert(entries.end(), part.begin(), part.end());
  return entries;
}

template <class S>
ref::VectorX<S> as_vector(const S& value) {
  return ref::VectorX<S>::Constant(1, value);
}

template <class S>
std::vector<S> jacobian_entries(const ReferencePoint<S>& at) {
  std::vector<S> entries = joined<S>({ref::contact_positions(at.robot, at.q)});
  const std::vector<S> more = row_by_row(ref::contact_jacobian(at.robot, at.q));
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

template <class S>
std::vector<S> constrained_entries(const ReferencePoint<S>& at) {
  const ref::Held<S> held = ref::constrained_forward_dynamics(at.robot, at.q, at.qd, at.tau);
  return joined<S>({held.motion, held.forces, as_vector(ref::pivot_condition(ref::contact_space(at.robot, at.q).M))});
}

template <class S>
std::vector<S> inverse_entries(const ReferencePoint<S>& at) {
  const ref::Held<S> held = ref::contact_inverse_dynamics(at.robot, at.q, at.qd, at.qdd);
  const ref::MatrixX<S> moments = ref::moments_of_support(at.robot, at.q);
  return joined<S>({held.motion, held.forces, as_vector(ref::pivot_condition(moments))});
}

template <class S>
std::vector<S> impact_entries(const ReferencePoint<S>& at) {
  const ref::Held<S> held = ref::contact_impact(at.robot, at.q, at.qd);
  return joined<S>({held.motion, held.forces, as_vector(ref::pivot_condition(ref::contact_space(at.robot, at.q).M))});
}

// The sums of the absolute terms of the contacts' Jacobian, and of their accelerations.
RealMatrix contact_jacobian_terms(const At& at) {
  RealMatrix terms(ref::contact_rows(at.robot), at.robot.size());
  ref::for_each_contact(at.robot, [&](const ref::Robot<double>& there, Eigen::Index first, Eigen::Index rows) {
    terms.middleRows(first, rows) = ref::jacobian_magnitude(there, at.q).topRows(rows);
  });
  return terms;
}

RealVector contact_drift_terms(const At& at) {
  RealVector terms(ref::contact_rows(at.robot));
  ref::for_each_contact(at.robot, [&](const ref::Robot<double>& there, Eigen::Index first, Eigen::Index rows) {
    const Eigen::Vector2d m = ref::tip_acceleration_magnitude(there, at.q, at.qd);
    terms.segment(first, 3).setConstant(m[0]);
    if (rows > 3) terms.segment(first + 3, 3).setConstant(m[1]);
  });
  return terms;
}

std::vector<double> jacobian_entry_terms(const At& at) {
  std::vector<double> entries;
  ref::for_each_contact(at.robot, [&](const ref::Robot<double>& there, Eigen::Index, Eigen::Index) {
    entries.insert(entries.end(), 3, ref::reach(there, at.q));
  });
  const std::vector<double> more = row_by_row(contact_jacobian_terms(at));
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

// 1, and the growth of errors of the pivots that the condition is made of.
double condition_terms(const RealMatrix& M, const RealMatrix& M_terms) {
  double sum = 0, growth = 0;
  for (Eigen::Index k = 0; k < M.rows(); ++k) {
    const Eigen::Index rest = M.rows() - k;
    const RealMatrix inverse = M.bottomRightCorner(rest, rest).inverse().cwiseAbs();
    sum += M(k, k) * inverse(0, 0);
    growth += M_terms(k, k) * inverse(0, 0);
    growth += M(k, k) * inverse.row(0).dot(M_terms.bottomRightCorner(rest, rest) * inverse.col(0));
  }
  return static_cast<double>(M.rows()) / sum * (1 + growth / sum);
}

// The effect of an error in the last place of each term of B, J and what acts; inverses propagate it.
class ContactMagnitude {
 public:
  explicit ContactMagnitude(const At& at)
      : at_(at), space_(ref::contact_space(at.robot, at.q)), J_terms_(contact_jacobian_terms(at)) {
    inverse_ = space_.B_inverse.cwiseAbs();
    inverse_terms_ = inverse_ * ref::inertia_magnitude(at.robot, at.q) * inverse_;
    M_terms_ = J_terms_ * (inverse_terms_ + inverse_) * J_terms_.transpose();
    W_ = space_.M.inverse().cwiseAbs();
    W_terms_ = W_ * M_terms_ * W_;
  }

  std::vector<double> accelerations() const {
    const RealVector free = ref::forward_dynamics(at_.robot, at_.q, at_.qd, at_.tau);
    const RealVector free_terms = acceleration_magnitude(at_);
    const RealVector held = space_.J * free + ref::contact_drift(at_.robot, at_.q, at_.qd);
    const RealVector held_terms = J_terms_ * (free.cwiseAbs() + free_terms) + contact_drift_terms(at_);
    return entries(free_terms, held, held_terms);
  }

  std::vector<double> impact() const {
    const RealVector speed = at_.qd.cwiseAbs();
    return entries(speed, space_.J * at_.qd, J_terms_ * speed);
  }

 private:
  // The magnitudes of the motion, of the forces M^-1 `held`, and of the condition.
  std::vector<double> entries(const RealVector& free_terms, const RealVector& held,
                              const RealVector& held_terms) const {
    const RealVector forces = (space_.M.inverse() * held).cwiseAbs();
    const RealVector force_terms = W_ * held_terms + W_terms_ * held.cwiseAbs();
    const RealVector motion_terms =
        free_terms + (inverse_terms_ + inverse_) * (J_terms_.transpose() * (forces + force_terms));
    return joined<double>({motion_terms, force_terms, as_vector(condition_terms(space_.M, M_terms_))});
  }

  const At& at_;
  ref::ContactSpace<double> space_;
  RealMatrix J_terms_, inverse_, inverse_terms_, M_terms_, W_, W_terms_;
};

std::vector<double> inverse_dynamics_terms(const At& at) {
  const RealMatrix J_terms = contact_jacobian_terms(at), A_terms = J_terms.leftCols(6).transpose();
  const RealMatrix A = ref::support_of_base(at.robot, at.q), square = A * A.transpose();
  const RealMatrix inverse = square.inverse().cwiseAbs(), square_terms = A_terms * A_terms.transpose();
  const RealVector torque_terms = ref::torque_magnitude(at.robot, at.q, at.qd, at.qdd);
  const RealVector needed = ref::inverse_dynamics(at.robot, at.q, at.qd, at.qdd).head(6);
  const RealVector turned = (square.inverse() * needed).cwiseAbs();
  const RealVector turned_terms = inverse * (torque_terms.head(6) + square_terms * turned);
  const RealVector force_terms = A_terms.transpose() * (turned + turned_terms);
  const RealVector forces = (A.transpose() * (square.inverse() * needed)).cwiseAbs();
  RealVector tau_terms = torque_terms + J_terms.transpose() * (forces + force_terms);
  const RealMatrix moments = ref::moments_of_support(at.robot, at.q);
  return joined<double>(
      {tau_terms, force_terms, as_vector(condition_terms(moments, square_terms.bottomRightCorner<3, 3>()))});
}

// Each entry is a sum of three numbers times entries of a rotation or a mirror.
RealMatrix cone_terms(const At& at) {
  RealMatrix terms(0, ref::contact_rows(at.robot));
  Eigen::Index first = 0;
  for (const ref::Contact<double>& contact : at.robot.contacts) {
    for (const std::array<double, 6>& row : contact.cone) {
      terms.conservativeResize(terms.rows() + 1, Eigen::NoChange);
      terms.bottomRows(1).setZero();
      for (Eigen::Index k = 0; k < contact.rows(); ++k) {
        const std::size_t own = k < 3 ? 0 : 3;
        terms(terms.rows() - 1, first + k) = std::abs(row[own]) + std::abs(row[own + 1]) + std::abs(row[own + 2]);
      }
    }
    first += contact.rows();
  }
  return terms;
}

}  // namespace

constinit const NumericReference contact_jacobian = computed_by([](const auto& at) { return jacobian_entries(at); },
                                                                [](const At& at) { return jacobian_entry_terms(at); });

constinit const NumericReference contact_bias =
    computed_by([](const auto& at) { return row_by_row(ref::contact_drift(at.robot, at.q, at.qd)); },
                [](const At& at) { return row_by_row(contact_drift_terms(at)); });

constinit const NumericReference constrained_forward_dynamics =
    computed_by([](const auto& at) { return constrained_entries(at); },
                [](const At& at) { return ContactMagnitude(at).accelerations(); });

constinit const NumericReference contact_inverse_dynamics = computed_by(
    [](const auto& at) { return inverse_entries(at); }, [](const At& at) { return inverse_dynamics_terms(at); });

constinit const NumericReference contact_impact = computed_by(
    [](const auto& at) { return impact_entries(at); }, [](const At& at) { return ContactMagnitude(at).impact(); });

constinit const NumericReference friction_cones =
    computed_by([](const auto& at) { return row_by_row(ref::friction_cones(at.robot, at.q)); },
                [](const At& at) { return row_by_row(cone_terms(at)); });

}  // namespace flatdyn::references
