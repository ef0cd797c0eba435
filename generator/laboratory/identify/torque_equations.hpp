// SPDX-License-Identifier: GPL-2.0-or-later
// The equations of the joint torques in π_b, and in parameters that come behind it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "laboratory/identify/equation_model.hpp"
#include "laboratory/identify/friction_law.hpp"
#include "laboratory/identify/gravity_columns.hpp"
#include "laboratory/identify/residual_noise.hpp"
#include "laboratory/identify/torque_model.hpp"

namespace flatdyn {

// Parameters in addition to π_b, which come behind it.
struct FurtherParameters {
  FrictionLaw law = FrictionLaw::coulomb;
  std::vector<double> speeds{};  // v by joint, rad/s or m/s, for laws that have it
  bool offsets = false;          // a constant in each joint's torques
  // By joint: columns exp(-(q̇/v)²) sgn q̇, or tanh(q̇/v), for many v, instead of the law; to find v by.
  std::vector<std::vector<double>> dictionary{};

  // Corrections of unknowns in which the torques are not linear, by columns of their derivatives.
  // By joint: what exp(-(q̇/v)²) or tanh(q̇/v) is multiplied by, N m or N; 0 where v counts as exact. Empty: all do.
  std::vector<double> speed_factors{};
  std::shared_ptr<const GravityColumns> gravity{};  // null: gravity counts as exact
  bool delay = false;                               // of the torques, s
  bool springs = false;  // the stiffness k of each joint's spring and k q_0; not with offsets, which say the same
  // For the law `load`: the parameters, by their names, from which τ_l is computed. Empty: the law's term is left out.
  std::map<std::string, double> carried{};
  // T_0, °C: F_v and F_s are those at this temperature, and change with the joint's by F_vT and F_sT for each kelvin.
  std::optional<double> temperature{};
  // By joint, without those of a floating base: temperatures that hardly change, which tell no F_vT and F_sT. Empty:
  // none is so.
  std::vector<bool> even_temperatures{};
};

// A column by which such an unknown is corrected.
struct Correction {
  enum class Kind : std::uint8_t { speed, gravity, delay };
  Kind kind = Kind::delay;
  int index = 0;  // the equation whose friction has the speed, or the turn of gravity
  int column = 0;
};

// Y_b(q, q̇, q̈) π_b + J_eᵀ h_e = τ, (7.81), with one equation per joint, after six of a floating base's force, which are
// used where the log has it. Behind π_b come F_vT and F_sT of each joint, then the law's further parameter of each
// joint that has friction (F_a, F_b or c), or the dictionary's, then the offsets, or k and k q_0 of each joint's
// spring, and then corrections: of v by joint (rad/s or m/s), of gravity's direction (GravityColumns), and of the delay
// (s).
class TorqueEquations : public EquationModel {
 public:
  explicit TorqueEquations(const TorqueModel& model, FurtherParameters further = {});

  const TorqueModel& model() const { return model_; }
  const FurtherParameters& further() const { return further_; }
  // The names of all parameters: "I1zz", …, "FvT1", …, "Fa1", …, "offset1", …, "k1", "kq1", …, "v1", …, "gravity1", …,
  // "delay"
  const std::vector<std::string>& names() const { return names_; }
  // The corrections, which are the last parameters, and their number.
  const std::vector<Correction>& corrected() const { return corrections_; }
  int corrections() const { return static_cast<int>(corrections_.size()); }
  // The number of parameters between those of friction and the corrections: of offsets or springs.
  int static_parameters() const;
  // The first parameter of the law, behind π_b and F_vT and F_sT.
  int first_of_law() const { return first_of_law_; }
  // The equations whose τ_l has the rotor in it, as neither it is a base parameter nor the file has it.
  std::vector<int> carried_rotors() const;
  // The file's π_b, its springs, and zeros elsewhere behind it.
  Eigen::VectorXd file_values() const;
  AccelerationRows acceleration_rows() const;
  // The name of a further parameter of an equation: joints are counted from 1, as in parameter_name().
  std::string name_of(const char* stem, int equation) const;

  // Asks for the entries of Y along the slow motion.
  void set_instruments() { has_instruments_ = true; }

  void evaluate(const MeasuredMotion& motion, double* entries, double* known) const override;
  int measured(const LogLayout& layout) const override { return layout.tau(); }
  bool is_measured(const LogLayout& layout, int equation) const override {
    return layout.has_base_force || equation >= layout.base;
  }

 private:
  // An entry of an equation.
  struct Term {
    enum class Kind : std::uint8_t { regressor, constant, friction, gravity, rate, position, relaxed };
    // Friction is multiplied by 1, |τ_l| or T - T_0.
    enum class Factor : std::uint8_t { one, load, temperature };
    int column = 0;
    Kind kind = Kind::regressor;
    FrictionEntry friction{};
    int slope = 0;  // of gravity
    Factor factor = Factor::one;
    double carried = 0;  // the parameter's value in τ_l; 0 for friction, rotors and what is no torque of the drive
  };

  void add_joint(int joint);
  void add_warmth(int joint);
  void add_law(int joint);
  void add_spring(int joint);
  void add_corrections();
  int add_correction(Correction::Kind kind, int index, std::string name);
  void add_friction(int joint, int column, FrictionEntry::Law law, double factor = 1);
  // Whether the joint's I_m is a base parameter of its own.
  bool has_rotor_parameter(int equation) const;
  void set_carried();
  double entry_of(const Term& term, int equation, const MeasuredMotion& motion) const;
  bool has_even_temperature(int equation) const;
  double factor_of(const Term& term, int equation, const MeasuredMotion& motion, double load) const;
  int add_name(std::string name);
  void place_terms();

  const TorqueModel& model_;
  FurtherParameters further_;
  std::vector<std::string> names_;
  std::vector<Correction> corrections_;
  std::vector<std::vector<Term>> terms_;  // by joint
  int first_of_law_ = 0;
  std::vector<double> rotors_;  // by equation, kg m² or kg: of the file, where it is no parameter of its own
  mutable std::vector<double> y_;
  mutable Eigen::MatrixXd of_gravity_;
};

}  // namespace flatdyn
