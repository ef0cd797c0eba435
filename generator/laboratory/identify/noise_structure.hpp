// SPDX-License-Identifier: GPL-2.0-or-later
// The kinds of noise that measured torques may have, and how each correlates the rows of one equation: white noise and
// slower noise, behind the filter (NoiseShape); and either of both repeated with the motion (Repetition), as what the
// model lacks is.
#pragma once

#include <functional>
#include <optional>

#include "laboratory/identify/repetition.hpp"

namespace flatdyn {

// The correlation of noise of variance 1.
struct NoiseKind {
  std::vector<Eigen::VectorXd> by_log;  // at lags 0, 1, … of rows
  bool is_repeated = false;             // the same at each repetition; else nothing is common to two repetitions
};

class NoiseStructure {
 public:
  explicit NoiseStructure(const Observations& observations);

  const Observations& observations() const { return observations_; }
  // White noise, then NoiseShape::kColours; the same repeated follow where a motion is logged more than once.
  const std::vector<NoiseKind>& kinds() const { return kinds_; }
  const std::vector<RepeatedMotion>& motions() const { return repetition_.motions; }
  bool has_repetition() const { return repetition_.any(); }
  // By equation: rows of all instants per row of those that are kept.
  const Eigen::VectorXd& row_ratios() const { return row_ratios_; }

  bool uses(Eigen::Index instant, Eigen::Index equation) const;
  // The rows of an equation at all instants, zero where it is not used: instants × columns.
  Eigen::MatrixXd rows_of(Eigen::Index equation) const;
  // C rows for the correlation C of a kind: instants × columns.
  Eigen::MatrixXd correlated(const Eigen::MatrixXd& rows, Eigen::Index equation, const NoiseKind& kind) const;
  // The same of noise that is not repeated, with this autocorrelation.
  Eigen::MatrixXd correlated(const Eigen::MatrixXd& rows, const std::vector<Eigen::VectorXd>& by_log) const;

  // Calls visit(a, b) for pairs of instants, b `lag` rows behind a: in a row, or in the next repetitions of the motion.
  using Visit = std::function<void(Eigen::Index a, Eigen::Index b)>;
  void for_pairs(long lag, const Visit& visit) const;
  void for_repeated_pairs(long lag, const Visit& visit) const;

 private:
  Eigen::MatrixXd repeated(const Eigen::MatrixXd& rows, Eigen::Index equation,
                           const std::vector<Eigen::VectorXd>& by_log) const;

  // The instants of a phase, to a row.
  struct Phase {
    std::size_t motion = 0;
    int log = 0;
    std::vector<std::size_t> instants{};
    Eigen::Index row = 0;  // among those that have instants
  };
  void add_phases(std::size_t motion);
  // The phase `lag` rows behind one; nullopt where the motion ends before.
  std::optional<std::size_t> phase_behind(std::size_t phase, long lag) const;

  const Observations& observations_;
  Repetition repetition_;
  std::vector<NoiseKind> kinds_;
  Eigen::VectorXd row_ratios_;
  std::vector<Phase> phases_;
  Eigen::Index occupied_ = 0;                           // phases that have instants
  std::vector<std::size_t> first_phase_, phase_count_;  // by motion
  std::vector<std::size_t> phase_of_;                   // by instant
};

}  // namespace flatdyn
