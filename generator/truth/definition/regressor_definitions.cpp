// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/regressor_definitions.hpp"

#include <functional>

#include "derivation/parameters/base_parameters.hpp"
#include "truth/definition/lagrangian_regressor.hpp"
#include "truth/definition/rules.hpp"

namespace flatdyn::definitions {
namespace {

// The regressors at a point, by the Lagrangian.
template <class Point>
class RegressorDefinition {
 public:
  using F = typename Point::F;
  using Values = typename Point::Values;

  explicit RegressorDefinition(Point& point)
      : point_(point),
        number_(point.mechanism.symbols, point.arithmetic),
        lagrangian_(point.lagrangian.mechanism(), point.q) {}

  // Y, with tau = Y π.
  Matrix<F> actual() const {
    return lagrangian_.regressor(point_.qd(), point_.accelerations_of_coordinates(point_.qdd()), point_.signs());
  }

  // Y of the torques B q̈_r + C(q, q̇) q̇_r + g + friction at q̇_r.
  Matrix<F> adaptive() const {
    return lagrangian_.adaptive(point_.qd(), point_.drawn(InputKind::qd_r), point_.reference_accelerations(),
                                joint_signs(point_.mechanism, point_.arithmetic, InputKind::qd_r));
  }

  // Y without the columns of parameters that the mechanism does not have.
  Values all_columns() const {
    const Matrix<F> Y = actual();
    Values entries;
    for (int i = 0; i < Y.rows(); ++i) {
      for (const int k : parameter_indices(point_.mechanism)) entries.push_back(Y(i, k));
    }
    return entries;
  }

  // Y_s of the joints' springs. Angles are among the positions of joints that have a spring.
  Values spring_columns() const {
    Mechanism sprung = point_.mechanism;
    const std::vector<int> bodies = sprung.bodies_on_one_axis();
    for (const int i : bodies) sprung.bodies[static_cast<std::size_t>(i)].stiffness = 1;
    const LagrangianRegressor<F> lagrangian(point_.lagrangian.mechanism(), joint_points(sprung, point_.arithmetic));
    const Matrix<F> Y = lagrangian.springs();
    Values entries;
    for (int i = 0; i < Y.rows(); ++i) {
      for (const int j : bodies) entries.insert(entries.end(), {Y(i, 2 * j), Y(i, 2 * j + 1)});
    }
    return entries;
  }

  // Y with the columns zero of parameters that the model does not have, as in Y_b K.
  Values given_columns(const Matrix<F>& Y) const {
    const std::vector<bool> given = parameters_in(point_.mechanism, ParameterSet::given);
    Values entries;
    for (int i = 0; i < Y.rows(); ++i) {
      for (int k = 0; k < Y.cols(); ++k) entries.push_back(given[static_cast<std::size_t>(k)] ? Y(i, k) : F(0));
    }
    return entries;
  }

  // Y_b K for the function's own Y_b, with the terms that vanish only where the loops are closed. `AllColumns`: a
  // function object without state that returns Y of this object, which only robots with loops need.
  template <class AllColumns>
  Values expanded(const Values& own) const {
    const BaseParameters base = flatdyn::base_parameters(point_.mechanism);
    const Matrix<F> Y = base.shifts.empty() ? Matrix<F>() : AllColumns{}(*this);
    const auto columns = static_cast<std::size_t>(kParametersPerJoint * point_.mechanism.body_count());
    const auto b = static_cast<std::size_t>(base.size());
    Values product;
    for (int i = 0; i < point_.mechanism.size(); ++i) {
      Values row(columns, F(0));
      for (std::size_t k = 0; k < b; ++k) {
        const F& factor = own[static_cast<std::size_t>(i) * b + k];
        for (const auto& [index, coefficient] : base.combination[k]) {
          row[static_cast<std::size_t>(index)] += factor * number_(coefficient);
        }
      }
      add_hidden(base, Y, i, row);
      product.insert(product.end(), row.begin(), row.end());
    }
    return product;
  }

  // The torques Y_b π_b of these base parameters.
  Values torques(const Matrix<F>& Y, const BaseParameters& base, const Values& pi_b) const {
    Values tau(static_cast<std::size_t>(Y.rows()), F(0));
    for (std::size_t k = 0; k < pi_b.size(); ++k) {
      for (int i = 0; i < Y.rows(); ++i) tau[static_cast<std::size_t>(i)] += Y(i, base.columns[k]) * pi_b[k];
    }
    return tau;
  }

  // The torques Y_b π_b of the function's own π_b, with the terms that vanish only where the loops are closed.
  Values torques_of_all(const Values& pi_b) const {
    const BaseParameters base = flatdyn::base_parameters(point_.mechanism);
    const Matrix<F> Y = actual();
    const Values pi = parameters();
    Values tau = torques(Y, base, pi_b);
    for (const LoopShift& loop : base.shifts) {
      const F hidden = product(loop.share, [&](int index) { return pi[static_cast<std::size_t>(index)]; });
      for (int i = 0; i < Y.rows(); ++i) {
        tau[static_cast<std::size_t>(i)] += product(loop.shift, [&](int index) { return Y(i, index); }) * hidden;
      }
    }
    return tau;
  }

  // π.
  Values parameters() const {
    Values values;
    for (const Number& parameter : dynamic_parameters(point_.mechanism)) values.push_back(number_(parameter));
    return values;
  }

 private:
  F product(const ParameterForm& form, const std::function<F(int)>& factor) const {
    F sum(0);
    for (const auto& [index, coefficient] : form) sum += number_(coefficient) * factor(index);
    return sum;
  }

  // Adds row i of Σ (Y shift) share.
  void add_hidden(const BaseParameters& base, const Matrix<F>& Y, int i, Values& row) const {
    for (const LoopShift& loop : base.shifts) {
      const F moved = product(loop.shift, [&](int index) { return Y(i, index); });
      for (const auto& [index, coefficient] : loop.share) {
        row[static_cast<std::size_t>(index)] += moved * number_(coefficient);
      }
    }
  }

  Point& point_;
  NumberMap<std::decay_t<decltype(Point::arithmetic)>> number_;
  LagrangianRegressor<F> lagrangian_;
};

template <class Point>
RegressorDefinition<Point> regressors_at(Point& point) {
  return RegressorDefinition<Point>(point);
}

constexpr double no_factor(const Mechanism&, const Function&) { return 1; }
// Y_b π_b is compared with Y π.
constexpr double one_factor_more(const Mechanism&, const Function&) { return 2; }

// The definition of a base regressor, which is compared in all columns. `AllColumns`: as for expanded().
template <class AllColumns>
constexpr Definition compared_in_all_columns(AllColumns) {
  return {
      .expected = rules([](auto& at, const Output&) {
        const auto regressors = regressors_at(at);
        return regressors.given_columns(AllColumns{}(regressors));
      }),
      .found = rules([](auto& at, const Output& output) {
        return regressors_at(at).template expanded<AllColumns>(at.own(output));
      }),
      .degree_factor = no_factor,
      .is_over_parameters = true,
  };
}

}  // namespace

constinit const Definition regressor = {
    .expected = rules([](auto& at, const Output&) { return regressors_at(at).all_columns(); }),
    .found = kOwnValues,
    .degree_factor = no_factor,
    .is_over_parameters = true,
};

constinit const Definition spring_regressor = {
    .expected = rules([](auto& at, const Output&) { return regressors_at(at).spring_columns(); }),
    .found = kOwnValues,
    .degree_factor = no_factor,
    .is_over_parameters = true,
};

constinit const Definition base_regressor =
    compared_in_all_columns([](const auto& regressors) { return regressors.actual(); });

constinit const Definition base_parameters = {
    .expected = rules([](auto& at, const Output&) {
      const auto regressors = regressors_at(at);
      return times(regressors.actual(), regressors.parameters());
    }),
    .found = rules([](auto& at, const Output& output) { return regressors_at(at).torques_of_all(at.own(output)); }),
    .degree_factor = one_factor_more,
    .is_over_parameters = true,
};

constinit const Definition inverse_dynamics_base = {
    .expected = rules([](auto& at, const Output&) {
      const auto regressors = regressors_at(at);
      const BaseParameters base = flatdyn::base_parameters(at.mechanism);
      return regressors.torques(regressors.actual(), base, at.drawn(InputKind::pi_b, base.size()));
    }),
    .found = kOwnValues,
    .degree_factor = no_factor,
    .is_over_parameters = true,
};

constinit const Definition adaptive_regressor =
    compared_in_all_columns([](const auto& regressors) { return regressors.adaptive(); });

}  // namespace flatdyn::definitions
