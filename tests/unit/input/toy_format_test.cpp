// SPDX-License-Identifier: GPL-2.0-or-later
// A fifth format, as docs/how-to-add.md says: rows, and a mapping to links and joints. All else is there.
#include <gmock/gmock.h>

#include "robot/input/common/poses.hpp"
#include "robot/input/common/robot_builder.hpp"
#include "robot/input/common/unknown_names.hpp"
#include "robot/input/common/values.hpp"
#include "robot/input/common/xml_document.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

const XmlForm kToyForm = {".toy", "a toy file is <toy name=\"...\"> ... </toy>"};

// ---- its rows

const Schema& toy_schema() {
  static const Schema kSchema = {{"toy", {"name"}, {"segment"}},
                                 {"segment", {"name on joint axis limits mass length", "colour"}}};
  return kSchema;
}

// ---- its mapping

// <segment name on joint axis limits mass length>: a rod along x on another segment, or on the world.
class ToyReader {
 public:
  ToyReader(ReadContext& context, Robot& robot) : context_(context), builder_(context, robot) {}

  void read(const FileNode& segment) {
    const std::string what = name_in_messages(segment);
    const int link = builder_.add_link({segment.value("name"), {rod(segment, what)}, segment.place});
    Joint joint = RobotBuilder::new_joint(segment.value("joint"), segment.place);
    joint.parent = segment.has("on") ? builder_.link({segment.value("on"), segment.place}, what + ", on")
                                     : builder_.world(segment.place);
    joint.child = link;
    joint.axis = vector_in(text(segment, "axis", what), context_.diagnostics).value_or(joint.axis);
    builder_.set_type(JointType::revolute, joint);
    builder_.add_joint(joint);
  }

 private:
  static FileText text(const FileNode& segment, const char* key, const std::string& what) {
    return {segment.value(key), {segment.place, what + ", " + key}};
  }

  Inertial rod(const FileNode& segment, const std::string& what) {
    const Value mass = value_in(text(segment, "mass", what), context_.diagnostics);
    const Number length = value_in(text(segment, "length", what), context_.diagnostics).number;
    const Number across = mass.number * length * length / 12;
    Inertial inertial;
    inertial.place = segment.place;
    inertial.mass = mass;
    inertial.frame = pose_from_xyz_rpy({length / 2, 0, 0}, zero_vector(), segment.place);
    inertial.tensor = {Vec3{0, 0, 0}, Vec3{0, across, 0}, Vec3{0, 0, across}};
    return inertial;
  }

  ReadContext& context_;
  RobotBuilder builder_;
};

void read_toy(const std::string& text, const std::string& file, ReadContext& context, Robot& robot) {
  const std::optional<XmlDocument> document = parse_xml(text, file, kToyForm, context.diagnostics);
  if (!document || refuse_content_beside(*document, kToyForm, context.diagnostics)) return;
  UnknownNames(toy_schema(), {"toy", "docs/robot-format/toy.md"}, context.diagnostics).check(document->root, "toy");
  robot.name = document->root.value("name");
  ToyReader reader(context, robot);
  for (const FileNode* segment : document->root.elements("segment")) reader.read(*segment);
}

class ToyFormat : public ::testing::Test {
 protected:
  Robot read(const std::string& text) {
    const ReadOptions options;
    ReadContext context{options, found_, SymbolTable(), {}, 0, {}, {}};
    Robot robot;
    read_toy(text, "arm.toy", context, robot);
    return robot;
  }

  std::string messages() const {
    std::string text;
    for (const Diagnostic& each : found_.all()) text += to_string(each) + "\n";
    return text;
  }

  Diagnostics found_;
};

TEST_F(ToyFormat, BecomesARobot) {
  const Robot robot = read(
      "<toy name='arm'><segment name='upper' joint='shoulder' axis='0 1 0' mass='2' length='0.6'/>"
      "<segment name='lower' on='upper' joint='elbow' axis='0 1 0' mass='1' length='0.5'/></toy>");
  EXPECT_EQ(messages(), "");
  ASSERT_EQ(robot.joints.size(), 2u);
  EXPECT_EQ(robot.links.size(), 3u);
  EXPECT_EQ(robot.joints[1].type, JointType::revolute);
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.joints[1].parent)].name, "upper");
  EXPECT_TRUE(robot.links[0].inertials[0].tensor[1][1].is_equal(exact_decimal("0.06")));
}

TEST_F(ToyFormat, HasMessagesWithoutALineForThem) {
  read(
      "<toy><segment name='upper' joint='j' axes='0 1' mass='2k' length='1' on='wall'/>\n<weight/><spring "
      "k='1'/></toy>");
  for (const char* message :
       {"arm.toy:1: error: segment \"upper\": unknown attribute \"axes\"\n    hint: did you mean \"axis\"?",
        "segment \"upper\", mass: \"2k\" is not a number", "segment \"upper\", axis: 3 numbers are expected",
        "segment \"upper\", on: there is no link \"wall\"",
        "arm.toy:2: note: toy: unknown element <weight>: not read, here and elsewhere"}) {
    EXPECT_THAT(messages(), HasSubstr(message));
  }
}

}  // namespace
}  // namespace flatdyn
