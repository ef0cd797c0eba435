// SPDX-License-Identifier: GPL-2.0-or-later
// Operation counts are the product: none may grow unnoticed. The ceilings are the present counts.
#include <gtest/gtest.h>

#include "functions/planning/make_functions.hpp"
#include "graph/count.hpp"

namespace flatdyn {
namespace {

struct Ceiling {
  const char* robot;
  const char* function;
  int multiplications, additions;
  int candidates = 0;  // candidates of a search
};

class OperationCounts : public ::testing::TestWithParam<Ceiling> {};

TEST_P(OperationCounts, AreNotAbove) {
  PipelineOptions options;
  options.functions = {GetParam().function};
  if (GetParam().candidates > 0) options.search = SearchLimit{GetParam().candidates, std::nullopt};
  const LoadedRobot model = load_robot(std::string(FLATDYN_SOURCE_DIR "/robots/") + GetParam().robot, options);
  Progress quiet(true);
  Diagnostics left_out;
  const OperationCount count = count_operations(make_functions(model, options, quiet, left_out).at(0).function);
  EXPECT_LE(count.multiplications, GetParam().multiplications);
  EXPECT_LE(count.additions, GetParam().additions);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, OperationCounts,
    ::testing::Values(
        Ceiling{"panda.urdf", "inverse_dynamics", 273, 256}, Ceiling{"panda.urdf", "inertia_matrix", 157, 147},
        Ceiling{"panda.urdf", "christoffel", 698, 594}, Ceiling{"panda.urdf", "coriolis_matrix", 745, 639},
        Ceiling{"panda.urdf", "bias", 267, 239}, Ceiling{"panda.urdf", "gravity", 43, 29},
        Ceiling{"panda.urdf", "forward_dynamics", 537, 452}, Ceiling{"rx90.toml", "inverse_dynamics", 210, 193},
        Ceiling{"rx90.toml", "inertia_matrix", 94, 86}, Ceiling{"rx90.toml", "forward_dynamics", 353, 284},
        Ceiling{"puma560.toml", "inverse_dynamics", 166, 137}, Ceiling{"ur5.urdf", "inverse_dynamics", 141, 102},
        Ceiling{"rx90.toml", "gravity", 29, 19}, Ceiling{"puma560.toml", "gravity", 16, 8},
        Ceiling{"ur5.urdf", "gravity", 15, 7}, Ceiling{"quadruped12.urdf", "gravity", 52, 24},
        Ceiling{"ur5.urdf", "coriolis_matrix", 189, 138}, Ceiling{"rx90.toml", "coriolis_matrix", 425, 369},
        Ceiling{"panda.urdf", "inverse_dynamics_derivatives", 1419, 1239},
        Ceiling{"panda.urdf", "forward_dynamics_derivatives", 2530, 2187},
        Ceiling{"panda.urdf", "operational_inertia", 1232, 1001}, Ceiling{"panda.urdf", "operational_bias", 1364, 1062},
        Ceiling{"planar_2r_example_7_2.toml", "inverse_dynamics", 14, 13},
        Ceiling{"puma560.toml", "forward_dynamics", 274, 211}, Ceiling{"ur5.urdf", "inertia_matrix", 60, 43},
        Ceiling{"ur5.urdf", "forward_dynamics", 235, 167}, Ceiling{"panda.urdf", "inverse_dynamics", 270, 254, 60},
        Ceiling{"panda.urdf", "inertia_matrix", 157, 146, 60}, Ceiling{"rx90.toml", "inverse_dynamics", 208, 191, 60},
        Ceiling{"puma560.toml", "inverse_dynamics", 164, 133, 60},
        Ceiling{"ur5.urdf", "inverse_dynamics", 133, 97, 60}),
    [](const auto& test) {
      std::string name = std::string(test.param.robot) + "_" + test.param.function;
      if (test.param.candidates > 0) name += "_search_" + std::to_string(test.param.candidates);
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return name;
    });

// The fused function gets the torques from B q̈ and the bias, two operations for each entry of B.
TEST(FusedOperationCounts, AreThoseOfBAndOfTheBias) {
  const LoadedRobot model = load_robot(FLATDYN_SOURCE_DIR "/robots/panda.urdf", {});
  Progress quiet(true);
  const auto operations = [&](const std::vector<std::string>& functions) {
    return count_operations(make_fusion(model, functions, quiet).fusion.function).arithmetic();
  };
  EXPECT_LE(operations({"inertia_matrix", "bias", "inverse_dynamics"}),
            operations({"inertia_matrix", "bias"}) + 2 * 7 * 7);
}

}  // namespace
}  // namespace flatdyn
