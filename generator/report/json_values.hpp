// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers in JSON reports.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace flatdyn {

inline constexpr int kJsonDigits = 17;  // of numbers inside texts: a double comes back as it was

inline std::vector<double> list(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

}  // namespace flatdyn
