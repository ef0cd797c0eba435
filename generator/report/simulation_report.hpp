// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/simulate/simulator.hpp"
#include "report/plot/time_table.hpp"

namespace flatdyn {

// Columns t,q1,…,qd1,…,qdd1,…,tau1,…,friction1,…,kinetic,potential,work,dissipated, in SI units.
TimeTable simulation_table(const Mechanism& mechanism, const SimulatedMotion& motion);
// CSV with columns t,joint,event.
std::string events_csv(const Mechanism& mechanism, const SimulatedMotion& motion);
// Positions, speeds, torques, energies over time.
std::string simulation_plot(const Mechanism& mechanism, const TimeTable& table, PictureFormat format);

// seconds: the time that the integration took.
std::string describe_simulation(const Mechanism& mechanism, const SimulatedMotion& motion, double seconds);
nlohmann::ordered_json simulation_json(const Mechanism& mechanism, const SimulatedMotion& motion, double seconds);

}  // namespace flatdyn
