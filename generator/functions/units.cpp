// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "derivation/parameters/base_parameters.hpp"
#include "derivation/parameters/parameters.hpp"

namespace flatdyn {
namespace {

// Exponents of the base units; angles have none.
struct Unit {
  int kg = 0, m = 0, s = 0;

  friend Unit operator*(const Unit& a, const Unit& b) { return {a.kg + b.kg, a.m + b.m, a.s + b.s}; }
  friend Unit operator/(const Unit& a, const Unit& b) { return {a.kg - b.kg, a.m - b.m, a.s - b.s}; }
  friend bool operator==(const Unit& a, const Unit& b) = default;
};

constexpr Unit kOne{}, kMetre{0, 1, 0}, kSecond{0, 0, 1}, kInertia{1, 2, 0}, kEnergy{1, 2, -2};
constexpr Unit kPerSecond = {0, 0, -1}, kPerSquareSecond = {0, 0, -2};

struct NamedUnit {
  Unit unit;
  const char* name;
};
constexpr NamedUnit kNamed[] = {{kEnergy, "N m"},      {{1, 1, -2}, "N"},   {{1, 0, -2}, "N/m"},
                                {{1, 2, -1}, "N m s"}, {{1, 1, -1}, "N s"}, {{1, 0, -1}, "N s/m"},
                                {{0, 1, -2}, "m/s^2"}, {{0, 1, -1}, "m/s"}, {kPerSquareSecond, "1/s^2"},
                                {kPerSecond, "1/s"},   {kOne, "1"},         {{0, -1, 0}, "1/m"}};

void add_factor(const char* base, int exponent, std::string& text) {
  if (exponent == 0) return;
  if (!text.empty()) text += " ";
  text += exponent == 1 ? base : fmt::format("{}^{}", base, exponent);
}

std::string text_of(const Unit& unit) {
  for (const NamedUnit& named : kNamed) {
    if (named.unit == unit) return named.name;
  }
  std::string text;
  add_factor("kg", unit.kg, text);
  add_factor("m", unit.m, text);
  add_factor("s", unit.s, text);
  return text;
}

// Quantities that are angles, or their derivatives by time, of revolute joints.
std::string text_of_motion(const Unit& unit) {
  if (unit == kOne) return "rad";
  if (unit == kPerSecond) return "rad/s";
  return unit == kPerSquareSecond ? "rad/s^2" : text_of(unit);
}

// The units of the entries of one output.
class OutputUnits {
 public:
  OutputUnits(const Mechanism& mechanism, const Function& function, const Output& output)
      : mechanism_(mechanism), function_(function), output_(output) {}

  std::string at(std::size_t entry) const {
    const std::size_t cols = output_.layout == Layout::vector ? 1 : static_cast<std::size_t>(output_.cols);
    const std::size_t row = entry / cols, col = entry % cols;
    switch (output_.quantity) {
      case OutputQuantity::none:
        return "";
      case OutputQuantity::derivative:
        return "derivative";
      case OutputQuantity::energy:
        return "J";
      case OutputQuantity::parameter:
        return "SI";
      case OutputQuantity::torque_per_parameter:
        return text_of(torque(row)) + " per parameter";
      case OutputQuantity::joint_position:
        return text_of_motion(position_entry(row));
      case OutputQuantity::joint_rate:
        return text_of_motion(joint_of_row(row) * kPerSecond);
      case OutputQuantity::joint_acceleration:
        return text_of_motion(joint_of_row(row) * kPerSquareSecond);
      case OutputQuantity::frame_velocity:
        return text_of_motion(direction(static_cast<int>(row)) * kPerSecond);
      case OutputQuantity::frame_acceleration:
      case OutputQuantity::tip_acceleration:
        return text_of_motion(direction(static_cast<int>(row)) * kPerSquareSecond);
      case OutputQuantity::contact_acceleration:
        return text_of_motion(contact_direction(row) * kPerSquareSecond);
      default:
        return text_of(unit(row, col));
    }
  }

 private:
  Unit unit(std::size_t row, std::size_t col) const {
    switch (output_.quantity) {
      case OutputQuantity::position:
        return kMetre;
      case OutputQuantity::joint_torque:
      case OutputQuantity::joint_momentum_rate:
        return torque(row);
      case OutputQuantity::joint_momentum:
        return torque(row) * kSecond;
      case OutputQuantity::joint_inertia:
        return kInertia / (joint(row) * joint(col));
      case OutputQuantity::christoffel_symbol:
        return christoffel(row, col);
      case OutputQuantity::torque_per_position:
        return torque(row) / joint(col);
      case OutputQuantity::torque_per_rate:
        return torque(row) * kSecond / joint(col);
      case OutputQuantity::acceleration_per_position:
        return joint(row) * kPerSquareSecond / joint(col);
      case OutputQuantity::acceleration_per_rate:
        return joint(row) * kPerSecond / joint(col);
      case OutputQuantity::acceleration_per_torque:
        return joint(row) * kPerSquareSecond / torque(col);
      case OutputQuantity::tip_jacobian:
        return direction(static_cast<int>(row)) / joint(col);
      case OutputQuantity::momentum_per_rate:
        return kInertia / (direction(static_cast<int>(row)) * joint(col));
      case OutputQuantity::force_and_moment:
        return kEnergy / direction(static_cast<int>(row));
      case OutputQuantity::task_inertia:
        return kInertia / (task_direction(row) * task_direction(col));
      case OutputQuantity::task_force:
        return kEnergy / task_direction(row);
      case OutputQuantity::joint_rate_per_task:
        return joint(row) / task_direction(col);
      case OutputQuantity::contact_jacobian:
        return contact_direction(row) / joint(col);
      case OutputQuantity::contact_force:
        return kEnergy / contact_direction(row);
      case OutputQuantity::contact_impulse:
        return kEnergy * kSecond / contact_direction(row);
      case OutputQuantity::loop_gap:
        return loop_equation(row);
      case OutputQuantity::loop_gap_per_position:
        return loop_equation(row) / position_entry(col);
      default:
        return kOne;
    }
  }

  // The unit of a coordinate: an angle's, or a metre.
  Unit joint(std::size_t i) const { return mechanism_.joint(static_cast<int>(i)).prismatic ? kMetre : kOne; }
  Unit torque(std::size_t i) const { return kEnergy / joint(i); }
  // The unit of an entry of q: with closed loops, those of dependent joints, too.
  Unit position_entry(std::size_t k) const {
    return mechanism_.joint_at(static_cast<int>(k)).prismatic ? kMetre : kOne;
  }
  // The coordinates of most functions, and all entries of q of those of loops.
  Unit joint_of_row(std::size_t i) const { return output_.rows == mechanism_.size() ? joint(i) : position_entry(i); }
  static Unit direction(int row) { return row < 3 ? kMetre : kOne; }
  // The unit of a row of the contacts' Jacobian times rad: of a velocity times s, or of a rotation.
  Unit contact_direction(std::size_t i) const {
    int row = static_cast<int>(i);
    for (const Contact& contact : mechanism_.contacts) {
      if (row < contact.rows()) return direction(row);
      row -= contact.rows();
    }
    return kOne;
  }
  Unit task_direction(std::size_t i) const { return direction(function_.task.rows[i]); }

  // Entry k (k + 1) / 2 + j of row i is c_ijk.
  Unit christoffel(std::size_t i, std::size_t column) const {
    std::size_t k = 0;
    while ((k + 1) * (k + 2) / 2 <= column) ++k;
    return kInertia / (joint(i) * joint(column - k * (k + 1) / 2) * joint(k));
  }

  Unit loop_equation(std::size_t equation) const {
    for (const LoopClosure& loop : mechanism_.loops) {
      if (equation < loop.rows.size()) return loop.rows[equation] < LoopClosure::kOfPoints ? kMetre : kOne;
      equation -= loop.rows.size();
    }
    return kOne;
  }

  const Mechanism& mechanism_;
  const Function& function_;
  const Output& output_;
};

// Whether the joint's position is a length. That of a tendon is one unless it runs over joints that turn only.
bool is_length(const Mechanism& mechanism, int body) {
  const auto at = static_cast<std::size_t>(body);
  if (!mechanism.bodies[at].is_tendon) return mechanism.bodies[at].prismatic;
  for (int k = 0; k < mechanism.position_count(); ++k) {
    if (!vanishes(mechanism.coupling[at][static_cast<std::size_t>(k)]) && mechanism.joint_at(k).prismatic) return true;
  }
  return false;
}

}  // namespace

std::string unit_of(const Mechanism& mechanism, const Function& function, const Output& output, std::size_t entry) {
  return OutputUnits(mechanism, function, output).at(entry);
}

std::string unit_of_parameter(const Mechanism& mechanism, int index) {
  const Body& body = mechanism.bodies[static_cast<std::size_t>(joint_of(index))];
  const bool slides = is_length(mechanism, joint_of(index));
  const Unit joint = slides ? kMetre : kOne;
  switch (parameter_of(index)) {
    case Parameter::m:
      return "kg";
    case Parameter::mlx:
    case Parameter::mly:
    case Parameter::mlz:
      return "kg m";
    case Parameter::Im:
      return body.rotor || !slides ? "kg m^2" : "kg";
    case Parameter::Fv:
      return text_of(kEnergy * kSecond / (joint * joint));
    case Parameter::Fs:
      return text_of(kEnergy / joint);
    default:
      return "kg m^2";
  }
}

std::vector<std::string> units_of_base_parameters(const Mechanism& mechanism) {
  std::vector<std::string> units;
  for (const int index : base_parameters(mechanism).columns) units.push_back(unit_of_parameter(mechanism, index));
  return units;
}

std::string units_of(const Mechanism& mechanism, const Function& function) {
  std::vector<std::string> units;
  for (const Output& output : function.outputs) {
    const OutputUnits all(mechanism, function, output);
    for (std::size_t entry = 0; entry < output.entries.size(); ++entry) {
      std::string unit = all.at(entry);
      if (std::find(units.begin(), units.end(), unit) == units.end()) units.push_back(std::move(unit));
    }
  }
  return fmt::format("{}", fmt::join(units, ", "));
}

}  // namespace flatdyn
