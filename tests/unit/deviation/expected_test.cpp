// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/deviation/expected.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "robot/model/states.hpp"
#include "support/robot_models.hpp"

namespace flatdyn::testing {
namespace {

constexpr double kFloatEpsilon = std::numeric_limits<float>::epsilon();

// Its values are numbers of float, with errors as large as those of float.
TEST(Expected, TheReferenceInFloatHas24Bits) {
  const LoadedRobot model = model_of("planar_2r.toml");
  const ExpectedValues values(model.robot, model.mechanism, 1);
  for (const std::string name : {"inverse_dynamics", "forward_dynamics", "regressor"}) {
    Function function;
    function.name = name;
    const Expected expected = values.of(function);
    double worst = 0;
    for (const State& drawn : with_parameters(random_states(model.mechanism, 20, 1), values.symbols())) {
      const State state = in_float(drawn);
      const std::vector<Real50> exact = expected.exact(state);
      const std::vector<double> found = expected.in_float(state), scale = expected.scale(state);
      ASSERT_EQ(found.size(), exact.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k], double(float(found[k])));
        const double error = absolute_error(found[k], exact[k]);
        EXPECT_LE(error, 20 * kFloatEpsilon * scale[k]) << name << " " << k;
        if (scale[k] > 0) worst = std::max(worst, error / (kFloatEpsilon * scale[k]));
      }
    }
    EXPECT_GE(worst, 0.1) << name;
  }
}

}  // namespace
}  // namespace flatdyn::testing
