// SPDX-License-Identifier: GPL-2.0-or-later
#include "support/identified_arm.hpp"
#include "support/names.hpp"

namespace flatdyn::testing {
namespace {

class Identification : public ::testing::TestWithParam<const char*> {};

TEST_P(Identification, RecoversEveryBaseParameterFromNoiseFreeMotion) { expect_recovery(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Robots, Identification,
                         ::testing::Values("rx90.toml", "ur5.urdf", "panda.urdf", "quadruped12.urdf"),
                         name_of_text<const char*>);

}  // namespace
}  // namespace flatdyn::testing
