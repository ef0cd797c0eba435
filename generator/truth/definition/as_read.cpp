// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/definition/as_read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graph/mod_p.hpp"
#include "robot/model/joint_points.hpp"
#include "truth/definition/as_read_numbers.hpp"
#include "truth/definition/degree.hpp"
#include "truth/definition/lagrangian.hpp"
#include "truth/definition/written_energies.hpp"

namespace flatdyn {
namespace {

Mechanism open_tree(Mechanism mechanism) {
  mechanism.loops.clear();
  mechanism.independent.clear();
  return mechanism;
}

template <class F>
struct EnergyPair {
  Energies<F> written, lagrangian;
};

// The energies at the point that the arithmetic draws. `mechanism`: without loops.
template <class Arithmetic, class F = typename Arithmetic::Scalar>
EnergyPair<F> energies_at(const Robot& robot, const Mechanism& mechanism, Arithmetic& arithmetic) {
  std::vector<F> qd;
  for (int k = 0; k < mechanism.size(); ++k) {
    qd.push_back(arithmetic.input({with_base(InputKind::qd, mechanism.has_quasi_velocities()), k}));
  }
  const std::vector<JointPoint<F>> q = joint_points(mechanism, arithmetic);
  Lagrangian<F> lagrangian(mechanism_over(mechanism, arithmetic), q);
  const std::vector<F> rates = joint_values(lagrangian.mechanism(), qd);
  WrittenEnergies<Arithmetic> written(robot, lagrangian.mechanism(), arithmetic, q, rates, mechanism.offsets);
  return {written.sum(), {lagrangian.kinetic_energy(qd), lagrangian.potential_energy()}};
}

template <std::uint64_t P>
bool has_equal_energies(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed) {
  ModPArithmetic<P> arithmetic = ModPArithmetic<P>(seed).with_quaternions(mechanism.quaternions());
  const auto [written, lagrangian] = energies_at(robot, mechanism, arithmetic);
  return written.kinetic == lagrangian.kinetic && written.potential == lagrangian.potential;
}

// Whether they differ by no more than snapped residues do.
bool has_near_energies(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed) {
  constexpr double kNear = 1e-30;
  RealArithmetic<Digits100> arithmetic = drawn_reals(seed);
  const auto [written, lagrangian] = energies_at(robot, mechanism, arithmetic);
  const Digits100 allowed = kNear * (abs(written.kinetic) + abs(written.potential));
  return abs(written.kinetic - lagrangian.kinetic) <= allowed &&
         abs(written.potential - lagrangian.potential) <= allowed;
}

// `mechanism`: without loops.
void compare_energies(const Robot& robot, const Mechanism& mechanism, std::uint64_t seed, AsReadResult& result) {
  constexpr double kLog2Prime = 60.99;  // all primes are above 2^60.99
  constexpr int kEnergies = 2;
  result.is_exact = has_equal_energies<kMersenne61>(robot, mechanism, seed) &&
                    has_equal_energies<kPrime61b>(robot, mechanism, seed) &&
                    has_equal_energies<kPrime61c>(robot, mechanism, seed);
  if (!result.is_exact) {
    result.holds = has_near_energies(robot, mechanism, seed);
    if (!result.holds) result.difference = "the sum of the energies";
    return;
  }
  result.points = result.primes = 3;
  result.degree_bound = energy_degree(robot, mechanism);
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
  const Mechanism tree = open_tree(mechanism);
  const Differences differences = compare_numbers(robot, tree, seed);
  result.holds = differences.first().empty();
  result.difference = differences.first();
  result.numbers = differences.numbers();
  result.largest = differences.largest();
  result.links = static_cast<int>(robot.links.size());
  result.rotors = rotor_count(robot);
  result.has_loops = mechanism.has_loops();
  if (result.holds) compare_energies(robot, tree, seed, result);
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
