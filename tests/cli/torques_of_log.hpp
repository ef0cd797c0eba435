// SPDX-License-Identifier: GPL-2.0-or-later
// Torques of robot files at the states of a log, by the program.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/csv_numbers.hpp"
#include "cli/program.hpp"

namespace flatdyn::testing {

// The torques of a robot file at the states of a log.
inline std::vector<std::vector<double>> torques(const std::string& robot, const std::string& log) {
  const Outcome outcome = run_flatdyn(fmt::format("eval {} -q --function inverse_dynamics --states {}", robot, log));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return numbers_of(outcome.out);
}

}  // namespace flatdyn::testing
