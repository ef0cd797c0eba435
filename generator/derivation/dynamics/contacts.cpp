// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/contacts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>

#include "derivation/dynamics/kinematics.hpp"
#include "robot/model/field_mechanism.hpp"

namespace flatdyn {
namespace {

std::size_t length_of(const Contact& contact) { return static_cast<std::size_t>(contact.rows()); }

Number entry_of(const JacobianColumn& column, std::size_t row) {
  return row < 3 ? column.linear[row] : column.angular[row - 3];
}

// The parents for a chain of bodies, with which all entries of a matrix may be non-zero.
std::vector<int> full_matrix(std::size_t size) {
  std::vector<int> parents(size);
  std::iota(parents.begin(), parents.end(), -1);
  return parents;
}

}  // namespace

Choices at_the_contacts(Choices choices, const Mechanism& mechanism) {
  for (const Contact& contact : mechanism.contacts) {
    if (contact.frame.body < 0) continue;
    choices.joints[static_cast<std::size_t>(contact.frame.body)].axes = Axes::turning;
  }
  choices.length_unit = 1;
  return choices;
}

std::vector<Vec3> contact_positions(DerivationContext& context) {
  std::vector<Vec3> positions;
  for (const Contact& contact : context.mechanism.contacts) {
    positions.push_back(position(context.frames, contact.frame));
  }
  return positions;
}

Rows contact_jacobian(DerivationContext& context) {
  Rows rows;
  for (const Contact& contact : context.mechanism.contacts) {
    const std::vector<JacobianColumn> columns =
        at_coordinates(context.mechanism, context.derivation, jacobian(context.frames, contact.frame));
    for (std::size_t row = 0; row < length_of(contact); ++row) {
      rows.emplace_back();
      for (const JacobianColumn& column : columns) rows.back().push_back(entry_of(column, row));
    }
  }
  return rows;
}

std::vector<Number> contact_drift(DerivationContext& context) {
  std::vector<Number> drift;
  for (const Contact& contact : context.mechanism.contacts) {
    const JacobianColumn each = jacobian_dot_qd(context.frames, contact.frame);
    for (std::size_t row = 0; row < length_of(contact); ++row) drift.push_back(entry_of(each, row));
  }
  return drift;
}

std::string contact_text(const std::vector<Contact>& contacts) {
  std::vector<std::string> texts;
  for (const Contact& contact : contacts) {
    texts.push_back(fmt::format("{} ({})", contact.name, contact.is_surface ? "x, y, z, rx, ry, rz" : "x, y, z"));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

ContactSpace::ContactSpace(DerivationContext& context)
    : context_(context),
      B_(context.frames, context.inertia()),
      J_(contact_jacobian(context)),
      Y_(solved_transposed_rows()),
      Z_(divided_by_pivots()),
      mobility_(mobility()),
      factors_(context.derivation, full_matrix(size()), mobility_, "J B^-1 J^T of the contacts", "m_") {}

Rows ContactSpace::solved_transposed_rows() const {
  Rows Y;
  for (std::size_t i = 0; i < size(); ++i) Y.push_back(B_.solved_transposed(J_[i], "y_" + label(static_cast<int>(i))));
  return Y;
}

std::vector<Number> ContactSpace::named(std::vector<Number> values, const std::string& name) const {
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = context_.derivation.named(values[k], name + "_" + label(static_cast<int>(k)));
  }
  return values;
}

Rows ContactSpace::divided_by_pivots() const {
  Rows Z = Y_;
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t k = 0; k < Z[i].size(); ++k) Z[i][k] = Y_[i][k] * B_.inverse_pivots()[k];
    Z[i] = named(Z[i], "z_" + label(static_cast<int>(i)));
  }
  return Z;
}

Rows ContactSpace::mobility() const {
  const Rational& damping = context_.mechanism.contact_damping;
  Rows M(size(), std::vector<Number>(size(), 0));
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      Number sum = i == j ? to_number(damping * damping) : Number(0);
      for (std::size_t k = 0; k < Y_[i].size(); ++k) sum += Z_[i][k] * Y_[j][k];
      const std::string name = fmt::format("m_{}_{}", label(static_cast<int>(i)), label(static_cast<int>(j)));
      M[i][j] = M[j][i] = context_.derivation.named(sum, name);
    }
  }
  return M;
}

// By row, the scale of the terms whose sums are in M: the mean of the three rows of one contact and unit, as the axes
// are not those in which a contact moves most. It is kContactMargin times as large, so that pivots with fewer digits
// left than that are refused.
std::vector<Number> ContactSpace::sizes() const {
  constexpr std::size_t kDirections = 3;
  std::vector<Number> result;
  for (std::size_t first = 0; first < size(); first += kDirections) {
    const Number sum = mobility_[first][first] + mobility_[first + 1][first + 1] + mobility_[first + 2][first + 2];
    const std::string name = "size_m_" + label(static_cast<int>(first));
    result.insert(result.end(), kDirections,
                  context_.derivation.named(Number(kContactMargin) / static_cast<int>(kDirections) * sum, name));
  }
  return result;
}

std::vector<Number> ContactSpace::with_forces(std::vector<Number> y, const std::vector<Number>& forces) const {
  for (std::size_t i = 0; i < size(); ++i) {
    for (std::size_t k = 0; k < y.size(); ++k) y[k] += Y_[i][k] * forces[i];
  }
  return named(std::move(y), "y_held");
}

ContactSpace::Solution ContactSpace::accelerations(std::vector<Number> b, const std::vector<Number>& drift) const {
  const std::vector<Number> y = B_.solved_transposed(std::move(b), "y");
  std::vector<Number> needed;
  for (std::size_t i = 0; i < size(); ++i) {
    Number sum = -drift[i];
    for (std::size_t k = 0; k < y.size(); ++k) sum -= Z_[i][k] * y[k];
    needed.push_back(sum);
  }
  const std::vector<Number> forces = factors_.solve(named(needed, "held"), "f_c");
  return {forces, B_.finished(with_forces(y, forces), "qdd")};
}

ContactSpace::Sensitivities ContactSpace::sensitivities() const {
  Derivation& d = context_.derivation;
  const std::size_t n = J_.front().size();
  Sensitivities result{B_.inverse("a"), Rows(n, std::vector<Number>(size(), 0)), factors_.inverse("lambda")};
  Rows U;  // B⁻¹ Jᵀ, by row of J
  for (std::size_t i = 0; i < size(); ++i) U.push_back(B_.finished(Y_[i], "u_" + label(static_cast<int>(i))));
  for (std::size_t k = 0; k < n; ++k) {
    const std::string of_row = "_" + context_.frames.label(static_cast<int>(k)) + "_";
    for (std::size_t i = 0; i < size(); ++i) {
      Number sum = 0;
      for (std::size_t j = 0; j < size(); ++j) sum += U[j][k] * result.Lambda[j][i];
      result.Q[k][i] = d.named(sum, "q" + of_row + label(static_cast<int>(i)));
    }
    for (std::size_t l = 0; l <= k; ++l) {
      Number entry = result.P[k][l];
      for (std::size_t i = 0; i < size(); ++i) entry -= result.Q[k][i] * U[i][l];
      result.P[k][l] = result.P[l][k] = d.named(entry, "p" + of_row + context_.frames.label(static_cast<int>(l)));
    }
  }
  return result;
}

ContactSpace::Solution ContactSpace::after_impact(const std::vector<Number>& velocity) const {
  std::vector<Number> needed;
  for (std::size_t i = 0; i < size(); ++i) {
    Number sum = 0;
    for (std::size_t k = 0; k < velocity.size(); ++k) sum -= J_[i][k] * velocity[k];
    needed.push_back(sum);
  }
  const std::vector<Number> impulses = factors_.solve(named(needed, "stopped"), "impulse");
  const std::vector<Number> none(velocity.size(), 0);
  std::vector<Number> after = B_.finished(with_forces(none, impulses), "dv");
  for (std::size_t k = 0; k < after.size(); ++k) after[k] += velocity[k];
  return {impulses, after};
}

Number ContactSpace::condition() const {
  Number sum = 0;
  for (std::size_t k = 0; k < size(); ++k) sum += mobility_[k][k] * factors_.inverse_pivots()[k];
  return context_.derivation.quotient(static_cast<int>(size()), context_.derivation.named(sum, "growth"), "condition");
}

Conditions ContactSpace::conditions() const {
  Conditions conditions{context_.nodes(factors_.pivots()), context_.nodes(factors_.pivot_scales(sizes()))};
  conditions.append(conditions_of(context_, B_));
  return conditions;
}

}  // namespace flatdyn
