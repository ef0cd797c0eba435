// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/torque_equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flatdyn {

TorqueEquations::TorqueEquations(const TorqueModel& model, FurtherParameters further)
    : model_(model),
      further_(std::move(further)),
      terms_(static_cast<std::size_t>(model.equations())),
      y_(static_cast<std::size_t>(model.equations() * model.parameters())) {
  for (const int index : model.base().columns) names_.push_back(parameter_name(index, model.first_joint()));
  for (int i = 0; i < model.equations(); ++i) add_joint(i);
  for (int i = 0; i < model.equations() && further_.temperature; ++i) add_warmth(i);
  first_of_law_ = static_cast<int>(names_.size());
  for (int i = 0; i < model.equations(); ++i) add_law(i);
  for (int i = model.first_joint(); i < model.equations() && further_.offsets; ++i) {
    terms_[static_cast<std::size_t>(i)].push_back({add_name(name_of("offset", i)), Term::Kind::constant});
  }
  for (int i = model.first_joint(); i < model.equations() && further_.springs; ++i) add_spring(i);
  set_carried();
  add_corrections();
  parameters_ = static_cast<int>(names_.size());
  place_terms();
}

std::string TorqueEquations::name_of(const char* stem, int equation) const {
  return fmt::format("{}{}", stem, equation - model_.first_joint() + 1);
}

int TorqueEquations::add_name(std::string name) {
  names_.push_back(std::move(name));
  return static_cast<int>(names_.size()) - 1;
}

void TorqueEquations::add_friction(int joint, int column, FrictionEntry::Law law, double factor) {
  const double speed = further_.speeds.empty() ? 1 : further_.speeds[static_cast<std::size_t>(joint)];
  terms_[static_cast<std::size_t>(joint)].push_back({column, Term::Kind::friction, {0, joint, law, speed, factor}});
}

void TorqueEquations::add_joint(int joint) {
  // With loops or coupled joints, an equation also has the friction of joints whose speeds are functions of others.
  const bool is_open = !model_.mechanism().is_coupled();
  const bool is_smooth = further_.law == FrictionLaw::smooth && further_.dictionary.empty();
  has_friction_.push_back(false);
  for (const int column : model_.columns_of(joint)) {
    const Parameter parameter = parameter_of(model_.base().columns[static_cast<std::size_t>(column)]);
    const bool is_coulomb = parameter == Parameter::Fs, is_friction = is_coulomb || parameter == Parameter::Fv;
    has_friction_.back() = has_friction_.back() || is_friction;
    if (is_friction && is_open) {
      add_friction(joint, column,
                   !is_coulomb ? FrictionEntry::Law::viscous
                   : is_smooth ? FrictionEntry::Law::smooth
                               : FrictionEntry::Law::coulomb);
    } else {
      terms_[static_cast<std::size_t>(joint)].push_back({column});
    }
  }
}

bool TorqueEquations::has_even_temperature(int equation) const {
  const auto joint = static_cast<std::size_t>(equation - model_.first_joint());
  return equation >= model_.first_joint() && joint < further_.even_temperatures.size() &&
         further_.even_temperatures[joint];
}

// (T - T_0) times what F_v and F_s are multiplied by.
void TorqueEquations::add_warmth(int joint) {
  if (has_even_temperature(joint)) return;
  std::vector<Term>& terms = terms_[static_cast<std::size_t>(joint)];
  const std::size_t count = terms.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (terms[k].kind != Term::Kind::friction) continue;
    Term changed = terms[k];
    const bool is_viscous = changed.friction.law == FrictionEntry::Law::viscous;
    changed.column = add_name(name_of(is_viscous ? "FvT" : "FsT", joint));
    changed.factor = Term::Factor::temperature;
    terms.push_back(changed);
  }
}

// The law's further term, for a joint that has Coulomb friction.
void TorqueEquations::add_law(int joint) {
  const auto is_coulomb = [this](const Term& term) {
    return term.kind == Term::Kind::friction && term.friction.law != FrictionEntry::Law::viscous &&
           term.column < model_.parameters();
  };
  if (std::ranges::none_of(terms_[static_cast<std::size_t>(joint)], is_coulomb)) return;
  if (!further_.dictionary.empty()) {
    const auto law = further_.law == FrictionLaw::smooth ? FrictionEntry::Law::smooth : FrictionEntry::Law::stribeck;
    for (const double each : further_.dictionary[static_cast<std::size_t>(joint)]) {
      add_friction(joint, add_name(fmt::format("{}({})", name_of("F", joint), each)), law);
      terms_[static_cast<std::size_t>(joint)].back().friction.speed = each;
    }
  } else if (further_.law == FrictionLaw::asymmetric) {
    add_friction(joint, add_name(name_of("Fa", joint)), FrictionEntry::Law::asymmetry);
  } else if (further_.law == FrictionLaw::stribeck) {
    add_friction(joint, add_name(name_of("Fb", joint)), FrictionEntry::Law::stribeck);
  } else if (further_.law == FrictionLaw::load && !further_.carried.empty()) {
    add_friction(joint, add_name(name_of("c", joint)), FrictionEntry::Law::coulomb);
    terms_[static_cast<std::size_t>(joint)].back().factor = Term::Factor::load;
  }
}

bool TorqueEquations::has_rotor_parameter(int equation) const {
  return std::ranges::count(model_.base().columns, index_of(equation, Parameter::Im)) > 0;
}

void TorqueEquations::set_carried() {
  rotors_.assign(terms_.size(), 0);
  for (int i = model_.first_joint(); i < model_.equations() && further_.law == FrictionLaw::load; ++i) {
    if (!has_rotor_parameter(i)) rotors_[static_cast<std::size_t>(i)] = model_.file_rotor(i);
  }
  for (std::vector<Term>& terms : terms_) {
    for (Term& term : terms) {
      const auto place = static_cast<std::size_t>(term.column);
      const bool is_rotor =
          term.column < model_.parameters() && parameter_of(model_.base().columns[place]) == Parameter::Im;
      const auto found = further_.carried.find(names_[place]);
      const bool is_carried = term.kind != Term::Kind::friction && term.kind != Term::Kind::constant && !is_rotor;
      if (is_carried && found != further_.carried.end()) term.carried = found->second;
    }
  }
}

// k q - k q_0, linear in k and k q_0.
void TorqueEquations::add_spring(int joint) {
  std::vector<Term>& terms = terms_[static_cast<std::size_t>(joint)];
  terms.push_back({add_name(name_of("k", joint)), Term::Kind::position});
  terms.push_back({add_name(name_of("kq", joint)), Term::Kind::relaxed});
}

std::vector<int> TorqueEquations::carried_rotors() const {
  std::vector<int> result;
  for (int i = model_.first_joint(); i < model_.equations() && further_.law == FrictionLaw::load; ++i) {
    if (!has_rotor_parameter(i) && rotors_[static_cast<std::size_t>(i)] == 0) result.push_back(i);
  }
  return result;
}

int TorqueEquations::static_parameters() const {
  return further_.springs ? 2 * model_.joints() : further_.offsets ? model_.joints() : 0;
}

int TorqueEquations::add_correction(Correction::Kind kind, int index, std::string name) {
  corrections_.push_back({kind, index, add_name(std::move(name))});
  return corrections_.back().column;
}

void TorqueEquations::add_corrections() {
  const auto law =
      further_.law == FrictionLaw::smooth ? FrictionEntry::Law::smooth_slope : FrictionEntry::Law::stribeck_slope;
  for (int i = 0; i < static_cast<int>(further_.speed_factors.size()); ++i) {
    const double factor = further_.speed_factors[static_cast<std::size_t>(i)];
    if (factor != 0) add_friction(i, add_correction(Correction::Kind::speed, i, name_of("v", i)), law, factor);
  }
  for (int k = 0; further_.gravity && k < further_.gravity->size(); ++k) {
    const int column = add_correction(Correction::Kind::gravity, k, fmt::format("gravity{}", k + 1));
    for (std::vector<Term>& terms : terms_) terms.push_back({column, Term::Kind::gravity, {}, k});
  }
  if (!further_.delay) return;
  const int column = add_correction(Correction::Kind::delay, 0, "delay");
  for (std::vector<Term>& terms : terms_) terms.push_back({column, Term::Kind::rate});
}

// Columns and entries, from the terms.
void TorqueEquations::place_terms() {
  int entry = 0;
  for (const std::vector<Term>& terms : terms_) {
    columns_.emplace_back();
    for (const Term& term : terms) {
      columns_.back().push_back(term.column);
      if (term.kind == Term::Kind::friction) {
        friction_.push_back(term.friction);
        friction_.back().entry = entry;
      }
      if (term.kind == Term::Kind::rate) rate_entries_.push_back(entry);
      ++entry;
    }
  }
}

Eigen::VectorXd TorqueEquations::file_values() const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(parameters());
  std::copy(model_.file_values().begin(), model_.file_values().end(), values.begin());
  if (!further_.springs) return values;
  Eigen::Index next = parameters() - corrections() - static_parameters();
  for (const Body& body : model_.mechanism().joints()) {
    values(next++) = nearest_double(body.stiffness);
    values(next++) = nearest_double(body.stiffness * body.spring_reference);
  }
  return values;
}

AccelerationRows TorqueEquations::acceleration_rows() const {
  return [this](const EquationInstant& instant) {
    std::vector<Eigen::MatrixXd> rows = model_.acceleration_rows(instant.q.data());
    const int more = parameters() - model_.parameters();
    if (more == 0) return rows;
    for (Eigen::MatrixXd& each : rows) {
      each.conservativeResize(Eigen::NoChange, parameters());
      each.rightCols(more).setZero();
    }
    return rows;
  };
}

double TorqueEquations::entry_of(const Term& term, int equation, const MeasuredMotion& motion) const {
  switch (term.kind) {
    case Term::Kind::regressor:
      return y_[static_cast<std::size_t>(equation * model_.parameters() + term.column)];
    case Term::Kind::gravity:
      return of_gravity_(equation, term.slope);
    case Term::Kind::position:
      return motion.q[model_.mechanism().position_of(equation)];
    case Term::Kind::relaxed:
      return -1;
    case Term::Kind::constant:
    case Term::Kind::friction:
    case Term::Kind::rate:
      break;
  }
  return 1;
}

double TorqueEquations::factor_of(const Term& term, int equation, const MeasuredMotion& motion, double load) const {
  if (term.factor == Term::Factor::load) return std::abs(load);
  if (term.factor == Term::Factor::one || motion.temperatures == nullptr) return 1;
  return motion.temperatures[equation - model_.first_joint()] - *further_.temperature;
}

void TorqueEquations::evaluate(const MeasuredMotion& motion, double* entries, double* known) const {
  model_.regressor(motion.q, motion.qd, motion.qdd, y_.data());
  const int positions = model_.mechanism().position_count();
  if (further_.gravity) of_gravity_ = further_.gravity->at(Eigen::Map<const Eigen::VectorXd>(motion.q, positions));
  if (motion.h_e != nullptr) {
    model_.tip_torque(motion.q, motion.h_e, known);
  } else {
    std::fill(known, known + model_.equations(), 0.0);
  }
  if (!further_.springs) model_.add_springs(motion.q, known);
  for (int i = 0; i < model_.equations(); ++i) {
    double load = known[i] - rotors_[static_cast<std::size_t>(i)] * motion.qdd[i];
    double* const first = entries;
    const std::vector<Term>& terms = terms_[static_cast<std::size_t>(i)];
    for (const Term& term : terms) {
      *entries = entry_of(term, i, motion);
      load += term.carried * *entries++;
    }
    for (std::size_t k = 0; k < terms.size(); ++k) first[k] *= factor_of(terms[k], i, motion, load);
  }
}

}  // namespace flatdyn
