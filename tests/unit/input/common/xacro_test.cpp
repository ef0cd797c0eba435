// SPDX-License-Identifier: GPL-2.0-or-later
// Templates, by a program called xacro that stands in for the one of ROS.
#include "robot/input/common/xacro.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"
#include "robot/input/common/content_hash.hpp"
#include "robot/input/common/xml_document.hpp"
#include "robot/input/reader.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kExpanded =
    "<robot name='arm'><link name='base'/><link name='upper'><inertial><mass value='2'/>\n"
    "<inertia ixx='1' iyy='1' izz='1'/></inertial></link>\n"
    "<joint name='a' type='continuous'><parent link='base'/><child link='upper'/></joint></robot>\n";

class Xacro : public ::testing::Test {
 protected:
  void SetUp() override { write_file(folder_.path() / "arm.urdf.xacro", "<robot/>"); }
  void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }

  // `script`: what the program does. Its arguments are kept in the file "arguments".
  void install(const std::string& script) {
    const fs::path program = folder_.path() / "xacro";
    write_file(program, "#!/bin/sh\necho \"$@\" >> '" + (folder_.path() / "arguments").string() + "'\n" + script);
    fs::permissions(program, fs::perms::owner_all);
    ::setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  std::string template_file() const { return (folder_.path() / "arm.urdf.xacro").string(); }
  std::optional<Robot> read(const ReadOptions& options) {
    diagnostics_ = {};
    return read_robot(template_file(), options, diagnostics_);
  }

  TemporaryFolder folder_;
  std::string path_ = std::getenv("PATH");
  Diagnostics diagnostics_;
};

TEST_F(Xacro, ExpandsATemplateOnceWithItsArguments) {
  write_file(folder_.path() / "expanded", kExpanded);
  install("cat '" + (folder_.path() / "expanded").string() + "'\n");
  ReadOptions options;
  options.sources = std::make_shared<Sources>(std::vector<std::string>{"length:=0.5", "name:=it's"});
  for (int time = 0; time < 2; ++time) {
    const std::optional<Robot> robot = read(options);
    ASSERT_TRUE(robot);
    EXPECT_EQ(robot->name, "arm");
    EXPECT_EQ(robot->links[1].place.file, template_file() + " (expanded)");
    EXPECT_EQ(options.sources->hash(robot->files), content_hash({kExpanded}));
  }
  EXPECT_EQ(content_of_file(folder_.path() / "arguments"), template_file() + " length:=0.5 name:=it's\n");
}

TEST_F(Xacro, TellsItsOwnMessage) {
  install("echo 'undefined: mass' >&2\necho 'in arm.urdf.xacro' >&2\nexit 2\n");
  EXPECT_FALSE(read({}));
  ASSERT_EQ(diagnostics_.all().size(), 1U);
  EXPECT_EQ(diagnostics_.all()[0].message, "xacro does not expand it:\n    undefined: mass\n    in arm.urdf.xacro");
}

TEST_F(Xacro, SaysHowToGetItWhereItIsNot) {
  ::setenv("PATH", folder_.path().c_str(), 1);
  try {
    read({});
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::io);
    EXPECT_THAT(failure.hint(), HasSubstr("pip install xacro"));
    EXPECT_THAT(failure.hint(), HasSubstr("xacro arm.urdf.xacro > robot.urdf"));
  }
}

TEST_F(Xacro, ArgumentsWithoutATemplateAreRefused) {
  write_file(folder_.path() / "arm.urdf", kExpanded);
  ReadOptions options;
  options.sources = std::make_shared<Sources>(std::vector<std::string>{"length:=0.5"});
  EXPECT_THROW(read_robot(folder_.path() / "arm.urdf", options, diagnostics_), Failure);
}

// The message of the first and only error, or nothing.
std::string refused(const std::string& elements) {
  Diagnostics found;
  const std::optional<XmlDocument> document = parse_xml("<robot>\n" + elements + "\n</robot>", "f", {}, found);
  if (document) refuse_template(document->root, found);
  return found.all().empty() ? "" : to_string(found.all()[0]).substr(0, to_string(found.all()[0]).find('\n'));
}

TEST(Template, IsAnErrorAtAnyDepthAndWithoutPrefix) {
  EXPECT_EQ(refused("<link name='a'>\n<xacro:rod mass='3'/></link><xacro:b/>"),
            "f:3: error: <xacro:rod>: this is a xacro template, not a URDF (2 places in all)");
  for (const char* element :
       {"<joint><xacro:insert_block name='origin'/></joint>", "<gazebo><xacro:a/></gazebo>",
        "<macro name='leg' params='side'/>", "<property name='mass' value='3'/>", "<include filename='$(find a)/b'/>",
        "<link><inertial><property name='a' value='1'/></inertial></link>", "<link name='${side}_leg'/>",
        "<joint><parent link='$(arg prefix)base'/></joint>"}) {
    EXPECT_THAT(refused(element), HasSubstr("f:2: error: ")) << element;
  }
}

TEST(Template, ElementsOfOthersMayHaveTheSameNames) {
  for (const char* element :
       {"<gazebo><plugin><include filename='a'/><property name='b'/></plugin></gazebo>", "<link name='a$b'/>",
        "<transmission name='t'><property name='a'/></transmission>", "<link><include/></link>",
        "<link><visual><geometry><mesh filename='$(find a)/b'/></geometry></visual></link>"}) {
    EXPECT_EQ(refused(element), "") << element;
  }
}

}  // namespace
}  // namespace flatdyn
