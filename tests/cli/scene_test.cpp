// SPDX-License-Identifier: GPL-2.0-or-later
// --scene, and --gravity and --fix, which override it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kPayload =
    "[payload]\nmass = 1.5\ncom = [0.01, 0, 0.06]\ninertia = { xx = 0.011, yy = 0.011, zz = 0.006, xy = 0.001 }\n"
    "inertia_about = \"com\"\n";

Outcome run_in_scene(const Scratch& scratch, const std::string& arguments, const std::string& scene) {
  scratch.write("scene.toml", scene);
  return run_flatdyn(arguments + " --scene " + scratch.path("scene.toml"));
}

struct SceneOfRobot {
  const char* robot;
  std::string scene;
};

class VerifiedScene : public ::testing::TestWithParam<SceneOfRobot> {};

TEST_P(VerifiedScene, IsExactlyTheLagrangianOfThatScene) {
  const Scratch scratch;
  const Outcome outcome =
      run_in_scene(scratch, fmt::format("verify -q --json --states 4 robots/{}", GetParam().robot), GetParam().scene);
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  for (const json& function : json::parse(outcome.out)["functions"]) {
    EXPECT_TRUE(function["proven"]) << function;
    EXPECT_LT(function["graph_error"], 1e-40) << function;
  }
}

// Each kind of key by itself on a robot with motors and friction, and all of them on other robots.
INSTANTIATE_TEST_SUITE_P(
    Keys, VerifiedScene,
    ::testing::Values(
        SceneOfRobot{"puma560.toml", "gravity = \"off\"\nfunctions = [\"inverse_dynamics\", \"gravity\"]\n"},
        SceneOfRobot{"puma560.toml", "gravity = [1, \"1/3\", -9.81]\nfunctions = [\"inverse_dynamics\"]\n"},
        SceneOfRobot{"puma560.toml", "[locked]\nelbow = \"pi/6\"\nshoulder = 0.3\n"},
        SceneOfRobot{"puma560.toml", std::string("functions = [\"bias\", \"kinetic_energy\"]\n") + kPayload},
        SceneOfRobot{"puma560.toml", "static = true\n"},
        SceneOfRobot{"puma560.toml", "friction = false\nfunctions = [\"bias\", \"forward_dynamics\"]\n"},
        SceneOfRobot{"puma560.toml",
                     "[limits.waist]\nlower = -0.1\nupper = 0.1\nvelocity = 0.1\n[outputs]\n"
                     "inverse_dynamics = [\"tau[shoulder..elbow]\"]\nforward_dynamics = [\"qdd[1]\"]\n"
                     "christoffel = [\"c[0][1]\"]\nforward_kinematics = [\"p[2]\"]\n"
                     "jacobian = [\"J[0..2][elbow]\"]\nregressor = [\"Y[0]\"]\n"},
        SceneOfRobot{"panda.urdf", std::string("static = true\nfriction = false\ngravity = [0, 0.5, -9.7]\nfunctions = "
                                               "[\"inverse_dynamics\", \"forward_dynamics\", \"jacobian_dot_qd\"]\n"
                                               "[locked]\npanda_joint4 = -1.5\npanda_joint7 = \"pi/4\"\n[outputs]\n"
                                               "inverse_dynamics = [\"tau[0..2]\"]\n") +
                                       kPayload},
        SceneOfRobot{"ur5.urdf", std::string("friction = false\nfunctions = [\"inverse_dynamics\", \"base_regressor\", "
                                             "\"inverse_dynamics_base\"]\n[locked]\nelbow_joint = 1.25\n") +
                                     kPayload},
        SceneOfRobot{"scara.toml", std::string("static = true\nfunctions = [\"inverse_dynamics\", \"base_regressor\", "
                                               "\"adaptive_regressor\"]\n[locked]\nd_3 = 0.05\n")},
        SceneOfRobot{"puma560.toml",
                     "orientation = \"zyz\"\nfunctions = [\"operational_inertia\", "
                     "\"operational_bias\"]\n"},
        SceneOfRobot{"ur5.urdf",
                     "orientation = \"rpy\"\ntask = [\"y\", \"theta\", \"psi\"]\ndamping = 0.05\nfunctions = "
                     "[\"operational_inertia\", \"operational_bias\", \"null_space_torque\"]\n"},
        SceneOfRobot{"planar_2r.toml",
                     "[locked]\ntheta_2 = \"pi/3\"\n[payload]\nmass = \"m_p\"\ncom = [\"l_p\", 0, 0]\n"}),
    [](const auto& test) { return fmt::format("Scene{}", test.index); });

TEST(Scene, AHeaderCompilesWithoutAWarning) {
  const Scratch scratch;
  const Outcome outcome = run_in_scene(
      scratch, "generate -q robots/puma560.toml -o " + scratch.path(),
      "static = true\nfriction = false\n[locked]\nflange = 0.5\n[outputs]\ninverse_dynamics = [\"tau[0]\"]\n"
      "inertia_matrix = [\"B[1][2]\"]\nforward_kinematics = [\"p\"]\nkinetic_energy = [\"T\"]\n"
      "coriolis_matrix = [\"C[0]\"]\nforward_dynamics = [\"qdd[4]\"]\n");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string header = scratch.read("puma560.hpp");
  for (const char* text : {"// Scene: locked.flange = 0.5; static = true; friction = false; outputs.",
                           "held at 0.5 rad", "Friction is left out", "Written: tau[0], and nothing else of tau",
                           "Of R nothing is written", "/* R */", "const Scalar* /* qd */"}) {
    EXPECT_THAT(header, HasSubstr(text));
  }
  EXPECT_THAT(header + scratch.read("puma560.json"), Not(HasSubstr(scratch.path())));
  scratch.write(
      "use.cpp",
      "#include \"puma560.hpp\"\nint main() {\n  double q[5] = {}, qd[5] = {}, B[25], tau[5] = {1, 2, 3, 4, 5};\n"
      "  for (double& b : B) b = 7;\n  puma560::inertia_matrix(q, B);\n"
      "  puma560::inverse_dynamics(q, qd, qd, tau);\n  int written = 0;\n"
      "  for (double b : B) written += b != 7;\n"
      "  return written == 1 && B[7] != 7 && tau[1] == 2 && tau[4] == 5 ? 0 : 1;\n}\n");
  const std::string program = scratch.path("use");
  const std::string compile = fmt::format(
      "g++ -std=c++17 -O1 -Wall -Wextra -Wconversion -Wunused -Werror '{0}.cpp' -o '{0}' && '{0}'", program);
  EXPECT_EQ(std::system(compile.c_str()), 0);
}

constexpr const char* kTipInAngles = "orientation = \"zyz\"\ntask = [\"x\", \"theta\", \"psi\"]\ndamping = 0.01\n";

// Angles need a square root, which each language writes differently.
TEST(Scene, AnglesAndDampingAreTheSameInCAndSaidInTheHeader) {
  const Scratch scratch;
  const std::string generate =
      "generate -q robots/ur5.urdf --functions operational_inertia,operational_bias -o " + scratch.path();
  ASSERT_EQ(run_in_scene(scratch, generate, kTipInAngles).code, 0);
  ASSERT_EQ(run_in_scene(scratch, generate + " --language c", kTipInAngles).code, 0);
  std::string header = scratch.read("ur5.hpp");
  for (std::size_t at = 0; (at = header.find("\n// ", at)) != std::string::npos;) header.replace(at, 4, " ");
  for (const char* text :
       {"task = [x, theta, psi]; orientation = zyz; damping = 0.01", "of the task x, theta, psi",
        "R = R_z(phi) R_y(theta) R_z(psi), 0 < theta < pi", "analytical Jacobian",
        "lambda = 0.01, so that B_A is never larger than 1 / lambda^2",
        "a pivot of B or of J B^-1 J^T + lambda^2 1, or sin(theta), is not positive", "condition[1]"}) {
    EXPECT_THAT(header, HasSubstr(text));
  }
  const std::string use =
      "#include <stdio.h>\nint main(void) {\n  double q[6] = {0.3, -1, 0.7, 1.1, -0.4, 2}, qd[6] = {1, 2, -1, 0.5, 1, "
      "-2};\n"
      "  double B_A[9], J_bar[18], condition[1], c_A[3], g_A[3];\n  int k;\n"
      "  if (!ur5INERTIA(q, B_A, J_bar, condition) || !ur5BIAS(q, qd, c_A, g_A)) return 1;\n"
      "  for (k = 0; k < 9; ++k) printf(\"%a\\n\", B_A[k]);\n  for (k = 0; k < 18; ++k) printf(\"%a\\n\", J_bar[k]);\n"
      "  for (k = 0; k < 3; ++k) printf(\"%a %a\\n\", c_A[k], g_A[k]);\n  printf(\"%a\\n\", condition[0]);\n"
      "  return condition[0] > 0 && condition[0] < 1 ? 0 : 1;\n}\n";
  const auto with = [&use](const std::string& include, const std::string& separator) {
    std::string text = "#include \"" + include + "\"\n" + use;
    text.replace(text.find("ur5INERTIA"), 10, "ur5" + separator + "operational_inertia");
    text.replace(text.find("ur5BIAS"), 7, "ur5" + separator + "operational_bias");
    return text;
  };
  scratch.write("use.cpp", with("ur5.hpp", "::"));
  scratch.write("use.c", with("ur5.h", "_"));
  const std::string command = fmt::format(
      "cd '{}' && g++ -std=c++17 -O2 -ffp-contract=off -Wall -Wextra -Wconversion -Werror use.cpp -o use_cpp && "
      "gcc -std=c99 -O2 -ffp-contract=off -Wall -Wextra -Wconversion -Werror use.c ur5.c -lm -o use_c && "
      "./use_cpp > cpp.txt && ./use_c > c.txt",
      scratch.path());
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(scratch.read("cpp.txt"), scratch.read("c.txt"));
}

TEST(Scene, AnglesWithoutRatesAreRefused) {
  const Scratch scratch;
  const std::string verify = "verify -q robots/scara.toml --functions operational_inertia";
  const Outcome refused = run_in_scene(scratch, verify, "orientation = \"zyz\"\n");
  EXPECT_EQ(refused.code, 4);
  EXPECT_THAT(refused.err, HasSubstr("at every position of the robot the ZYZ angles are singular"));
  scratch.write("states.csv", "q1,q2,q3,q4\n0.1,0.5,0.1,0\n");
  const Outcome drawn = run_in_scene(
      scratch, "manipulability -q robots/scara.toml --states " + scratch.path("states.csv"), "orientation = \"rpy\"\n");
  EXPECT_EQ(drawn.code, 4);
  EXPECT_THAT(drawn.err, HasSubstr("the scene asks for Euler angles"));
}

TEST(Scene, TheHashIsOfItsBytesAndTheStampOfItsContent) {
  const Scratch scratch;
  const auto made = [&](const std::string& scene) {
    EXPECT_EQ(run_in_scene(scratch, "generate -q robots/scara.toml -o " + scratch.path(), scene).code, 0);
    return json::parse(scratch.read("scara.json"));
  };
  const json plain = made("functions = [\"gravity\"]\n"), commented = made("functions = [\"gravity\"] # all\n");
  EXPECT_NE(plain["input_hash"], commented["input_hash"]);
  EXPECT_EQ(plain["scene"], commented["scene"]);
  EXPECT_EQ(plain["scene"], json({"functions = [gravity]"}));
}

TEST(Scene, TheCommandLineGoesBeforeIt) {
  const Scratch scratch;
  const std::string scene = "gravity = [0, 0, 0]\nfunctions = [\"bias\"]\n[locked]\ntheta_1 = 1\n";
  const Outcome outcome = run_in_scene(scratch, "inspect robots/scara.toml --gravity 0,0,-5 --fix theta_1=pi/6", scene);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("gravity = [0, 0, -5]"));
  EXPECT_THAT(outcome.out, HasSubstr("locked.theta_1 = pi/6"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("locked.theta_1 = 1")));
  const Outcome verified = run_in_scene(scratch, "verify -q --states 4 robots/scara.toml --functions gravity", scene);
  EXPECT_THAT(verified.out, HasSubstr("gravity "));
  EXPECT_THAT(verified.out, Not(HasSubstr("bias")));
}

// The same joint at the same place, given in three ways.
TEST(Scene, FixIsLocked) {
  const Scratch scratch;
  const std::string arm = std::string("robot = \"" FLATDYN_SOURCE_DIR "/robots/scara.toml\"\n");
  scratch.write("scara.toml", arm + "fixed = { theta_2 = \"pi/6\" }\n");
  const auto body = [](const Outcome& outcome) {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out)["joints"];
  };
  const json locked = body(run_in_scene(scratch, "inspect --json robots/scara.toml", "[locked]\ntheta_2 = \"pi/6\"\n"));
  EXPECT_EQ(body(run_flatdyn("inspect --json robots/scara.toml --fix theta_2=pi/6")), locked);
  EXPECT_EQ(body(run_flatdyn("inspect --json " + scratch.path("scara.toml"))), locked);
  EXPECT_NE(body(run_flatdyn("inspect --json robots/scara.toml --fix theta_2")), locked);
}

// Positions and limits of a scene may be in degrees; a position may say so itself, as may --fix.
TEST(Scene, MayBeInDegrees) {
  const Scratch scratch;
  const std::string inspect = "inspect --json robots/scara.toml";
  const auto body = [](const Outcome& outcome) {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    json object = json::parse(outcome.out);
    object.erase("scene");
    object.erase("input_hash");
    return object.dump();
  };
  const std::string limits =
      "[limits.theta_1]\nlower = \"-pi/4\"\nupper = \"pi/4\"\nvelocity = \"pi\"\neffort = 5\n"
      "[limits.d_3]\nupper = 0.25\n";
  const std::string right = body(run_in_scene(scratch, inspect, "[locked]\ntheta_2 = \"pi/3\"\n" + limits));
  EXPECT_EQ(body(run_in_scene(scratch, inspect,
                              "angles = \"deg\"\n[locked]\ntheta_2 = 60\n[limits.theta_1]\nlower = -45\nupper = 45\n"
                              "velocity = 180\neffort = 5\n[limits.d_3]\nupper = 0.25\n")),
            right);
  EXPECT_EQ(body(run_in_scene(scratch, inspect, "[locked]\ntheta_2 = \"60 deg\"\n" + limits)), right);
  for (const char* option : {" --fix theta_2=60deg", " --fix 'theta_2=60 deg'", " --fix 'theta_2=120/2 deg'"}) {
    EXPECT_EQ(body(run_in_scene(scratch, inspect + option, limits)), right) << option;
  }
  EXPECT_THAT(run_flatdyn("inspect robots/scara.toml --fix d_3=5deg").err, HasSubstr("it slides"));
  EXPECT_THAT(
      run_in_scene(scratch, "inspect robots/scara.toml", "angles = \"deg\"\n[locked]\ntheta_2 = \"pi/3\"\n").err,
      HasSubstr("an expression with pi in a file in degrees"));
}

TEST(Scene, EvalComputesTheEntriesThatItAsksFor) {
  const Scratch scratch;
  scratch.write("states.csv", "q1,q2,qdd1,qdd2\n0.5,0.25,1,2\n");
  const std::string eval =
      "eval -q robots/planar_2r_example_7_2.toml --function inverse_dynamics --states " + scratch.path("states.csv");
  const std::string scene = "static = true\n[outputs]\ninverse_dynamics = [\"tau[theta_2]\"]\n";
  const Outcome graph = run_in_scene(scratch, eval + " --digits 30", scene);
  EXPECT_EQ(graph.code, 0) << graph.err;
  EXPECT_THAT(graph.out, HasSubstr("q1,q2,qdd1,qdd2,tau_2\n"));
  EXPECT_EQ(run_in_scene(scratch, eval + " --digits 30 --reference", scene).out, graph.out);
}

TEST(Scene, WrongOnesHaveTheirExitCodes) {
  const Scratch scratch;
  const std::string inspect = "inspect robots/scara.toml";
  EXPECT_EQ(run_flatdyn(inspect + " --scene " + scratch.path("none.toml")).code, 6);
  EXPECT_EQ(run_in_scene(scratch, inspect, "gravty = 0\n").code, 3);
  EXPECT_EQ(run_in_scene(scratch, inspect + " -Werror", "[locked]\ntheta_1 = 6\n").code,
            run_flatdyn(inspect + " -Werror").code);                                           // it has no limits
  EXPECT_EQ(run_in_scene(scratch, inspect + " -Werror", "[locked]\ntheta_1 = 90\n").code, 3);  // in degrees?
  const std::string regressor = "[outputs]\nbase_regressor = [\"Y_b[0]\"]\n";
  EXPECT_EQ(run_in_scene(scratch, "verify robots/scara.toml", regressor).code, 4);
  for (const char* fix : {"theta_1=", "theta_1=one", "theta_1=1 --fix theta_1=2", "nobody=1"}) {
    EXPECT_EQ(run_flatdyn(inspect + " --fix " + fix).code, 2) << fix;
  }
}

TEST(Scene, OtherSubcommandsSayWhatHasNoEffect) {
  const Scratch scratch;
  const Outcome derived = run_in_scene(scratch, "derive robots/planar_2r.toml", "static = true\n");
  EXPECT_EQ(derived.code, 0);
  EXPECT_THAT(derived.err, HasSubstr("static, error_budget, functions and outputs have no effect here"));
}

// The scene is part of the identified robot, so its file has to repeat it.
TEST(Scene, AnIdentifiedRobotRepeatsItOrIsRefused) {
  const Scratch scratch;
  const std::string identify = "identify robots/planar_2r_example_7_2.toml --data " + scratch.path("none.csv") +
                               " -o " + scratch.path("new.toml");
  const Outcome refused = run_in_scene(scratch, identify, "friction = false\n");
  EXPECT_EQ(refused.code, 4) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("cannot repeat"));
}

}  // namespace
}  // namespace flatdyn::testing
