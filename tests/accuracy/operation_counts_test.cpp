// SPDX-License-Identifier: GPL-2.0-or-later
// Operation counts are the product: none may grow unseen. Ceilings are what is reached today.
#include <gtest/gtest.h>

#include "graph/count.hpp"
#include "pipeline.hpp"

namespace flatdyn {
namespace {

struct Ceiling {
  const char* robot;
  const char* function;
  int multiplications, additions;
};

class OperationCounts : public ::testing::TestWithParam<Ceiling> {};

TEST_P(OperationCounts, AreNotAbove) {
  PipelineOptions options;
  options.functions = {GetParam().function};
  const Model model = read_model(std::string(FLATDYN_SOURCE_DIR "/robots/") + GetParam().robot, options);
  Progress quiet(true);
  Diagnostics left_out;
  const OperationCount count = count_operations(make_functions(model, options, quiet, left_out).at(0).function);
  EXPECT_LE(count.multiplications, GetParam().multiplications);
  EXPECT_LE(count.additions, GetParam().additions);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, OperationCounts,
    ::testing::Values(
        Ceiling{"panda.urdf", "inverse_dynamics", 308, 290}, Ceiling{"panda.urdf", "inertia_matrix", 182, 157},
        Ceiling{"panda.urdf", "christoffel", 770, 622}, Ceiling{"panda.urdf", "coriolis_matrix", 808, 667},
        Ceiling{"panda.urdf", "bias", 300, 273}, Ceiling{"panda.urdf", "gravity", 43, 29},
        Ceiling{"panda.urdf", "forward_dynamics", 610, 538}, Ceiling{"rx90.toml", "inverse_dynamics", 241, 227},
        Ceiling{"rx90.toml", "inertia_matrix", 113, 100}, Ceiling{"rx90.toml", "forward_dynamics", 427, 370},
        Ceiling{"puma560.toml", "inverse_dynamics", 193, 157}, Ceiling{"ur5.urdf", "inverse_dynamics", 175, 135},
        Ceiling{"rx90.toml", "gravity", 33, 22}, Ceiling{"puma560.toml", "gravity", 20, 11},
        Ceiling{"ur5.urdf", "gravity", 22, 12}, Ceiling{"quadruped12.urdf", "gravity", 52, 24},
        Ceiling{"ur5.urdf", "coriolis_matrix", 260, 195}, Ceiling{"rx90.toml", "coriolis_matrix", 494, 410},
        Ceiling{"panda.urdf", "inverse_dynamics_derivatives", 1525, 1281},
        Ceiling{"panda.urdf", "forward_dynamics_derivatives", 2663, 2236},
        Ceiling{"planar_2r_example_7_2.toml", "inverse_dynamics", 14, 13}),
    [](const auto& test) {
      std::string name = std::string(test.param.robot) + "_" + test.param.function;
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return name;
    });

}  // namespace
}  // namespace flatdyn
