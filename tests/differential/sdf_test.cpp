// SPDX-License-Identifier: GPL-2.0-or-later
// SDF files as flatdyn reads them against libsdformat's reading of the same: its poses, axes and inertias, put into the
// numeric reference. libsdformat rounds to double; Drake's rotors, which it does not know, are left out on both sides.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ignition/math/Pose3.hh>
#include <map>
#include <sdf/sdf.hh>

#include "flatdyn/reference/newton_euler.hpp"
#include "robot/input/reader.hpp"
#include "robot/model/coupling.hpp"
#include "truth/reference/reference_model.hpp"
#include "unit/input/sdf/sdf_text.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;
namespace ref = reference;

using Pose = ignition::math::Pose3d;
using Numbers = ref::VectorX<double>;

ref::Matrix3<double> rotation_of(const Pose& pose) {
  const ignition::math::Matrix3d R(pose.Rot());
  ref::Matrix3<double> result;
  for (unsigned i = 0; i < 3; ++i) {
    for (unsigned j = 0; j < 3; ++j) result(i, j) = R(i, j);
  }
  return result;
}

ref::Vector3<double> vector_from(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

// All errors of libsdformat end the test.
void require_none(const sdf::Errors& errors) {
  for (const sdf::Error& error : errors) throw std::runtime_error(error.Message());
}

// The model as libsdformat reads it. Its joints are in the order of `names`, which is flatdyn's order of q.
class SdfWitness {
 public:
  SdfWitness(const fs::path& file, const std::vector<std::string>& names) {
    sdf::ParserConfig config;
    require_none(root_.Load(file.string(), config));
    model_ = root_.Model() != nullptr ? root_.Model() : root_.WorldByIndex(0)->ModelByIndex(0);
    robot_.links.emplace_back();  // the world
    add_links(*model_, "");
    add_joints(*model_, "");
    fix_base();
    order(names);
  }

  ref::Robot<double> robot(const ref::Vector3<double>& gravity) const {
    ref::Robot<double> robot = robot_;
    robot.gravity = gravity;
    robot.tip = static_cast<int>(robot.links.size()) - 1;
    return robot;
  }

 private:
  // In the frame of the outermost model.
  static Pose resolved(const sdf::SemanticPose& semantic, const std::string& to) {
    Pose pose;
    require_none(semantic.Resolve(pose, to));
    return pose;
  }

  void add_links(const sdf::Model& model, const std::string& prefix) {
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
      const sdf::Link& link = *model.LinkByIndex(i);
      const auto inertial = link.Inertial();
      ref::Inertial<double> body;
      const ref::Matrix3<double> R = rotation_of(inertial.Pose());
      const ignition::math::Matrix3d moi = inertial.MassMatrix().Moi();
      ref::Matrix3<double> tensor;
      for (unsigned a = 0; a < 3; ++a) {
        for (unsigned b = 0; b < 3; ++b) tensor(a, b) = moi(a, b);
      }
      body.mass = inertial.MassMatrix().Mass();
      body.r_C = vector_from(inertial.Pose().Pos());
      body.inertia = R * tensor * R.transpose();
      link_of_name_[prefix + link.Name()] = static_cast<int>(robot_.links.size());
      links_.push_back(&link);
      poses_.push_back(pose_of_model(prefix) * resolved(link.SemanticPose(), "__model__"));
      robot_.links.push_back({{body}});
    }
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      const sdf::Model& inner = *model.ModelByIndex(i);
      models_[prefix + inner.Name() + "::"] = pose_of_model(prefix) * resolved(inner.SemanticPose(), "__model__");
      add_links(inner, prefix + inner.Name() + "::");
    }
  }

  Pose pose_of_model(const std::string& prefix) const {
    const auto found = models_.find(prefix);
    return found == models_.end() ? Pose::Zero : found->second;
  }

  Pose pose_of_link(int link) const { return link == 0 ? Pose::Zero : poses_[static_cast<std::size_t>(link) - 1]; }

  void add_joints(const sdf::Model& model, const std::string& prefix) {
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) add_joint(*model.JointByIndex(i), prefix);
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
      add_joints(*model.ModelByIndex(i), prefix + model.ModelByIndex(i)->Name() + "::");
    }
  }

  void add_joint(const sdf::Joint& sdf_joint, const std::string& prefix) {
    std::string parent, child;
    require_none(sdf_joint.ResolveParentLink(parent));
    require_none(sdf_joint.ResolveChildLink(child));
    const int p = parent == "world" ? 0 : link_of_name_.at(prefix + parent), c = link_of_name_.at(prefix + child);
    const Pose joint_in_world = pose_of_model(prefix) * resolved(sdf_joint.SemanticPose(), "__model__");
    const std::string name = prefix + sdf_joint.Name();
    const bool has_two = sdf_joint.Type() == sdf::JointType::UNIVERSAL || sdf_joint.Type() == sdf::JointType::REVOLUTE2;
    const Pose before = pose_of_link(p).Inverse() * joint_in_world, after = joint_in_world.Inverse() * pose_of_link(c);
    if (!has_two) return add_joint(sdf_joint, 0, name, p, c, before, after);
    const int between = static_cast<int>(robot_.links.size());
    robot_.links.emplace_back();
    poses_.push_back(joint_in_world);
    add_joint(sdf_joint, 0, name + ".axis", p, between, before, Pose::Zero);
    add_joint(sdf_joint, 1, name + ".axis2", between, c, Pose::Zero, after);
  }

  void add_joint(const sdf::Joint& sdf_joint, unsigned axis, const std::string& name, int parent, int child,
                 const Pose& before, const Pose& after) {
    ref::Joint<double> joint;
    joint.parent = parent;
    joint.child = child;
    joint.R_0 = rotation_of(before);
    joint.p_0 = vector_from(before.Pos());
    joint.R_1 = rotation_of(after);
    joint.p_1 = vector_from(after.Pos());
    if (sdf_joint.Type() != sdf::JointType::FIXED) {
      ignition::math::Vector3d xyz;
      require_none(sdf_joint.Axis(axis)->ResolveXyz(xyz));
      joint.type = sdf_joint.Type() == sdf::JointType::PRISMATIC ? ref::JointType::prismatic : ref::JointType::revolute;
      joint.axis = vector_from(xyz).normalized();
      joint.viscous = sdf_joint.Axis(axis)->Damping();
      joint.coulomb = sdf_joint.Axis(axis)->Friction();
    }
    robot_.joints.push_back(joint);
    names_.push_back(name);
  }

  // The link that no joint moves is fixed to the world where it is.
  void fix_base() {
    for (int link = 1; link < static_cast<int>(robot_.links.size()); ++link) {
      const bool is_moved = std::any_of(robot_.joints.begin(), robot_.joints.end(),
                                        [link](const ref::Joint<double>& joint) { return joint.child == link; });
      if (is_moved) continue;
      ref::Joint<double> joint;
      joint.child = link;
      joint.R_0 = rotation_of(pose_of_link(link));
      joint.p_0 = vector_from(pose_of_link(link).Pos());
      robot_.joints.push_back(joint);
      names_.emplace_back();
    }
  }

  // Joints come before those on their links, and have the numbers of `names`.
  void order(const std::vector<std::string>& names) {
    for (std::size_t j = 0; j < names_.size(); ++j) {
      const auto found = std::find(names.begin(), names.end(), names_[j]);
      const bool moves = robot_.joints[j].type != ref::JointType::fixed;
      if (moves && found == names.end()) throw std::runtime_error("flatdyn has no joint " + names_[j]);
      robot_.joints[j].index = moves ? static_cast<int>(found - names.begin()) : -1;
    }
    std::vector<ref::Joint<double>> sorted;
    std::vector<int> reached = {0};
    for (std::size_t k = 0; k < reached.size(); ++k) {
      for (const ref::Joint<double>& joint : robot_.joints) {
        if (joint.parent != reached[k]) continue;
        sorted.push_back(joint);
        reached.push_back(joint.child);
      }
    }
    robot_.joints = sorted;
  }

  sdf::Root root_;
  const sdf::Model* model_ = nullptr;
  ref::Robot<double> robot_;
  std::vector<const sdf::Link*> links_;
  std::vector<Pose> poses_;  // of links, in the model
  std::map<std::string, Pose> models_;
  std::map<std::string, int> link_of_name_;
  std::vector<std::string> names_;  // of joints
};

void expect_same(const Numbers& ours, const Numbers& theirs, const std::string& what) {
  ASSERT_EQ(ours.size(), theirs.size()) << what;
  const double scale = std::max(1e-9, theirs.cwiseAbs().maxCoeff());
  for (Eigen::Index i = 0; i < ours.size(); ++i) EXPECT_NEAR(ours[i] / scale, theirs[i] / scale, 1e-10) << what << i;
}

void compare(const fs::path& file) {
  ReadOptions options;
  options.snap_tolerance = 0;  // libsdformat snaps nothing
  Diagnostics diagnostics;
  std::optional<Robot> robot = read_robot(file, options, diagnostics);
  ASSERT_TRUE(robot.has_value()) << (diagnostics.all().empty() ? "" : to_string(diagnostics.all().back()));
  std::vector<std::string> names;
  for (const int j : moving_joints(*robot)) names.push_back(robot->joints[static_cast<std::size_t>(j)].name);
  for (Joint& joint : robot->joints) joint.armature.number = 0;
  ref::Robot<double> ours = reference_robot<double>(*robot, {});
  ref::Robot<double> theirs = SdfWitness(file, names).robot(ours.gravity);
  theirs.coupling = ours.coupling;
  const int n = ours.size();
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::srand(seed);
    const Numbers q = Numbers::Random(n), qd = Numbers::Random(n), qdd = Numbers::Random(n);
    expect_same(ref::inverse_dynamics<double>(ours, q, qd, qdd), ref::inverse_dynamics<double>(theirs, q, qd, qdd),
                "torque of joint ");
    const ref::MatrixX<double> B = ref::inertia_matrix<double>(ours, q), W = ref::inertia_matrix<double>(theirs, q);
    expect_same(B.reshaped(), W.reshaped(), "inertia matrix, entry ");
  }
}

class SdfFile : public ::testing::Test {
 protected:
  static fs::path write(const std::string& text) {
    const fs::path path = fs::temp_directory_path() / ("flatdyn-sdf-" + std::to_string(getpid()) + ".sdf");
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  static void compare_text(const std::string& text) {
    const fs::path path = write(text);
    compare(path);
    fs::remove(path);
  }
};

class SharedSdf : public ::testing::TestWithParam<std::string> {};

TEST_P(SharedSdf, IsReadAsLibsdformatReadsIt) {
  const fs::path file = fs::path(FLATDYN_SOURCE_DIR) / "../shared/robots/sdf" / GetParam();
  if (!fs::exists(file)) GTEST_SKIP() << "no such file beside the checkout: " << file;
  compare(file);
}

INSTANTIATE_TEST_SUITE_P(Files, SharedSdf,
                         ::testing::Values("allegro_left.sdf", "iiwa14_no_collision.sdf", "schunk_wsg_50.sdf"),
                         [](const auto& file) { return file.param.substr(0, file.param.find('.')); });

const char* const kBody = R"(<inertial><pose>0.1 0.2 0.3 0.4 0.5 0.6</pose><mass>2</mass>
  <inertia><ixx>0.3</ixx><ixy>0.01</ixy><ixz>0.02</ixz><iyy>0.2</iyy><iyz>0.03</iyz><izz>0.4</izz></inertia>
  </inertial>)";

std::string link_at(const std::string& name, const std::string& pose) {
  return "<link name=\"" + name + "\">" + pose + kBody + "</link>";
}

std::string joint_of(const std::string& name, const std::string& type, const std::string& parent,
                     const std::string& child, const std::string& elements) {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent>" + parent + "</parent><child>" + child +
         "</child>" + elements + "</joint>";
}

// A chain with turned links, joints away from them, and an axis written in the model.
std::string chain(const std::string& axis, const std::string& pose_of_joint) {
  return link_at("base", "<pose>0 0 1 0.1 0.2 0.3</pose>") + link_at("arm", "<pose>0.5 0.1 1 0.7 -0.2 0.3</pose>") +
         link_at("hand", "<pose>1 0.2 1.1 -0.4 0.9 2.3</pose>") +
         joint_of("j", "revolute", "base", "arm", pose_of_joint + "<axis>" + axis + "</axis>") +
         joint_of("k", "prismatic", "arm", "hand", pose_of_joint + "<axis><xyz>0.6 0 0.8</xyz></axis>");
}

TEST_F(SdfFile, HasTheSameJointFrames) {
  const std::string pose = "<pose>0.1 -0.2 0.3 0.2 0.4 -0.6</pose>";
  for (const char* version : {"1.5", "1.6", "1.7", "1.9"}) {
    compare_text(sdf_model(chain("<xyz>0.36 0.48 0.8</xyz>", pose), version));
  }
  const char* in_model = "<xyz>0.36 0.48 0.8</xyz><use_parent_model_frame>true</use_parent_model_frame>";
  compare_text(sdf_model(chain(in_model, pose), "1.6"));
  compare_text(sdf_model(chain("<xyz>0.36 0.48 0.8</xyz>", pose), "1.4"));
  compare_text(sdf_model(chain("<xyz expressed_in=\"hand\">0.36 0.48 0.8</xyz>", pose), "1.8"));
}

TEST_F(SdfFile, HasTheSamePosesRelativeToFrames) {
  compare_text(sdf_model(
      link_at("base", "") + "<frame name=\"f\" attached_to=\"base\"><pose>0.1 0.2 0.3 0.5 0.6 0.7</pose></frame>" +
      "<frame name=\"g\"><pose relative_to=\"f\" degrees=\"true\">0.1 0 0 10 20 35</pose></frame>" +
      link_at("arm", "<pose relative_to=\"j\">0 0.1 0 0 0 0.3</pose>") +
      joint_of("j", "revolute", "f", "arm", "<pose relative_to=\"g\">0 0 0.2 0.3 0 0</pose>" + kAxisZ)));
}

TEST_F(SdfFile, HasTheSameNestedModels) {
  compare_text(sdf_model(
      link_at("base", "") +
          "<model name=\"hand\" placement_frame=\"wrist\" canonical_link=\"finger\">"
          "<pose relative_to=\"base\">0.1 0.2 0.5 0.3 0.2 0.1</pose>" +
          link_at("palm", "<pose>0 0 0.2 0.1 0 0</pose>") + link_at("finger", "<pose>0 0.3 0.2 0 0.4 0</pose>") +
          "<frame name=\"wrist\" attached_to=\"palm\"><pose>0.1 0 -0.1 0 0 0.5</pose></frame>" +
          joint_of("bend", "revolute", "palm", "finger",
                   "<pose>0.05 0 0 0.2 0 0</pose><axis><xyz expressed_in=\"__model__\">0 0.6 0.8</xyz></axis>") +
          "</model>" + joint_of("turn", "revolute", "base", "hand::palm", kAxisZ),
      "1.8"));
}

TEST_F(SdfFile, HasTheSameUniversalJoint) {
  compare_text(sdf_model(link_at("base", "") + link_at("arm", "<pose>0.1 0.2 0.3 0.4 0.5 0.6</pose>") +
                         joint_of("j", "universal", "base", "arm",
                                  "<pose>0.1 0 0 0.3 0 0</pose><axis><xyz>1 0 0</xyz></axis>"
                                  "<axis2><xyz expressed_in=\"base\">0 1 0</xyz></axis2>")));
}

}  // namespace
}  // namespace flatdyn
