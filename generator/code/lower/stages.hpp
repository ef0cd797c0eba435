// SPDX-License-Identifier: GPL-2.0-or-later
// Several functions that are evaluated at the same q, or at the same q and q̇, with their common values computed once.
//
//   at(q)      →  Configuration: values that depend on q only and are needed by two of its functions, or by a Motion
//   .with(qd)  →  Motion: values that depend on q̇, too, and are needed by two of its functions, or by one that takes
//                 more inputs
//
// Functions of q alone are members of Configuration, the others of Motion. With a floating base v is in the place of
// q̇, and g_b is an argument of the members. Each computes the rest itself.
#pragma once

#include <string>
#include <vector>

#include "graph/fusion.hpp"

namespace flatdyn {

// A stage. Its members read stored values as inputs of kind `stored`, by index of the field.
struct Stage {
  Function make;                    // its only output is the fields
  std::vector<std::string> fields;  // names of the fields
  std::vector<Function> members;
};

struct Stages {
  Stage configuration;
  Stage motion;  // `make` reads fields of the configuration; no members if no function takes more than q
};

// Divides a fused function into stages.
Stages stages_of(const Fusion& fusion);

// The members of both stages as functions of q and q̇, with stored values replaced by what computes them.
std::vector<Function> members_in_full(const Stages& stages);

}  // namespace flatdyn
