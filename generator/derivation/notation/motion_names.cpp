// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/notation/motion_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "derivation/notation/latex.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {
namespace {

constexpr int kAxisCount = 3;
constexpr const char* kAxisNames[] = {"x", "y", "z"};

bool is_free_symbol(const Mechanism& mechanism, const std::string& name) {
  return std::any_of(mechanism.symbols.begin(), mechanism.symbols.end(),
                     [&](const FreeSymbol& symbol) { return symbol.name == name; });
}

// The letters, with the last one repeated until neither a name LETTERS_END nor dLETTERS_END is a free symbol.
std::string unused_letters(const Mechanism& mechanism, std::string letters, const std::vector<std::string>& ends) {
  const auto is_taken = [&](const std::string& end) {
    const std::string name = letters + "_" + end;
    return is_free_symbol(mechanism, name) || is_free_symbol(mechanism, "d" + name);
  };
  while (std::any_of(ends.begin(), ends.end(), is_taken)) letters += letters.back();
  return letters;
}

// The ends of names of vectors: "x", or "2x" with a joint's number.
std::vector<std::string> ends_of_vectors(const std::vector<std::string>& joints) {
  std::vector<std::string> ends;
  for (const std::string& joint : joints) {
    for (const char* const axis : kAxisNames) ends.push_back(joint + axis);
  }
  return ends;
}

// The numbers of the joints that are spherical, counted from 1.
std::vector<std::string> numbers_of_spherical_joints(const Mechanism& mechanism) {
  const std::vector<int> joints = joints_of_entries(mechanism);
  std::vector<std::string> numbers;
  for (const int first : mechanism.spherical) numbers.push_back(std::to_string(joints[at(first)] + 1));
  return numbers;
}

// The names of a vector's three entries: "v_x" or, with a joint's number, "omega_2x"; in LaTeX "v_{x}",
// "\omega_{2,x}", under a dot if it is a derivative.
std::vector<std::string> names_of_vector(const std::string& letters, const std::string& joint, bool is_derivative,
                                         Notation notation) {
  std::vector<std::string> names;
  for (const std::string axis : kAxisNames) {
    if (notation == Notation::text) {
      names.push_back((is_derivative ? "d" : "") + letters + "_" + joint + axis);
    } else {
      const std::string symbol = latex_name(letters);
      const std::string subscript = "_{" + joint + (joint.empty() ? "" : ",") + axis + "}";
      names.push_back((is_derivative ? "\\dot{" + symbol + "}" : symbol) + subscript);
    }
  }
  return names;
}

class NamesOfEntries {
 public:
  NamesOfEntries(const Mechanism& mechanism, const SumFormatter& formatter)
      : mechanism_(mechanism), formatter_(formatter) {}

  std::vector<EntryNames> all() {
    if (mechanism_.floating_base) {
      add("v", "f", "");
      add("omega", "n", "");
    }
    const std::vector<int> joints = joints_of_entries(mechanism_);
    for (int k = mechanism_.base_bodies(); k < mechanism_.size(); ++k) {
      const int part = mechanism_.joint(k).spherical, joint = joints[at(k)];
      if (part == 1) add("omega", "tau", std::to_string(joint + 1));
      if (part != 0) continue;
      names_.push_back({formatter_.coordinate("qd", joint), formatter_.coordinate("qdd", joint),
                        formatter_.coordinate("tau", joint)});
    }
    return std::move(names_);
  }

 private:
  // Adds the names of a vector of the base, or of the spherical joint of this number; letters are the same for all
  // spherical joints.
  void add(const std::string& velocity, const std::string& force, const std::string& joint) {
    const std::vector<std::string> ends =
        ends_of_vectors(joint.empty() ? std::vector<std::string>{""} : numbers_of_spherical_joints(mechanism_));
    const auto names = [&](const std::string& letters, bool is_derivative) {
      return names_of_vector(unused_letters(mechanism_, letters, ends), joint, is_derivative, formatter_.notation());
    };
    const std::vector<std::string> rates = names(velocity, false), accelerations = names(velocity, true),
                                   forces = names(force, false);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      names_.push_back({rates[axis], accelerations[axis], forces[axis]});
    }
  }

  const Mechanism& mechanism_;
  const SumFormatter& formatter_;
  std::vector<EntryNames> names_;
};

// "omega_x, omega_y, omega_z": one of the names of `count` entries.
std::string listed(const std::vector<EntryNames>& names, std::string EntryNames::*name, int first, int count) {
  std::vector<std::string> texts;
  for (int k = first; k < first + count; ++k) texts.push_back(names[at(k)].*name);
  return fmt::format("{}", fmt::join(texts, ", "));
}

// "1 v_x, 2 v_y, …" of all entries.
std::string with_indices(const std::vector<EntryNames>& names, std::string EntryNames::*name) {
  std::vector<std::string> texts;
  for (const EntryNames& entry : names) texts.push_back(std::to_string(texts.size() + 1) + " " + entry.*name);
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::vector<std::string> conventions_of_base(const Mechanism& mechanism, const std::vector<EntryNames>& names) {
  const int linear = 0, angular = kAxisCount;
  const auto list = [&](std::string EntryNames::*name, int first) { return listed(names, name, first, kAxisCount); };
  std::vector<std::string> lines = {
      "the base floats: " + mechanism.base_link().link,
      list(&EntryNames::velocity, linear) + ": velocity of the base frame's origin, in base axes, m/s",
      list(&EntryNames::velocity, angular) + ": angular velocity of the base, in base axes, rad/s",
      fmt::format("{}, {}: derivatives of these numbers, m/s^2 and rad/s^2; the origin's acceleration is "
                  "dv/dt + omega x v, in base axes",
                  list(&EntryNames::acceleration, linear), list(&EntryNames::acceleration, angular)),
      list(&EntryNames::torque, linear) + ": force on the base, in base axes, N",
      list(&EntryNames::torque, angular) + ": moment on the base about its frame's origin, in base axes, N m"};
  if (mechanism.has_base_gravity()) {
    lines.push_back(fmt::format("{}: gravity, in base axes, m/s^2", fmt::join(base_gravity_names(mechanism), ", ")));
  }
  return lines;
}

// The lines on spherical joints, in which k stands for a joint's number.
std::vector<std::string> conventions_of_spherical_joints(const Mechanism& mechanism) {
  const std::vector<std::string> numbers = numbers_of_spherical_joints(mechanism), ends = ends_of_vectors(numbers);
  const auto vector = [&](const std::string& letters, bool is_derivative) {
    const std::string unused = unused_letters(mechanism, letters, ends);
    return fmt::format("{}", fmt::join(names_of_vector(unused, "k", is_derivative, Notation::text), ", "));
  };
  std::vector<std::string> quaternion;
  for (const char* const letter : {"w", "x", "y", "z"}) {
    quaternion.push_back(unused_letters(mechanism, letter, numbers) + "_k");
  }
  return {
      fmt::format("{} of a spherical joint: quaternion that turns the child's axes into the parent's, both those of "
                  "the joint; its length is taken to be 1",
                  fmt::join(quaternion, ", ")),
      vector("omega", false) + ": angular velocity of the child relative to the parent, in the child's axes, rad/s",
      vector("omega", true) + ": derivatives of these numbers, rad/s^2",
      vector("tau", false) + ": moment on the child, in its axes, N m"};
}

bool has_joints_of_one_axis(const Mechanism& mechanism) {
  return mechanism.size() > mechanism.base_bodies() + kSphericalBodies * static_cast<int>(mechanism.spherical.size());
}

}  // namespace

std::vector<EntryNames> entry_names(const Mechanism& mechanism, const SumFormatter& formatter) {
  return NamesOfEntries(mechanism, formatter).all();
}

std::vector<std::string> base_gravity_names(const Mechanism& mechanism) {
  return names_of_vector(unused_letters(mechanism, "g", ends_of_vectors({""})), "", false, Notation::text);
}

std::vector<std::string> quaternion_names(const Mechanism& mechanism) {
  const std::vector<std::string> numbers = numbers_of_spherical_joints(mechanism);
  std::vector<std::string> names;
  for (const std::string& number : numbers) {
    for (const char* const letter : {"w", "x", "y", "z"}) {
      names.push_back(unused_letters(mechanism, letter, numbers) + "_" + number);
    }
  }
  return names;
}

std::vector<std::string> motion_conventions(const Mechanism& mechanism, const std::vector<EntryNames>& names) {
  std::vector<std::string> lines;
  const auto append = [&lines](const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  if (mechanism.floating_base) append(conventions_of_base(mechanism, names));
  if (mechanism.has_spherical_joints()) append(conventions_of_spherical_joints(mechanism));
  if (has_joints_of_one_axis(mechanism)) {
    lines.emplace_back(
        "q_k, qd_k, qdd_k, tau_k of another joint: position, its two derivatives, torque; rad and N m, or "
        "m and N if it is prismatic");
  }
  lines.push_back("velocities v by index: " + with_indices(names, &EntryNames::velocity));
  lines.push_back("forces tau by index: " + with_indices(names, &EntryNames::torque));
  return lines;
}

}  // namespace flatdyn
