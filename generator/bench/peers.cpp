// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/peers.hpp"

#include <algorithm>

#include "templates.hpp"

namespace flatdyn {
namespace {

// Eigen's inline functions under a name of their own: another library's were compiled for another machine.
BenchPeer reference_peer() {
  return {
      "reference",
      "reference",
      std::string(kBenchFlags) + " -DNDEBUG -DEigen=eigen_of_reference $(pkg-config --cflags eigen3)",
      "",
      templates::bench_reference_cpp,
      {"inverse_dynamics", "inverse_dynamics_tip_force", "inertia_matrix", "christoffel", "coriolis_matrix", "gravity",
       "bias", "forward_dynamics", "kinetic_energy", "forward_kinematics", "jacobian", "jacobian_dot_qd"}};
}

// For the machine that its library was compiled for: both share Eigen's layout in memory.
BenchPeer kdl_peer() {
  return {
      "KDL",
      "kdl",
      "-std=c++17 -O3 -DNDEBUG $(pkg-config --cflags orocos-kdl)",
      "$(pkg-config --libs orocos-kdl)",
      templates::bench_kdl_cpp,
      {"inverse_dynamics", "inertia_matrix", "gravity", "bias", "forward_dynamics", "forward_kinematics", "jacobian"}};
}

bool is_chain(const Mechanism& mechanism) {
  for (int i = 0; i < mechanism.size(); ++i) {
    if (mechanism.bodies[static_cast<std::size_t>(i)].parent != i - 1) return false;
  }
  return mechanism.size() > 0;
}

// What KDL has no word for; empty if there is nothing of the kind.
std::string unknown_to_kdl(const Mechanism& mechanism) {
  const auto any = [&mechanism](auto has) {
    return std::any_of(mechanism.bodies.begin(), mechanism.bodies.end(), has);
  };
  if (!is_chain(mechanism)) return "its dynamics are those of a chain, and this is none";
  if (any([](const Body& body) { return body.rotor.has_value(); })) return "it knows no rotors";
  if (any([](const Body& body) { return !body.viscous.is_zero() || !body.coulomb.is_zero(); })) {
    return "it knows no friction";
  }
  return "";
}

}  // namespace

BenchPeers find_peers(const Toolchain& toolchain, const Mechanism& mechanism) {
  BenchPeers peers;
  if (mechanism.size() == 0) return peers;
  if (toolchain.has_eigen) {
    peers.found.push_back(reference_peer());
  } else {
    peers.left_out.emplace_back("reference: it needs Eigen (libeigen3-dev)");
  }
  const std::string unknown = unknown_to_kdl(mechanism);
  if (!toolchain.has_kdl) {
    peers.left_out.emplace_back("KDL: it is not installed (liborocos-kdl-dev)");
  } else if (!unknown.empty()) {
    peers.left_out.push_back("KDL: " + unknown);
  } else {
    peers.found.push_back(kdl_peer());
    // A chain to an inner link is another chain to KDL, with fewer joints.
    if (mechanism.tip.body + 1 != mechanism.size()) {
      for (const char* name : {"forward_kinematics", "jacobian"}) peers.found.back().functions.erase(name);
    }
  }
  return peers;
}

}  // namespace flatdyn
