// SPDX-License-Identifier: GPL-2.0-or-later
// Inertia of meshes of MJCF files. tests/differential compares it with MuJoCo's.
#include <gmock/gmock.h>

#include <cstdint>

#include "unit/input/robot_file.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;

// A pyramid with the legs 1, 2 and 3 along the axes.
constexpr const char* kPyramid = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string with_mesh(const std::string& mesh, const std::string& geom = "") {
  return R"(<mujoco><asset><mesh name="m" )" + mesh + R"(/></asset><worldbody><body name="a"><joint/>)" +
         R"(<geom type="mesh" mesh="m" )" + geom + "/></body></worldbody></mujoco>";
}

class MjcfMeshInertia : public RobotFiles {
 protected:
  Inertial inertial(const std::string& mesh, const std::string& geom = "") {
    return read("r.xml", with_mesh(mesh, geom)).links.back().inertials.at(0);
  }

  std::string error_of(const std::string& mesh, const std::string& geom = "") {
    diagnostics_ = {};
    read_robot(write("r.xml", with_mesh(mesh, geom)), {}, diagnostics_);
    for (const Diagnostic& found : diagnostics_.all()) {
      if (found.severity == Severity::error) return to_string(found);
    }
    return "";
  }
};

// "mass at x y z: xx yy zz xy xz yz", exactly.
std::string exact_summary(const Inertial& inertial) {
  std::ostringstream text;
  text << inertial.mass.number << " at";
  for (const Number& each : inertial.frame.displacements.back().translation) text << " " << each;
  const Mat3& I = inertial.tensor;
  text << ": " << I[0][0] << " " << I[1][1] << " " << I[2][2] << " " << I[0][1] << " " << I[0][2] << " " << I[1][2];
  return text.str();
}

TEST_F(MjcfMeshInertia, AreExact) {
  write("p.obj", kPyramid);
  // With the mass m and the legs a, b, c: centre (a, b, c)/4, xx = 3 m (b² + c²)/80, xy = m a b/80.
  const char* wanted = "6 at 1/4 1/2 3/4: 117/40 9/4 9/8 3/20 9/40 9/20";
  for (const char* volume : {"", R"(inertia="exact")", R"(inertia="legacy")"}) {
    EXPECT_EQ(exact_summary(inertial(std::string(R"(file="p.obj" )") + volume, R"(mass="6")")), wanted) << volume;
  }
  EXPECT_EQ(exact_summary(inertial(R"(file="p.obj" scale="10 .1 1")", R"(density="6")")),
            "6 at 5/2 1/20 3/4: 1017/500 981/40 22509/1000 3/20 9/4 9/200");
}

TEST_F(MjcfMeshInertia, AreTheSameInAllForms) {
  const char* faces = R"(vertex="0 0 0  1 0 0  0 2 0  0 0 3" face="0 2 1  0 1 3  0 3 2  1 2 3")";
  const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  std::string ascii = "solid p\n", binary(80, ' ');
  const auto add = [&binary](const auto& value) {
    binary.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  add(std::uint32_t{4});
  for (const auto& face : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{1, 2, 3}}) {
    ascii += "facet normal 0 0 0\nouter loop\n";
    add(corners[0]);
    for (const int corner : face) {
      add(corners[corner]);
      ascii += "vertex " + std::to_string(corners[corner][0]) + " " + std::to_string(corners[corner][1]) + " " +
               std::to_string(corners[corner][2]) + "\r\n";
    }
    add(std::uint16_t{0});
    ascii += "endloop\nendfacet\n";
  }
  write("p.obj", kPyramid);
  write("ascii.stl", ascii + "endsolid p\n");
  write("binary.STL", binary);
  const std::string wanted = exact_summary(inertial(R"(file="p.obj")"));
  for (const char* mesh : {faces, R"(file="ascii.stl")", R"(file="binary.STL")"}) {
    EXPECT_EQ(exact_summary(inertial(mesh)), wanted) << mesh;
  }
}

// The pyramid with a dent in its large face, and with points inside, on faces and on edges that have no triangles.
TEST_F(MjcfMeshInertia, AreThoseOfTheConvexHull) {
  write("p.obj", kPyramid);
  const std::string wanted = exact_summary(inertial(R"(file="p.obj" inertia="exact")"));
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n";
  write("dented.obj", points + "v .1 .2 .3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 5\nf 3 4 5\nf 4 2 5\n");
  EXPECT_EQ(exact_summary(inertial(R"(file="dented.obj" inertia="convex")")), wanted);
  EXPECT_EQ(
      exact_summary(inertial(R"(vertex=".1 .1 .1 .5 0 0 0 0 1.5 .2 .2 0 0 0 0 1 0 0 .25 .5 1.5 0 2 0 .5 1 0 0 0 3")")),
      wanted);
  EXPECT_THAT(error_of(R"(vertex="0 0 0 1 0 0 0 1 0 1 1 0 3 7 0")"), HasSubstr("it encloses no volume"));
}

// Most of the points lie on faces and edges of a cube.
TEST_F(MjcfMeshInertia, AreThoseOfTheHullOfAGrid) {
  std::string grid;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) {
        grid += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + " ";
      }
    }
  }
  EXPECT_EQ(exact_summary(inertial("vertex=\"" + grid + "\" inertia=\"convex\"", R"(density="2")")),
            "54 at 3/2 3/2 3/2: 81 81 81 0 0 0");
}

TEST_F(MjcfMeshInertia, OfShellsAreThoseOfTheSurface) {
  // A hollow cube with the edge a: 5/18 m a².
  write("cube.obj",
        "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 3 3 0\nv 0 0 3\nv 3 0 3\nv 0 3 3\nv 3 3 3\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  EXPECT_EQ(exact_summary(inertial(R"(file="cube.obj" inertia="shell")", R"(density="1")")),
            "54 at 3/2 3/2 3/2: 135 135 135 0 0 0");
}

TEST_F(MjcfMeshInertia, NameTheBodyThatNeedsAnInertial) {
  const std::string message = error_of(R"(file="missing.stl")");
  EXPECT_THAT(message, HasSubstr("body \"a\", geom, mesh \"m\": there is no file"));
  EXPECT_THAT(message, HasSubstr("<inertial>"));
}

TEST_F(MjcfMeshInertia, AreRefusedWhereTheirInertiaIsAnother) {
  write("p.obj", kPyramid);
  EXPECT_THAT(error_of(R"(file="p.obj" inertia="convex" maxhullvert="9")"), HasSubstr("with maxhullvert"));
  EXPECT_THAT(error_of(R"(builtin="sphere")"), HasSubstr("a mesh by builtin is not supported"));
  EXPECT_THAT(error_of(R"(file="p.obj" refquat="1 1 0 0" scale="1 2 1")"), HasSubstr("differs by axis"));
  EXPECT_THAT(error_of(R"(file="p.dae")"), HasSubstr("there is no file"));
  write("p.dae", "");
  EXPECT_THAT(error_of(R"(file="p.dae")"), HasSubstr("other than .stl and .obj"));
}

TEST_F(MjcfMeshInertia, AreErrorsWhereTheyEncloseNothing) {
  const auto message = [this](const std::string& obj) {
    write("p.obj", obj);
    return error_of(R"(file="p.obj" inertia="exact")");
  };
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n";
  EXPECT_THAT(message(points + "f 1 2 3\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"), HasSubstr("do not turn the same way"));
  EXPECT_THAT(message(points + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n"), HasSubstr("its volume is negative"));
  EXPECT_THAT(message(points + "f 1 2 3\nf 1 3 2\n"), HasSubstr("it encloses no volume"));
  EXPECT_THAT(message(points + "f 1 2 9\n"), HasSubstr("p.obj:5: error: body \"a\", geom, mesh \"m\": \"9\" is no"));
  EXPECT_THAT(message("v 0 0 zero\n"), HasSubstr("p.obj:1"));
  EXPECT_THAT(message(points + "f 1 2 3 4 1\n"), HasSubstr("other than three or four corners"));
  EXPECT_THAT(message(points + "f 1 2 3\no b\nf 1 2 3\n"), HasSubstr("several objects"));
}

}  // namespace
}  // namespace flatdyn
