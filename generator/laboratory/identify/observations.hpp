// SPDX-License-Identifier: GPL-2.0-or-later
// The information of measured motion on the base parameters: for every joint, the triangular factor of its rows of Ȳ
// π_b = τ̄, (7.84). Logs of any length and number, or parts of them, become one such object.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laboratory/identify/equation_filter.hpp"
#include "laboratory/identify/noise_shape.hpp"
#include "laboratory/identify/triangular_factor.hpp"

namespace flatdyn {

// |Y_i π_b - τ_i|² summed over the samples is |R (π_b restricted to `columns`, -1)|².
struct JointObservations {
  std::vector<int> columns;  // columns of Y_b that row i has, ascending
  Eigen::MatrixXd R;         // (columns + 1)², upper triangular
  long rows = 0;             // samples folded
  double correlation = 1;    // correlation of the noise, NoiseShape::correlation()
  long left_out = 0;         // samples that were too few

  Eigen::MatrixXd A() const { return R.leftCols(R.cols() - 1); }
  Eigen::VectorXd b() const { return R.col(R.cols() - 1); }
  // The entries of π_b that joint i depends on.
  Eigen::VectorXd restricted(const Eigen::VectorXd& pi_b) const { return pi_b(columns); }
  // The root mean square of Y_i π_b - τ_i over the samples, N m or N.
  double rms_residual(const Eigen::VectorXd& pi_b) const;
  double rms_torque() const;
};

// The equations of one instant.
struct EquationInstant {
  int log = 0;     // index into Observations::shapes
  long index = 0;  // FilteredEquations::index
  double time = 0;
  std::vector<double> q{}, qd{}, qdd{};  // filtered like the equations
  int first = 0;  // the first equation; those before it and behind the last one have no rows at this instant
  std::vector<double> entries{}, right{};  // of each equation its columns, one equation behind the other
  std::vector<double> measured_rates{};    // by equation, dτ/dt
  std::vector<double> fast{};              // by equation, FilteredEquations::fast; empty if there is none
  std::vector<std::uint8_t> used{};        // by equation
  std::vector<double> instruments{};       // like entries; empty if there are none
  int run = 1;                             // NoiseShape::run of its log
};

// Calls visit(equation, place, entries) for the equations of an instant: `place` is that among its own, `entries` the
// row of the equation's columns.
template <class Visit>
void for_equations(const EquationInstant& instant, const std::vector<JointObservations>& joints, const Visit& visit) {
  const double* entries = instant.entries.data();
  for (std::size_t place = 0; place < instant.used.size(); ++place) {
    const std::size_t equation = static_cast<std::size_t>(instant.first) + place;
    const auto count = static_cast<Eigen::Index>(joints[equation].columns.size());
    visit(equation, place, Eigen::Map<const Eigen::RowVectorXd>(entries, count));
    entries += count;
  }
}

struct Observations {
  int parameters = 0;  // b
  std::vector<JointObservations> joints;
  std::vector<EquationInstant> instants{};  // some of all, in the order of logs and times
  long stride = 1;                          // about one of so many runs of instants is kept: a power of two
  std::vector<NoiseShape> shapes{};         // by log

  void set_correlation(double correlation);  // sets it for all joints
};

// Keeps at most kMost instants, in runs of consecutive ones (NoiseShape::run) that are spread over all logs: where
// there are more, about every other run is dropped. Which are kept depends on their logs and indices alone, and not on
// the part that has them.
class InstantSample {
 public:
  static constexpr std::size_t kMost = 1024;

  void offer(const FilteredEquations& equations, const EquationModel& model, int log, const NoiseShape& shape);
  void move_to(Observations& observations);

 private:
  long stride_ = 1;
  std::vector<EquationInstant> kept_;
};

// Folds equations as they arrive, in 2 (columns)² operations per row.
class ObservationFolder {
 public:
  explicit ObservationFolder(const EquationModel& model);

  void add(const FilteredEquations& equations);
  // The observations, without instants.
  Observations observations();

 private:
  const EquationModel& model_;
  std::vector<TriangularFactor> factors_;
};

// Leaves out the rows of equations that are used at few of `used` filtered instants. Such a joint hardly moves: its
// rows lie next to rests, where friction is not sure, and are too few to estimate their noise.
void leave_out_short_motions(Observations& observations, long used);

// Joins observations of the same equations and the same logs.
Observations joined(const Observations& a, const Observations& b);

}  // namespace flatdyn
