// SPDX-License-Identifier: GPL-2.0-or-later
#include <functional>

#include "laboratory/stress/plain_robot.hpp"

namespace flatdyn {
namespace {

void stand_alone(PlainLink& link) {
  link.follows.clear();
  link.has_coordinate = true;
  link.offset = 0;
}

// The robot without link k, counted from 1; the links on it move to its parent.
PlainRobot without_link(const PlainRobot& robot, int k) {
  PlainRobot rest{robot.name, {}, robot.base};
  const int parent = robot.links[static_cast<std::size_t>(k - 1)].parent;
  const auto moved = [&](int link) {
    if (link == k) link = parent;
    return link > k ? link - 1 : link;
  };
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (static_cast<int>(i) == k - 1) continue;
    PlainLink link = robot.links[i];
    link.parent = moved(link.parent);
    link.motor.carrier = moved(link.motor.carrier);
    std::erase_if(link.follows, [k](const PlainFollowing& leader) { return leader.joint == k; });
    for (PlainFollowing& leader : link.follows) leader.joint -= leader.joint > k ? 1 : 0;
    if (link.follows.empty()) stand_alone(link);
    rest.links.push_back(link);
  }
  return rest;
}

// A change that simplifies a link or leaves it as it is.
using Change = std::function<void(PlainLink&)>;

// Rounds to a whole number, or halves it.
int rounder(int value) { return value / 100 * 100 != value ? value / 100 * 100 : value / 2; }

Change without(PlainVector PlainLink::*member) {
  return [member](PlainLink& link) { link.*member = kNoVector; };
}

Change without(int PlainLink::*member) {
  return [member](PlainLink& link) { link.*member = 0; };
}

// Adds changes that set one entry to zero or, as a smaller step, round it.
void add_entries(std::vector<Change>& changes, PlainVector PlainLink::*member) {
  for (std::size_t k = 0; k < 3; ++k) {
    changes.push_back([=](PlainLink& link) { (link.*member)[k] = 0; });
    changes.push_back([=](PlainLink& link) {
      int& entry = (link.*member)[k];
      entry = link.has_quarter_turns && member == &PlainLink::rpy ? entry / 2 : rounder(entry);
    });
  }
}

std::vector<Change> all_changes() {
  std::vector<Change> changes = {
      [](PlainLink& link) { link.has_motor = false, link.motor = {}; },
      [](PlainLink& link) {
        link.particles = {0, 0, 0}, link.arms = {};
      },
      stand_alone,
      [](PlainLink& link) { link.has_coordinate = true; },
      without(&PlainLink::offset),
      without(&PlainLink::viscous),
      without(&PlainLink::coulomb),
      without(&PlainLink::xyz),
      without(&PlainLink::rpy),
      without(&PlainLink::com),
      [](PlainLink& link) {
        link.axis = {0, 0, 100};
      },
      [](PlainLink& link) { link.is_prismatic = false; },
      [](PlainLink& link) { link.is_spherical = false; },
      without(&PlainLink::mass),
      [](PlainLink& link) { link.motor.carrier = -1; },
      [](PlainLink& link) {
        link.motor.axis = {0, 0, 100};
      },
      [](PlainLink& link) { link.motor.position = kNoVector; },
      [](PlainLink& link) { link.motor.mass = 0; },
      [](PlainLink& link) { link.motor.ratio = 1; },
      [](PlainLink& link) { link.mass = link.mass == 0 ? 0 : 100; },
  };
  for (std::size_t k = 0; k < 3; ++k) {
    changes.push_back([k](PlainLink& link) { link.particles[k] = 0, link.arms[k] = kNoVector; });
    changes.push_back([k](PlainLink& link) { link.particles[k] = link.particles[k] == 0 ? 0 : 100; });
  }
  for (const auto member : {&PlainLink::xyz, &PlainLink::rpy, &PlainLink::com}) add_entries(changes, member);
  for (std::size_t k = 0; k < 9; ++k) {
    changes.push_back([k](PlainLink& link) { link.arms[k / 3][k % 3] = 0; });
    changes.push_back([k](PlainLink& link) { link.arms[k / 3][k % 3] /= 2; });
  }
  return changes;
}

}  // namespace

std::vector<PlainRobot> simpler_robots(const PlainRobot& robot) {
  static const std::vector<Change> changes = all_changes();
  std::vector<PlainRobot> all;
  const int links = static_cast<int>(robot.links.size());
  for (int k = links; k >= 1 && links > 1; --k) all.push_back(without_link(robot, k));
  if (robot.base) all.push_back({robot.name, robot.links});
  for (const Change& change : changes) {
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      PlainRobot simpler = robot;
      change(simpler.links[i]);
      if (simpler.links[i] != robot.links[i]) all.push_back(std::move(simpler));
    }
  }
  return all;
}

}  // namespace flatdyn
