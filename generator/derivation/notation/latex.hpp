// SPDX-License-Identifier: GPL-2.0-or-later
// Names and numbers in LaTeX.
#pragma once

#include <string>

namespace flatdyn {

// "m_l1" → "m_{l_{1}}", "a1" → "a_{1}", "alpha" → "\alpha", "mass" → "\mathit{mass}".
std::string latex_name(const std::string& name);

// "1.5e-05" → "1.5 \cdot 10^{-5}".
std::string latex_number(const std::string& decimal);

// A formula for the right-hand side of an align environment, broken before a + or - where a line would be wider than a
// page of A4.
std::string latex_lines(const std::string& formula);

}  // namespace flatdyn
