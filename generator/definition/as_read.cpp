// SPDX-License-Identifier: GPL-2.0-or-later
#include "definition/as_read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "definition/as_read_numbers.hpp"
#include "definition/degree.hpp"
#include "definition/lagrangian.hpp"
#include "definition/written_energies.hpp"
#include "graph/mod_p.hpp"
#include "model/joint_points.hpp"

namespace flatdyn {
namespace {

Mechanism open_tree(Mechanism mechanism) {
  mechanism.loops.clear();
  mechanism.independent.clear();
  return mechanism;
}

// Whether the energies as written are those of the Lagrangian at a point of GF(P).
template <std::uint64_t P>
bool has_same_energies(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed) {
  using F = ModP<P>;
  ModPArithmetic<P> arithmetic(seed);
  std::vector<F> qd;
  for (int k = 0; k < mechanism.size(); ++k) qd.push_back(arithmetic.input({InputKind::qd, k}));
  Lagrangian<F> lagrangian(mechanism_over(mechanism, arithmetic), joint_points(mechanism, arithmetic));
  const std::vector<JointPoint<F>> q = joint_points(mechanism, arithmetic);
  const std::vector<F> rates = joint_values(lagrangian.mechanism(), qd);
  const Energies<F> written =
      WrittenEnergies<ModPArithmetic<P>>(robot, lagrangian.mechanism(), arithmetic, q, rates).sum();
  return written.kinetic == lagrangian.kinetic_energy(qd) && written.potential == lagrangian.potential_energy();
}

void compare_energies(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed, AsReadResult& result) {
  constexpr double kLog2Prime = 60.99;  // all primes are above 2^60.99
  constexpr int kEnergies = 2;
  const Mechanism open = open_tree(mechanism);
  result.is_exact = has_same_energies<kMersenne61>(robot, open, seed) &&
                    has_same_energies<kPrime61b>(robot, open, seed) && has_same_energies<kPrime61c>(robot, open, seed);
  result.points = result.primes = 3;
  result.degree_bound = energy_degree(robot, open);
  const double per_point = std::log2(std::max(1.0, result.degree_bound)) - kLog2Prime;
  result.failure_log2 = std::min(0.0, std::log2(kEnergies) + per_point * result.points);
}

int rotor_count(const Robot& robot) {
  return static_cast<int>(std::count_if(robot.joints.begin(), robot.joints.end(), [](const Joint& joint) {
    return joint.motor && joint.type != JointType::fixed;
  }));
}

}  // namespace

AsReadResult prove_as_read(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed) {
  AsReadResult result;
  const Differences differences = compare_numbers(robot, mechanism, seed);
  result.holds = differences.first().empty();
  result.difference = differences.first();
  result.numbers = differences.numbers();
  result.largest = differences.largest();
  result.links = static_cast<int>(robot.links.size());
  result.rotors = rotor_count(robot);
  result.has_loops = mechanism.has_loops();
  if (result.holds) compare_energies(robot, mechanism, seed, result);
  return result;
}

int AsReadResult::digits() const {
  return largest > 0 ? std::min(kMostDigits, static_cast<int>(std::floor(-std::log10(largest)))) : kMostDigits;
}

std::string AsReadResult::summary() const {
  if (!holds) return difference + " differs";
  std::string text =
      fmt::format("{} links and {} rotors: {} numbers equal to {} digits", links, rotors, numbers, digits());
  if (is_exact) {
    text += fmt::format(
        "; energies equal at {} points modulo {} primes, degree at most {:.3g}, wrong with probability below 2^{:.0f}",
        points, primes, degree_bound, std::ceil(failure_log2));
  }
  if (has_loops) text += "; what closes the loops is not compared";
  return text;
}

}  // namespace flatdyn
