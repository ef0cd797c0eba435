// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "simulate/simulator.hpp"

namespace flatdyn {

// time,q1,…,qd1,…,qdd1,…,tau1,…,friction1,…,kinetic,potential,work,dissipated: SI units.
std::string simulation_csv(const SimulatedMotion& motion);
// time,joint,event
std::string events_csv(const Mechanism& mechanism, const SimulatedMotion& motion);
// Positions, speeds, torques, energies over time. SVG.
std::string simulation_plot(const Mechanism& mechanism, const SimulatedMotion& motion);

// seconds: that the integration took.
std::string describe_simulation(const Mechanism& mechanism, const SimulatedMotion& motion, double seconds);
nlohmann::ordered_json simulation_json(const Mechanism& mechanism, const SimulatedMotion& motion, double seconds);

}  // namespace flatdyn
