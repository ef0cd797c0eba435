// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/peers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "robot/model/floating_base.hpp"
#include "robot/model/physical_inertia.hpp"
#include "robot/model/spherical_joint.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

// The recursive reference. Eigen's inline functions get a namespace of their own: those in another library were
// compiled for another machine.
BenchPeer reference_peer() {
  return {"reference",
          "reference",
          bench_flags() + " -ftree-slp-vectorize -DNDEBUG -DEigen=eigen_of_reference $(pkg-config --cflags eigen3)",
          "",
          templates::bench_reference_cpp,
          {"inverse_dynamics", "inverse_dynamics_tip_force", "inertia_matrix", "christoffel", "coriolis_matrix",
           "gravity", "bias", "forward_dynamics", "kinetic_energy", "forward_kinematics", "jacobian", "jacobian_dot_qd",
           "inverse_dynamics_derivatives", "forward_dynamics_derivatives"}};
}

// Orocos KDL, compiled for the same machine as its library: both share Eigen's layout in memory.
BenchPeer kdl_peer() {
  return {
      "KDL",
      "kdl",
      "-std=c++17 -O3 -DNDEBUG $(pkg-config --cflags orocos-kdl)",
      "$(pkg-config --libs orocos-kdl)",
      templates::bench_kdl_cpp,
      {"inverse_dynamics", "inertia_matrix", "gravity", "bias", "forward_dynamics", "forward_kinematics", "jacobian"}};
}

BenchPeer mujoco_peer() {
  return {"MuJoCo",
          "mujoco",
          "-std=c++17 -O3 -DNDEBUG",
          "-lmujoco",
          templates::bench_mujoco_cpp,
          {"inverse_dynamics", "inertia_matrix", "gravity", "bias", "forward_dynamics"}};
}

// DART, compiled for the same machine as its library, like KDL: they share Eigen's inline functions, too.
BenchPeer dart_peer() {
  return {"DART",
          "dart",
          "-std=c++17 -O3 -DNDEBUG $(pkg-config --cflags-only-I dart)",
          "-ldart",
          templates::bench_dart_cpp,
          {"inverse_dynamics", "inertia_matrix", "gravity", "bias", "forward_dynamics", "kinetic_energy",
           "forward_kinematics", "jacobian"}};
}

// The functions of tests/benchmark/pinocchio/algorithms.hpp, and those with a symmetric output.
const std::set<std::string> kPinocchioFunctions = {"inverse_dynamics",
                                                   "inertia_matrix",
                                                   "gravity",
                                                   "bias",
                                                   "coriolis_matrix",
                                                   "forward_dynamics",
                                                   "inverse_dynamics_derivatives",
                                                   "forward_dynamics_derivatives"};
const std::set<std::string> kPinocchioHalved = {"inertia_matrix", "forward_dynamics_derivatives"};

// Pinocchio's algorithms, in the library that scripts/bench has compiled for this machine.
BenchPeer pinocchio_peer(const std::string& folder) {
  return {"Pinocchio",
          "pinocchio",
          fmt::format("-std=c++17 -O3 -I'{}'", folder),
          fmt::format("'{}/library.o'", folder),
          templates::bench_pinocchio_cpp,
          kPinocchioFunctions,
          kPinocchioHalved,
          "library.hpp",
          "static pinocchio_peer::Called& of = *pinocchio_peer::called(\"mechanism\", \"{0}\"); "
          "pinocchio_peer::call(of, x, y);",
          ""};
}

// C of Pinocchio's algorithms that another program has recorded. The compiler may contract products and sums, as
// nothing is promised about its bits.
BenchPeer recorded_peer(const std::string& name, const std::string& stem, const std::string& folder,
                        const std::string& arguments) {
  return {name,
          stem,
          bench_flags() + " -ffp-contract=fast",
          "",
          templates::bench_pinocchio_cpp,
          kPinocchioFunctions,
          kPinocchioHalved,
          stem + "_functions.hpp",
          stem + "_{0}(" + arguments + ");",
          fmt::format("'{}/record_{}' mechanism", folder, stem)};
}

bool is_chain(const Mechanism& mechanism) {
  for (int i = 0; i < mechanism.size(); ++i) {
    if (mechanism.bodies[static_cast<std::size_t>(i)].parent != i - 1) return false;
  }
  return true;
}

// The bodies of a floating base and of a spherical joint before their last ones have no mass and are passed over.
template <class Has>
bool any_body(const Mechanism& mechanism, Has has) {
  return std::any_of(mechanism.bodies.begin() + std::max(0, mechanism.base_bodies() - 1), mechanism.bodies.end(),
                     [&has](const Body& body) { return !is_inside_joint(body) && has(body); });
}

// A part of the mechanism that the other libraries cannot express or, like friction, define differently; empty if there
// is none.
std::string unknown_to_others(const Mechanism& mechanism) {
  if (any_body(mechanism, [](const Body& body) { return body.rotor.has_value(); })) return "it knows no rotors";
  const auto has_friction = [](const Body& body) { return !body.viscous.is_zero() || body.has_dry_friction(); };
  if (any_body(mechanism, has_friction)) return "its friction is another one";
  if (has_base_armature(mechanism)) return "its base moves freely, without armature";
  if (mechanism.has_springs()) return "its springs are not part of it";
  return "";
}

std::string unknown_to_kdl(const Mechanism& mechanism) {
  if (mechanism.floating_base) return "its base is fixed";
  if (mechanism.has_spherical_joints()) return "its joints have one axis";
  return is_chain(mechanism) ? unknown_to_others(mechanism) : "its dynamics are those of a chain, and this is none";
}

std::string unknown_to_mujoco(const Mechanism& mechanism) {
  if (!mechanism.symbols.empty()) return "whether it takes the links depends on the free symbols";
  const auto is_refused = [](const Body& body) {
    const InertialParameters& of = body.inertia;
    if (of.mass.is_zero()) return true;
    const Mat3 I = central_tensor(of);
    return I[0][0].is_zero() || fault_of_inertia(I).has_value();
  };
  if (any_body(mechanism, is_refused)) return "it refuses a link that no body could be";
  return unknown_to_others(mechanism);
}

std::string unknown_to_dart(const Mechanism& mechanism) {
  if (any_body(mechanism, [](const Body& body) { return !body.armature.is_zero(); })) return "it knows no armature";
  return unknown_to_others(mechanism);
}

void add_peer(BenchPeers& peers, const BenchPeer& peer, bool is_installed, const std::string& package,
              const std::string& unknown) {
  if (!is_installed) {
    peers.left_out.push_back(fmt::format("{}: it is not installed ({})", peer.name, package));
  } else if (!unknown.empty()) {
    peers.left_out.push_back(peer.name + ": " + unknown);
  } else {
    peers.found.push_back(peer);
  }
}

}  // namespace

BenchPeers find_peers(const Toolchain& toolchain, const Mechanism& mechanism) {
  BenchPeers peers;
  if (mechanism.size() == 0) return peers;
  if (mechanism.is_coupled()) {
    peers.left_out.emplace_back("other libraries: joints are coupled");
    return peers;
  }
  add_peer(peers, reference_peer(), toolchain.has_eigen, "libeigen3-dev", "");
  BenchPeer kdl = kdl_peer();
  // A chain to an inner link is a different chain in KDL, with fewer joints.
  if (mechanism.tip.body + 1 != mechanism.size()) {
    for (const char* name : {"forward_kinematics", "jacobian"}) kdl.functions.erase(name);
  }
  add_peer(peers, kdl, toolchain.has_kdl, "liborocos-kdl-dev", unknown_to_kdl(mechanism));
  add_peer(peers, mujoco_peer(), toolchain.has_mujoco, "libmujoco-dev", unknown_to_mujoco(mechanism));
  add_peer(peers, dart_peer(), toolchain.has_dart, "libdart-dev", unknown_to_dart(mechanism));
  const std::string& folder = toolchain.peers_folder;
  for (const BenchPeer& peer :
       {pinocchio_peer(folder), recorded_peer("CppADCodeGen", "cppadcodegen", folder, "&x, &y, {{}}"),
        recorded_peer("CasADi", "casadi", folder, "&x, &y, nullptr, nullptr, 0")}) {
    add_peer(peers, peer, !folder.empty(), "scripts/bench --peers", unknown_to_others(mechanism));
  }
  return peers;
}

}  // namespace flatdyn
