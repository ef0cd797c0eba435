// SPDX-License-Identifier: GPL-2.0-or-later
// Several functions that are evaluated at the same q, or at the same q and q̇: what they share is computed once.
//
//   at(q)      →  Configuration: what depends on q only and is needed by two of its functions, or at all by a motion
//   .with(qd)  →  Motion: what depends on q̇, too, and is needed by two of its functions, or by one that takes more
//
// Functions of q alone are members of Configuration, the others of Motion. Each computes the rest of its own.
#pragma once

#include <string>
#include <vector>

#include "graph/fusion.hpp"

namespace flatdyn {

// A stage's members read what it stores as inputs of kind `stored`, by index of the field.
struct Stage {
  Function make;                    // one output: its fields
  std::vector<std::string> fields;  // their names
  std::vector<Function> members;
};

struct Stages {
  Stage configuration;
  Stage motion;  // `make` reads fields of the configuration; without members if no function takes more than q
};

Stages stages_of(const Fusion& fusion);

// The members of both stages as functions of q and q̇ again: what is stored is put in its place.
std::vector<Function> members_in_full(const Stages& stages);

}  // namespace flatdyn
