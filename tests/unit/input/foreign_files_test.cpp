// SPDX-License-Identifier: GPL-2.0-or-later
// Files that are no robot's, or not there: each is named as what it is.
#include <gmock/gmock.h>

#include "robot/input/csv/text.hpp"
#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kPointer = "version https://git-lfs.github.com/spec/v1\noid sha256:abc\nsize 12\n";
const std::string kIsPointer = "this is a pointer of Git LFS, not the file itself";

class ForeignFiles : public RobotFiles {
 protected:
  // The messages about a file that is refused.
  std::string refusal(const std::string& name, const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_robot(write(name, text), {}, diagnostics).has_value()) << name;
    std::string all;
    for (const Diagnostic& each : diagnostics.all()) all += to_string(each) + "\n";
    return all;
  }
};

TEST_F(ForeignFiles, ThatGitLfsHasNotFetchedAreNamedInEveryKindOfRobotFile) {
  for (const char* name : {"r.urdf", "r.sdf", "r.xml", "r.toml", "r.dae"}) {
    EXPECT_THAT(refusal(name, kPointer),
                AllOf(HasSubstr(std::string(name) + ":1: error: " + kIsPointer), HasSubstr("git lfs pull")))
        << name;
  }
}

TEST_F(ForeignFiles, ThatGitLfsHasNotFetchedAreNamedWhereAnotherFileNamesThem) {
  write("part.xml", kPointer);
  write("part.stl", kPointer);
  write("part.sdf", kPointer);
  write("part.urdf", kPointer);
  EXPECT_THAT(refusal("a.xml", R"(<mujoco><include file="part.xml"/></mujoco>)"),
              HasSubstr("part.xml:1: error: " + kIsPointer));
  EXPECT_THAT(refusal("b.xml", R"(<mujoco><asset><mesh name="m" file="part.stl"/></asset><worldbody><body><joint/>)"
                               R"(<geom type="mesh" mesh="m"/></body></worldbody></mujoco>)"),
              HasSubstr("part.stl:1: error: " + kIsPointer));
  EXPECT_THAT(
      refusal("c.sdf", R"(<sdf version="1.9"><world name="w"><include><uri>part.sdf</uri></include></world></sdf>)"),
      HasSubstr("part.sdf:1: error: " + kIsPointer));
  EXPECT_THAT(refusal("d.toml", "robot = \"part.urdf\"\n"), HasSubstr("part.urdf:1: error: " + kIsPointer));
}

TEST_F(ForeignFiles, ThatGitLfsHasNotFetchedAreNamedAmongTables) {
  Diagnostics diagnostics;
  EXPECT_FALSE(is_csv_heading("version https://git-lfs.github.com/spec/v1", {"log.csv", 1}, diagnostics));
  EXPECT_THAT(to_string(diagnostics.all().at(0)), HasSubstr("log.csv:1: error: " + kIsPointer));
}

TEST_F(ForeignFiles, ThatAreMeshesAreNamedAsThat) {
  EXPECT_THAT(refusal("arm.dae", "<COLLADA/>"), HasSubstr("arm.dae: error: this is a Collada file: a mesh"));
  EXPECT_THAT(refusal("arm.STL", "solid arm"), HasSubstr("arm.STL: error: this is a mesh or a drawing"));
  EXPECT_THAT(refusal("arm.urdf", "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4\"/>"),
              HasSubstr("arm.urdf:2: error: this is a Collada file: a mesh"));
  write("arm.obj", "v 0 0 0");
  EXPECT_THAT(refusal("r.toml", "robot = \"arm.obj\"\n"),
              HasSubstr("r.toml:1: error: robot: \"arm.obj\": this is a mesh or a drawing"));
  EXPECT_THAT(refusal("r.xml", "<launch/>"), HasSubstr("r.xml:1: error: this is a launch file of ROS"));
}

TEST_F(ForeignFiles, ThatAnSdfIncludesAreSaidWithTheirPlaces) {
  const std::string world =
      "<sdf version=\"1.9\"><world name=\"w\">\n<include><uri>model://sun</uri></include>\n"
      "<model name=\"a\"><link name=\"l\"/></model></world></sdf>";
  const std::string here = (folder_ / "models").string(), above = (folder_.parent_path() / "sun").string();
  EXPECT_THAT(refusal("w.sdf", world),
              AllOf(HasSubstr("w.sdf:2: error: include: \"model://sun\" is not found: looked for " +
                              (folder_ / "sun").string() + ", " + above + ", " + here + "/sun"),
                    HasSubstr("this file itself has the model \"a\""), HasSubstr("--model NAME")));
}

TEST_F(ForeignFiles, ThatHaveABodyAloneNameTheFloatingBase) {
  EXPECT_THAT(refusal("drone.urdf", R"(<robot name="d"><link name="b"><inertial><mass value="1"/>)"
                                    R"(<inertia ixx="1" iyy="1" izz="1"/></inertial></link></robot>)"),
              AllOf(HasSubstr("no joint of this robot moves"), HasSubstr("--base floating")));
}

}  // namespace
}  // namespace flatdyn
