// SPDX-License-Identifier: GPL-2.0-or-later
// Base parameters as combinations of the file's parameters: their printed coefficients times the file's numbers are the
// values, exactly.
#include "derivation/parameters/file_parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "derivation/notation/combination_text.hpp"
#include "report/base_report.hpp"
#include "robot/model/rational_rotation.hpp"
#include "support/names.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

using testing::model_of;

constexpr ParameterSet kSets[] = {ParameterSet::inertial, ParameterSet::given, ParameterSet::full,
                                  ParameterSet::nonzero};

// A body of the file about the origin of its link's frame.
InertialParameters body_of(const Inertial& inertial) {
  const Number m = inertial.mass.number;
  const Vec3& r = inertial.centre_of_mass;
  InertialParameters body{m, m * r, inertial.tensor};
  if (inertial.about == Inertial::About::centre_of_mass) body.inertia = body.inertia + steiner(m, r);
  for (std::size_t k = inertial.frame.displacements.size(); k-- > 0;) {
    const Displacement& step = inertial.frame.displacements[k];
    body = transformed(body, exact_rotation(step), step.translation);
  }
  return body;
}

// A rotor of the file, whose axis is along z of its carrier.
InertialParameters rotor_of(const Motor& motor) {
  const Number m = motor.mass.number, across = motor.inertia_transverse.number;
  InertialParameters rotor{m, m * motor.position, steiner(m, motor.position)};
  for (std::size_t k = 0; k < 3; ++k) rotor.inertia[k][k] += k == 2 ? motor.inertia_axial.number : across;
  return rotor;
}

// The numbers of the file by the names of parameters.
std::map<std::string, Number> numbers_in_file(const Robot& robot) {
  static const char* const kNames[] = {"m", "mlx", "mly", "mlz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};
  std::map<std::string, Number> numbers;
  std::vector<InertialParameters> links(robot.links.size());
  for (std::size_t l = 0; l < links.size(); ++l) {
    for (const Inertial& inertial : robot.links[l].inertials) links[l] = links[l] + body_of(inertial);
  }
  for (const Joint& joint : robot.joints) {
    const auto name = [&joint](const char* kind) { return std::string(kind) + "(" + joint.name + ")"; };
    numbers[name("Fv")] = rationalised(joint.viscous.number);
    numbers[name("Fs")] = rationalised(joint.coulomb.number);
    numbers[name("Im")] = rationalised(joint.armature.number);
    if (!joint.motor) continue;
    numbers[name("Im")] = joint.motor->inertia_axial.number;
    const int carrier = joint.motor->carrier >= 0 ? joint.motor->carrier : joint.parent;
    links[static_cast<std::size_t>(carrier)] = links[static_cast<std::size_t>(carrier)] + rotor_of(*joint.motor);
  }
  for (std::size_t l = 0; l < links.size(); ++l) {
    const std::vector<Number> entries = entries_of(links[l]);
    for (std::size_t k = 0; k < entries.size(); ++k) {
      numbers[std::string(kNames[k]) + "(" + robot.links[l].name + ")"] = entries[k];
    }
  }
  return numbers;
}

// The exact number of a printed coefficient: "0.425", "-1/3".
Number number_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return exact_decimal(text);
  return exact_decimal(text.substr(0, slash)) / exact_decimal(text.substr(slash + 1));
}

// The difference that a rotation by pi/4 may make, whose sine and cosine have been made rational.
Number without_residue(const Number& difference) { return snap_residue_to_zero(difference, 1); }
Number as_it_is(const Number& difference) { return difference; }

// Expects that the printed combinations of `model` give the base parameters' values with the file's numbers.
void expect_values(const LoadedRobot& model, ParameterSet set, Number (*counted)(const Number&) = as_it_is) {
  const std::map<std::string, Number> numbers = numbers_in_file(model.robot);
  const std::vector<Number> values = base_values(model.mechanism, base_parameters(model.mechanism, set));
  const auto json = base_json(model.mechanism, set, ParameterFrames::file).at("base_parameters");
  ASSERT_EQ(json.size(), values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    Number sum = 0;
    for (const auto& [name, coefficient] : json[k].at("file_coefficients").items()) {
      ASSERT_TRUE(numbers.contains(name)) << name;
      sum += number_of(coefficient) * numbers.at(name);
    }
    EXPECT_TRUE(vanishes(counted(sum - values[k]))) << json[k] << " " << nearest_double(sum - values[k]);
  }
}

class CombinationsInFile : public ::testing::TestWithParam<std::string> {};

TEST_P(CombinationsInFile, GiveTheValuesExactly) {
  for (const ParameterSet set : kSets) expect_values(model_of(GetParam()), set);
}

INSTANTIATE_TEST_SUITE_P(Robots, CombinationsInFile,
                         ::testing::Values("ur5.urdf", "puma560.toml", "quadruped12.urdf", "humanoid32.urdf",
                                           "planar_2r_example_7_2.toml", "finger.toml", "slider_crank.toml"),
                         testing::name_of_text<std::string>);

// The hand is fixed to the last link, turned by pi/4.
TEST(CombinationsOfFile, GiveThePandasValues) {
  for (const ParameterSet set : kSets) expect_values(model_of("panda.urdf"), set, without_residue);
}

// Masses and a moment of inertia that are not those of the file: the combinations hold for any.
TEST(CombinationsOfFile, HoldForOtherNumbers) {
  std::string text = testing::text_of_robot("quadruped12.urdf");
  const auto replace_all = [&text](const std::string& from, const std::string& to) {
    ASSERT_THAT(text, ::testing::HasSubstr(from));
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
      text.replace(at, from.size(), to);
    }
  };
  replace_all("<mass value=\"0.00693606\"/>", "<mass value=\"0.25\"/>");
  replace_all("<mass value=\"0.03070001\"/>", "<mass value=\"1.75\"/>");
  replace_all("iyz=\"0.00000305\"", "iyz=\"0.02\"");
  const Mechanism as_given = model_of("quadruped12.urdf").mechanism;
  const Mechanism changed = testing::model_of_urdf(text).mechanism;
  const BaseParameters base = base_parameters(as_given);
  const std::vector<FileParameter> as_parameters = file_parameters(as_given, ParameterSet::given),
                                   numbers = file_parameters(changed, ParameterSet::given);
  const std::vector<Number> values = base_values(changed, base);
  for (std::size_t k = 0; k < values.size(); ++k) {
    Number sum = 0;
    for (const auto& [f, coefficient] : in_file_parameters(base.combination[k], as_parameters)) {
      sum += coefficient * numbers[static_cast<std::size_t>(f)].value;
    }
    EXPECT_TRUE(vanishes(sum - values[k])) << k;
  }
}

// The foot is fixed to the lower leg, (0, 0.008, -0.16) from it; the knee turns about y.
TEST(CombinationsOfFile, HaveLinksThatAreFixedToOthers) {
  const Mechanism mechanism = model_of("quadruped12.urdf").mechanism;
  const BaseParameters base = base_parameters(mechanism, ParameterSet::inertial);
  const Combinations in_file(mechanism, base, ParameterFrames::file, ParameterSet::inertial);
  const auto row = std::find(base.columns.begin(), base.columns.end(), index_of(2, Parameter::Izz));
  ASSERT_NE(row, base.columns.end());
  EXPECT_EQ(in_file.text(static_cast<int>(row - base.columns.begin())),
            "Iyy(FL_LOWER_LEG) + 0.0256 m(FL_FOOT) - 0.32 mlz(FL_FOOT) + Iyy(FL_FOOT)");
}

TEST(FileParameters, AreCanonicalWhereLinkFramesAre) {
  EXPECT_TRUE(has_canonical_links(model_of("rx90.toml").mechanism));
  EXPECT_FALSE(has_canonical_links(model_of("ur5.urdf").mechanism));
  EXPECT_FALSE(has_canonical_links(model_of("planar_2r.toml").mechanism));  // standard DH
  const Mechanism mechanism = model_of("rx90.toml").mechanism;
  const std::vector<Number> pi = dynamic_parameters(mechanism);
  const std::vector<FileParameter> parameters = file_parameters(mechanism, ParameterSet::full);
  ASSERT_EQ(parameters.size(), pi.size());
  for (std::size_t k = 0; k < pi.size(); ++k) {
    EXPECT_EQ(parameters[k].name, parameter_name(static_cast<int>(k)));
    EXPECT_TRUE(vanishes(parameters[k].value - pi[k]));
  }
}

TEST(FileParameters, LeaveOutLinksWithoutMassThatAreFixedToOthers) {
  std::set<std::string> names;
  for (const FileParameter& parameter : file_parameters(model_of("panda.urdf").mechanism, ParameterSet::inertial)) {
    names.insert(parameter.name);
  }
  EXPECT_TRUE(names.contains("Ixy(panda_leftfinger)"));
  EXPECT_FALSE(names.contains("m(panda_hand_tcp)"));
  EXPECT_EQ(names.size(), 100u);  // seven links, the hand, two fingers
}

}  // namespace
}  // namespace flatdyn
