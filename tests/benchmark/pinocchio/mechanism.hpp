// SPDX-License-Identifier: GPL-2.0-or-later
// A mechanism as numbers, which `flatdyn bench` writes to the file "mechanism" for peers that are compiled once for all
// robots.
#pragma once

#include <array>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace pinocchio_peer {

// The frame of a link in its parent's frame is R and p at q = 0, and its z is the joint's axis.
struct Link {
  int parent;                 // -1: the base
  int prismatic;              // 1 or 0
  int spherical;              // 1, 2, 3: the first, second or last link of a spherical joint
  std::array<double, 9> R;    // row by row
  std::array<double, 3> p;    // m
  double mass;                // kg
  std::array<double, 3> r_C;  // centre of mass, m
  std::array<double, 9> I;    // about the centre of mass, kg m^2
  double armature;            // kg m^2, or kg
};

struct Mechanism {
  int base_bodies = 0;              // 6 for a floating base, whose link is the last of them
  std::array<double, 3> gravity{};  // m/s^2, base frame; only whether it is 0 counts for a floating base
  std::vector<Link> links;          // one for each entry of velocities
};

template <std::size_t n>
std::istream& operator>>(std::istream& stream, std::array<double, n>& numbers) {
  for (double& number : numbers) stream >> number;
  return stream;
}

// Reads the file. Throws std::runtime_error if it cannot be read.
inline Mechanism read_mechanism(const std::string& path) {
  std::ifstream stream(path);
  std::size_t links = 0;
  Mechanism mechanism;
  stream >> links >> mechanism.base_bodies >> mechanism.gravity;
  mechanism.links.resize(stream ? links : 0);
  for (Link& link : mechanism.links) {
    stream >> link.parent >> link.prismatic >> link.spherical >> link.R >> link.p >> link.mass >> link.r_C >> link.I >>
        link.armature;
  }
  if (!stream) throw std::runtime_error("cannot read a mechanism from " + path);
  return mechanism;
}

}  // namespace pinocchio_peer
