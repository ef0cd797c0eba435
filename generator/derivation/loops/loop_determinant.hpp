// SPDX-License-Identifier: GPL-2.0-or-later
// Determinants of the equations of closed loops, and what they are solved with.
#pragma once

#include <string>
#include <vector>

#include "derivation/kernel/derivation.hpp"

namespace flatdyn {

// The determinant of up to five rows: by its first row; beyond three rows by products of minors (Laplace), those of the
// last two rows with those of the rows before them. Each minor gets a name, so that other determinants share it.
Number determinant(const Rows& A, Derivation& derivation, const std::string& name);

// A with column c replaced by -b: its determinant. Minors without b are those of A.
Number determinant_with(const Rows& A, std::size_t c, const std::vector<Number>& b, Derivation& derivation,
                        const std::string& name);

}  // namespace flatdyn
