// SPDX-License-Identifier: GPL-2.0-or-later
// Inertia of MJCF's bodies: from <inertial>, from geoms, within the compiler's bounds.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

class MjcfInertia : public RobotFiles {
 protected:
  // The inertias of the one body with these elements.
  std::vector<Inertial> inertials(const std::string& elements, const std::string& compiler = "") {
    const Robot robot =
        read("r.xml", "<mujoco><compiler " + compiler + "/><worldbody><body name=\"a\"><joint name=\"j\"/>" + elements +
                          "</body></worldbody></mujoco>");
    return robot.links.back().inertials;
  }
};

std::string printed_number(const Number& number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

// "mass: xx yy zz", to ten digits.
std::string inertia_summary(const Inertial& inertial) {
  const auto digits = [](const Number& number) { return fmt::format("{:.10g}", nearest_double(number)); };
  const Mat3& I = inertial.tensor;
  return digits(inertial.mass.number) + ": " + digits(I[0][0]) + " " + digits(I[1][1]) + " " + digits(I[2][2]);
}

struct GeomShape {
  const char* name;
  const char* geom;
  const char* summary;  // by MuJoCo 3.14, which prints ten digits
};

class MjcfShapes : public MjcfInertia, public ::testing::WithParamInterface<GeomShape> {};

TEST_P(MjcfShapes, HaveMujocosInertia) {
  const std::vector<Inertial> found = inertials(GetParam().geom);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(inertia_summary(found[0]), GetParam().summary);
}

INSTANTIATE_TEST_SUITE_P(
    Geoms, MjcfShapes,
    ::testing::Values(GeomShape{"sphere", R"(<geom size="1"/>)", "4188.790205: 1675.516082 1675.516082 1675.516082"},
                      GeomShape{"capsule", R"(<geom type="capsule" size="1 2"/>)",
                                "16755.16082: 44610.61568 44610.61568 7958.701389"},
                      GeomShape{"capsule_of_a_mass", R"(<geom type="capsule" size="1 2" mass="3"/>)",
                                "3: 7.9875 7.9875 1.425"},
                      GeomShape{"cylinder", R"(<geom type="cylinder" size="1 2"/>)",
                                "12566.37061: 19896.75347 19896.75347 6283.185307"},
                      GeomShape{"ellipsoid", R"(<geom type="ellipsoid" size="1 2 3"/>)",
                                "25132.74123: 65345.12719 50265.48246 25132.74123"},
                      GeomShape{"box", R"(<geom type="box" size="1 2 3"/>)", "48000: 208000 160000 80000"},
                      GeomShape{"from_to", R"(<geom type="capsule" size="1" fromto="0 0 0 4 0 0" mass="3"/>)",
                                "3: 7.9875 7.9875 1.425"},
                      GeomShape{"from_to_beside_pos_of_zero",
                                R"(<geom type="capsule" size="1" pos="0 0 0" fromto="0 0 0 4 0 0" mass="3"/>)",
                                "3: 7.9875 7.9875 1.425"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(MjcfInertia, IsExactInPi) {
  EXPECT_EQ(printed_number(inertials(R"(<geom size="1" density="3"/>)")[0].mass.number), "4*Pi");
}

TEST_F(MjcfInertia, CountsGeomsOfTheGroupsThatAreAskedFor) {
  const std::string geoms = R"(<geom size="1" group="2" mass="2"/><geom size="1" group="3" mass="3"/>)";
  EXPECT_EQ(inertials(geoms).size(), 2U);
  const std::vector<Inertial> found = inertials(geoms, R"(inertiagrouprange="3 5")");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(printed_number(found[0].mass.number), "3");
}

TEST_F(MjcfInertia, PrefersGeomsWhereTheCompilerSaysSo) {
  const std::string both = R"(<inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/><geom size="1" mass="3"/>)";
  EXPECT_EQ(printed_number(inertials(both)[0].mass.number), "2");
  EXPECT_EQ(printed_number(inertials(both, R"(inertiafromgeom="true")")[0].mass.number), "3");
}

TEST_F(MjcfInertia, ReadsAFullMatrix) {
  const Mat3 tensor = inertials(R"(<inertial pos="0 0 0" mass="2" fullinertia="2 3 4 0.1 0.2 0.3"/>)")[0].tensor;
  EXPECT_EQ(printed_number(tensor[1][1]), "3");
  EXPECT_EQ(printed_number(tensor[0][1]), "1/10");
  EXPECT_EQ(printed_number(tensor[2][0]), "1/5");
  EXPECT_EQ(printed_number(tensor[1][2]), "3/10");
}

constexpr const char* kLightBody = R"(<inertial pos="1 0 0" mass="1" diaginertia="1 2 2.5"/>)";

TEST_F(MjcfInertia, IsAtLeastTheCompilersBounds) {
  const std::vector<Inertial> found = inertials(kLightBody, R"(boundmass="3" boundinertia="1.5")");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(inertia_summary(found[0]), "1: 1.5 2 2.5");
  EXPECT_EQ(printed_number(found[1].mass.number), "2");
  EXPECT_EQ(printed_number(found[1].frame.displacements.front().translation[0]), "1");
}

TEST_F(MjcfInertia, IsScaledToATotal) {
  EXPECT_EQ(inertia_summary(inertials(kLightBody, R"(settotalmass="10")")[0]), "10: 10 20 25");
}

TEST_F(MjcfInertia, IsBalancedWhereNoBodyCouldHaveIt) {
  const char* impossible = R"(<inertial pos="0 0 0" mass="1" diaginertia="1 2 6"/>)";
  EXPECT_EQ(inertia_summary(inertials(impossible, R"(balanceinertia="true")")[0]), "1: 3 3 3");
  EXPECT_EQ(inertia_summary(inertials(kLightBody, R"(balanceinertia="true")")[0]), "1: 1 2 2.5");
}

}  // namespace
}  // namespace flatdyn
