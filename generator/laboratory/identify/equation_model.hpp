// SPDX-License-Identifier: GPL-2.0-or-later
// Equations that are linear in parameters: Y(q, q̇, q̈) π + known(q, h_e) = measured, such as those of the joint torques.
#pragma once

#include <cstdint>
#include <vector>

#include "laboratory/identify/log_layout.hpp"

namespace flatdyn {

// A motion in SI units, valid during a call: q of all joints, q̇ and q̈ of the independent ones, after (0, ω) and (f, ω̇)
// of a floating base (base_motion.hpp); h_e has 6 numbers, null if the log has none; temperatures in °C, one for each
// entry of q̇ behind a floating base's, null if they are not used.
struct MeasuredMotion {
  double time = 0;
  const double *q = nullptr, *qd = nullptr, *qdd = nullptr, *h_e = nullptr, *temperatures = nullptr;
};

// An entry of Y that is a function of a joint's speed, times one that changes slowly, such as the load of its drive.
struct FrictionEntry {
  enum class Law : std::uint8_t {
    viscous,         // q̇, times F_v
    coulomb,         // sgn q̇, times F_s
    asymmetry,       // |sgn q̇|, times half the difference of Coulomb friction in the two directions
    stribeck,        // exp(-(q̇/v)²) sgn q̇, times what friction near rest has more than F_s
    smooth,          // tanh(q̇/v), times F_s
    stribeck_slope,  // the derivative of stribeck by v
    smooth_slope     // the derivative of smooth by v
  };

  int entry = 0;  // index among the entries of Y
  int joint = 0;
  Law law = Law::viscous;
  double speed = 1;   // v, rad/s or m/s
  double factor = 1;  // of the whole entry

  double value(double rate) const;
};

class EquationModel {
 public:
  virtual ~EquationModel() = default;

  // The columns of each equation that are not zero for every motion, ascending. The entries of Y are those columns, one
  // equation behind the other.
  const std::vector<std::vector<int>>& columns() const { return columns_; }
  // Friction that `evaluate` leaves to the caller: equation i has that of joint i alone.
  const std::vector<FrictionEntry>& friction() const { return friction_; }
  // The entry of each equation that is -d/dt of what is measured, which `evaluate` leaves to the caller; empty if there
  // are none.
  const std::vector<int>& rate_entries() const { return rate_entries_; }
  // Whether equation i has friction of joint i, which may be anything up to F_s while the joint rests.
  bool has_friction(int equation) const { return has_friction_[static_cast<std::size_t>(equation)]; }
  int parameters() const { return parameters_; }
  int equations() const { return static_cast<int>(columns_.size()); }
  int entries() const {
    std::size_t count = 0;
    for (const std::vector<int>& each : columns_) count += each.size();
    return static_cast<int>(count);
  }

  // Writes the entries of Y and what is known of each equation. Entries of friction() are what the caller multiplies by
  // FrictionEntry::value, mostly 1; rate_entries() are left to the caller.
  virtual void evaluate(const MeasuredMotion& motion, double* entries, double* known) const = 0;
  // Whether the entries of Y along the slow motion, FilteredEquations::instruments, are wanted.
  bool has_instruments() const { return has_instruments_; }
  // Reports an error if a log lacks what is measured.
  virtual void require(const LogLayout& /*layout*/, const Place& /*place*/, Diagnostics& /*diagnostics*/) const {}
  // The channel of a log where what is measured begins; there is one channel per equation.
  virtual int measured(const LogLayout& layout) const = 0;
  // Whether the log has what is measured of an equation: its channel is empty otherwise.
  virtual bool is_measured(const LogLayout& /*layout*/, int /*equation*/) const { return true; }

 protected:
  std::vector<std::vector<int>> columns_;
  std::vector<FrictionEntry> friction_;
  std::vector<int> rate_entries_;
  std::vector<bool> has_friction_;
  int parameters_ = 0;
  bool has_instruments_ = false;
};

}  // namespace flatdyn
