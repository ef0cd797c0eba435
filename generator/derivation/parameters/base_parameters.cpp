// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/base_parameters.hpp"

#include <algorithm>

#include "derivation/kernel/elimination.hpp"
#include "derivation/parameters/coupled_base.hpp"
#include "derivation/parameters/loop_shifts.hpp"
#include "derivation/parameters/redundant.hpp"
#include "graph/mod_p.hpp"
#include "robot/model/field_mechanism.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

void add_multiple(ParameterForm& form, const Number& factor, const ParameterForm& other) {
  for (const auto& [index, coefficient] : other) {
    const Number sum = simplified<Number>(form[index] + factor * coefficient);
    if (vanishes(sum)) {
      form.erase(index);
    } else {
      form[index] = sum;
    }
  }
}

// The ten parameters of a body in a redundant part.
InertialParameters inertia_of(const RedundantPart& part) {
  InertialParameters body;
  for (int k = 0; k < kInertialPerBody; ++k) {
    body = body + single_parameter(static_cast<Parameter>(k), part.entries[static_cast<std::size_t>(k)]);
  }
  return body;
}

// The parameters of all joints as linear forms in the original ones, while parts of them are moved towards the base.
class Regrouping {
 public:
  explicit Regrouping(const Mechanism& mechanism) : mechanism_(mechanism) {
    for (int k = 0; k < kParametersPerJoint * mechanism.body_count(); ++k) forms_.push_back({{k, 1}});
    const auto parts = redundant_parts(mechanism);
    for (int j = mechanism.body_count() - 1; j >= 0; --j) {
      for (const RedundantPart& part : parts[static_cast<std::size_t>(j)]) move(j, part);
    }
  }

  const std::vector<ParameterForm>& forms() const { return forms_; }

 private:
  ParameterForm& form(int j, std::size_t parameter) {
    return forms_[static_cast<std::size_t>(kParametersPerJoint * j) + parameter];
  }

  // Subtracts the part from joint j, so that its lead vanishes, and adds its body to the joint's parent.
  void move(int j, const RedundantPart& part) {
    const auto lead = static_cast<std::size_t>(part.lead);
    const ParameterForm amount = form(j, lead);
    if (amount.empty()) return;
    for (std::size_t k = 0; k < part.entries.size(); ++k) {
      if (!vanishes(part.entries[k])) add_multiple(form(j, k), -part.entries[k], amount);
    }
    const int first = first_body_of_joint(mechanism_, j);
    const int parent = mechanism_.bodies[static_cast<std::size_t>(first)].parent;
    if (parent < 0) return;
    InertialParameters at_parent = inertia_of(part);
    for (int i = j; i >= first; --i) {
      const Body& body = mechanism_.bodies[static_cast<std::size_t>(i)];
      at_parent = transformed(at_parent, constant_rotation(body), body.p);
    }
    const std::vector<Number> moved = entries_of(at_parent);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      if (!vanishes(moved[k])) add_multiple(form(parent, k), moved[k], amount);
    }
  }

  const Mechanism& mechanism_;
  std::vector<ParameterForm> forms_;
};

// The indices in π in the order in which they are kept.
std::vector<int> by_preference(const Mechanism& mechanism) {
  std::vector<int> order;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    for (const Parameter p : kPreference) order.push_back(index_of(i, p));
  }
  return order;
}

Number coefficient(const ParameterForm& form, int index) {
  const auto found = form.find(index);
  return found == form.end() ? Number(0) : found->second;
}

// The reduced echelon form of the rows of K, without the parameters that are not `present`.
template <class IsZero>
BaseParameters reduced(std::vector<ParameterForm> rows, const std::vector<int>& order, const std::vector<bool>& present,
                       IsZero is_zero) {
  for (ParameterForm& row : rows) {
    std::erase_if(row, [&](const auto& term) { return !present[static_cast<std::size_t>(term.first)]; });
  }
  std::map<int, ParameterForm> kept;
  for (const int index : order) {
    const auto pivot = std::find_if(rows.begin(), rows.end(),
                                    [&](const ParameterForm& row) { return !is_zero(coefficient(row, index)); });
    if (pivot == rows.end()) continue;
    ParameterForm chosen = *pivot;
    rows.erase(pivot);
    const Number lead = chosen.at(index);
    for (auto& [place, entry] : chosen) entry = simplified<Number>(entry / lead);
    const auto clear = [&](ParameterForm& row) {
      const Number factor = coefficient(row, index);
      if (!is_zero(factor)) add_multiple(row, -factor, chosen);
      row.erase(index);
    };
    for (ParameterForm& row : rows) clear(row);
    for (auto& [place, row] : kept) clear(row);
    kept[index] = std::move(chosen);
  }
  BaseParameters base;
  for (auto& [index, row] : kept) {
    base.columns.push_back(index);
    base.combination.push_back(std::move(row));
  }
  return base;
}

}  // namespace

BaseParameters base_parameters(const Mechanism& mechanism, ParameterSet set) {
  std::vector<ParameterForm> rows = Regrouping(mechanism).forms();
  std::erase_if(rows, [](const ParameterForm& form) { return form.empty(); });
  ModPArithmetic<> arithmetic(1);
  const NumberMap<ModPArithmetic<>> field(mechanism.symbols, arithmetic);
  const auto is_zero = [&field](const Number& x) { return field(x) == ModP<kMersenne61>(0); };
  const std::vector<bool> present = parameters_in(mechanism, set);
  const BaseParameters base = reduced(rows, by_preference(mechanism), present, is_zero);
  if (!mechanism.is_coupled()) return base;
  return reduced_at_coordinates(mechanism, without_shifts(mechanism, base, rows, present, is_zero));
}

std::vector<Number> base_values(const Mechanism& mechanism, const BaseParameters& base) {
  const std::vector<Number> pi = dynamic_parameters(mechanism);
  std::vector<Number> values;
  for (const ParameterForm& form : base.combination) {
    Number sum = 0;
    for (const auto& [index, coefficient] : form) sum += coefficient * pi[static_cast<std::size_t>(index)];
    values.push_back(sum.expand());
  }
  return values;
}

Mechanism with_base_parameters(const Mechanism& mechanism, const BaseParameters& base,
                               const std::vector<Number>& values) {
  Mechanism result = mechanism;
  for (Body& body : result.bodies) {
    body.inertia = {};
    body.armature = body.viscous = body.coulomb = body.stiffness = 0;
    if (body.rotor) body.rotor->inertia = 0;
  }
  for (std::size_t k = 0; k < base.columns.size(); ++k) {
    Body& body = result.bodies[static_cast<std::size_t>(joint_of(base.columns[k]))];
    const Parameter parameter = parameter_of(base.columns[k]);
    if (parameter == Parameter::Im) {
      (body.rotor ? body.rotor->inertia : body.armature) = values[k];
    } else if (parameter == Parameter::Fv) {
      body.viscous = values[k];
    } else if (parameter == Parameter::Fs) {
      body.coulomb = values[k];
    } else {
      body.inertia = body.inertia + single_parameter(parameter, values[k]);
    }
  }
  return result;
}

}  // namespace flatdyn
