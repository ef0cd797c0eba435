// SPDX-License-Identifier: GPL-2.0-or-later
// Lengths, masses and centres of mass are those of the file, whatever the canonical frames are.
#include "report/links_in_file.hpp"

#include <gmock/gmock.h>

#include "robot/model/physical_inertia.hpp"
#include "support/robot_models.hpp"
#include "support/written_model.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using testing::model_of;
using testing::model_of_toml;

TEST(LinksInFile, AreThoseOfThePandasFile) {
  const LoadedRobot model = model_of("panda.urdf");
  const std::vector<LinkInFile> links = links_in_file(model);
  ASSERT_EQ(links.size(), model.mechanism.bodies.size());
  for (const LinkInFile& link : links) {
    const std::string& name = model.mechanism.bodies[static_cast<std::size_t>(link.body)].link;
    for (const Link& written : model.robot.links) {
      if (written.name != name || !link.with.empty()) continue;
      const Inertial& inertial = written.inertials.at(0);
      EXPECT_TRUE(vanishes(link.inertia.mass - inertial.mass.number)) << name;
      const Vec3 com = centre_of_mass(link.inertia);
      const Vec3& in_file = inertial.frame.displacements.at(0).translation;
      for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(vanishes(com[k] - in_file[k])) << name << " " << k;
    }
  }
  EXPECT_NEAR(links[1].length.value(), 0.316, 1e-12);
  EXPECT_NEAR(links[2].length.value(), 0.0825, 1e-12);
}

// Standard DH: the link's frame is at its far end, and the joint is at -a.
constexpr const char* kArm = R"(dh = "standard"
[[link]]
joint = "first"
a = 0.4
theta = "pi/2"
mass = 2
com = [-0.1, 0, 0]
[[link]]
joint = "second"
a = 0.3
alpha = 0.2
d = 0.4
mass = 1
com = [0, 0.05, 0]
[[link]]
joint = "slide"
type = "prismatic"
mass = 0.5
limits = { lower = -0.1, upper = 0.25 }
[[link]]
joint = "flange"
type = "fixed"
d = 0.2
mass = 0.5
)";

TEST(LinksInFile, HaveLengthsThatAddUpToTheReach) {
  const LoadedRobot model = model_of_toml(kArm);
  const std::vector<LinkInFile> links = links_in_file(model);
  ASSERT_EQ(links.size(), 3U);
  EXPECT_NEAR(links[0].length.value(), 0.4, 1e-12);
  EXPECT_NEAR(links[1].length.value(), 0.5, 1e-12);
  EXPECT_NEAR(links[2].length.value(), 0.2, 1e-12);  // to the tip, on a link that is fixed to it
  EXPECT_THAT(links[2].with, ::testing::ElementsAre("link4"));
  EXPECT_TRUE(vanishes(centre_of_mass(links[0].inertia)[0] + Number(1) / 10));
  const Reach reach = reach_of(model).value();
  EXPECT_EQ(reach.first_joint, "first");
  EXPECT_NEAR(reach.links, 0.4 + 0.5 + 0.25 + 0.2, 1e-12);
  EXPECT_THAT(reach.without, ::testing::IsEmpty());
}

TEST(LinksInFile, SayWhatAPersonChecksFirst) {
  const std::string text = describe_links(model_of_toml(kArm));
  EXPECT_THAT(text, HasSubstr("total mass 4 kg\ntip link4: at ("));
  EXPECT_THAT(text, HasSubstr(") m at q = 0, within 1.35 m of joint first\n"));
  EXPECT_THAT(text, HasSubstr("link 1 (link1), moved by first, 0.4 m long\n  m = 2 kg, com = (-0.1, 0, 0) m\n"));
  EXPECT_THAT(text, HasSubstr("link 3 (link3), moved by slide, 0.2 m long, with link4\n"));
}

TEST(LinksInFile, OfARobotWithSymbolsAreInSymbols) {
  const LoadedRobot model = model_of("planar_2r.toml");
  EXPECT_FALSE(reach_of(model));
  const std::string text = describe_links(model);
  EXPECT_THAT(text, HasSubstr("m r = ("));
  const nlohmann::ordered_json json = links_json(model);
  EXPECT_FALSE(json.contains("reach"));
  EXPECT_TRUE(json["links"][0]["mass"].is_string());
  EXPECT_FALSE(json["links"][0].contains("com"));
}

TEST(LinksInFile, AreInJson) {
  const nlohmann::ordered_json json = links_json(model_of_toml(kArm));
  EXPECT_EQ(json["mass"], 4);
  EXPECT_NEAR(json["reach"]["at_most"].get<double>(), 1.35, 1e-12);
  EXPECT_EQ(json["tip_at_zero"].size(), 3U);
  EXPECT_EQ(json["links"][1]["com"], nlohmann::ordered_json({0.0, 0.05, 0.0}));
  EXPECT_EQ(json["links"][1]["joint"], "second");
}

}  // namespace
}  // namespace flatdyn
