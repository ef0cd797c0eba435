// SPDX-License-Identifier: GPL-2.0-or-later
// A function as text for people, as compilers print their intermediate representation: a node a line, in order of its
// number, with everything that the function says.
//
//   function gravity
//     summary: gravity torques g(q)
//     equation: (7.39)
//     inputs: q
//   nodes:
//     %0 = q[1]                     q[k]: input k, counted from 0
//     %1 = sin %0                   ; s_2
//     %2 = 1/2 %1 - %0 + 981/100    a sum; a scaled node is a sum of one term
//     %3 = %1 * %2
//     %4 = %3 / %2
//   outputs:
//     g vector 2 1: %3 %4           ; joint torques, N m
//   conditions:                     nodes that must be positive
//     %4 pivot of %2                the pivot's scale
//     %3 loop                       a closed loop is not singular
#pragma once

#include <string>

#include "graph/function.hpp"

namespace flatdyn {

std::string to_text(const Function& function);

}  // namespace flatdyn
