// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/parameters/file_parameters.hpp"

#include <algorithm>

#include "derivation/kernel/elimination.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {
namespace {

std::string name_of(Parameter kind, const std::string& owner) {
  static const char* const kNames[] = {"m",   "mlx", "mly", "mlz", "Ixx", "Ixy", "Ixz",
                                       "Iyy", "Iyz", "Izz", "Im",  "Fv",  "Fs"};
  return kNames[static_cast<std::size_t>(kind)] + ("(" + owner + ")");
}

void add_link(const WrittenLink& link, ParameterSet set, std::vector<FileParameter>& parameters) {
  const std::vector<Number> values = entries_of(link.inertia);
  for (int k = 0; k < kInertialPerBody; ++k) {
    const auto kind = static_cast<Parameter>(k);
    if (set == ParameterSet::nonzero && vanishes(values[static_cast<std::size_t>(k)])) continue;
    FileParameter parameter{
        index_of(link.body, kind), name_of(kind, link.link), values[static_cast<std::size_t>(k)], {}};
    const std::vector<Number> moved = entries_of(transformed(single_parameter(kind), link.R, link.p));
    for (int j = 0; j < kInertialPerBody; ++j) {
      const Number& entry = moved[static_cast<std::size_t>(j)];
      if (!vanishes(entry)) parameter.in_canonical[index_of(link.body, static_cast<Parameter>(j))] = entry;
    }
    parameters.push_back(std::move(parameter));
  }
}

bool is_canonical(const LinkFrame& frame) {
  const Mat3 identity = identity_matrix();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!vanishes(frame.p[i])) return false;
    for (std::size_t j = 0; j < 3; ++j) {
      if (!vanishes(frame.R[i][j] - identity[i][j])) return false;
    }
  }
  return true;
}

// The sum of numbers, or 0 if it is the residue of those that cancel.
class Sum {
 public:
  void add(const Number& term) {
    sum_ += term;
    if (is_rational(term)) size_ += GiNaC::abs(term);
  }
  Number value() const { return snap_residue_to_zero(simplified<Number>(sum_), size_.is_zero() ? Number(1) : size_); }

 private:
  Number sum_ = 0, size_ = 0;
};

}  // namespace

std::vector<const WrittenLink*> links_of(const Mechanism& mechanism, int i) {
  const Body& body = mechanism.bodies[static_cast<std::size_t>(i)];
  const std::string& moved = body.link;
  std::vector<const WrittenLink*> links;
  if (body.is_tendon) return links;
  for (const WrittenLink& link : mechanism.links) {
    if (link.body != i) continue;
    if (link.link == moved) {
      links.insert(links.begin(), &link);
    } else if (!link.inertia.is_zero()) {
      links.push_back(&link);
    }
  }
  return links;
}

std::vector<FileParameter> file_parameters(const Mechanism& mechanism, ParameterSet set) {
  const std::vector<Number> pi = dynamic_parameters(mechanism);
  const std::vector<bool> in_set = parameters_in(mechanism, set);
  std::vector<FileParameter> parameters;
  for (int i = 0; i < mechanism.body_count(); ++i) {
    for (const WrittenLink* link : links_of(mechanism, i)) add_link(*link, set, parameters);
    const std::string& joint = mechanism.bodies[static_cast<std::size_t>(i)].joint;
    for (const Parameter kind : {Parameter::Im, Parameter::Fv, Parameter::Fs}) {
      const auto index = static_cast<std::size_t>(index_of(i, kind));
      if (in_set[index])
        parameters.push_back({index_of(i, kind), name_of(kind, joint), pi[index], {{index_of(i, kind), 1}}});
    }
  }
  if (has_canonical_links(mechanism)) {
    for (FileParameter& parameter : parameters)
      parameter.name = parameter_name(parameter.index, mechanism.base_bodies());
  }
  return parameters;
}

bool has_canonical_links(const Mechanism& mechanism) {
  for (int i = std::max(0, mechanism.base_bodies() - 1); i < mechanism.body_count(); ++i) {
    if (mechanism.bodies[static_cast<std::size_t>(i)].is_tendon) continue;
    const std::vector<const WrittenLink*> links = links_of(mechanism, i);
    if (links.size() != 1 || !is_canonical(*links.front())) return false;
  }
  return true;
}

bool has_names_of_file(const Mechanism& mechanism, ParameterFrames frames) {
  return frames == ParameterFrames::file && !has_canonical_links(mechanism);
}

ParameterForm in_file_parameters(const ParameterForm& form, const std::vector<FileParameter>& parameters) {
  ParameterForm result;
  for (int f = 0; f < static_cast<int>(parameters.size()); ++f) {
    Sum sum;
    for (const auto& [index, entry] : parameters[static_cast<std::size_t>(f)].in_canonical) {
      const auto found = form.find(index);
      if (found != form.end()) sum.add(found->second * entry);
    }
    const Number coefficient = sum.value();
    if (!vanishes(coefficient)) result[f] = coefficient;
  }
  return result;
}

}  // namespace flatdyn
