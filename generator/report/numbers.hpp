// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers in reports. In JSON, infinity is null.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

namespace flatdyn {

inline constexpr int kJsonDigits = 17;  // digits of numbers inside texts: a double reads back exactly

inline std::vector<double> list(const Eigen::VectorXd& v) { return {v.data(), v.data() + v.size()}; }

// A standard deviation as text; infinite where the data do not determine the value.
inline std::string deviation_text(double deviation) {
  return std::isfinite(deviation) ? fmt::format("{:.2g}", deviation) : "not told";
}

}  // namespace flatdyn
