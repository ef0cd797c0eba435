// SPDX-License-Identifier: GPL-2.0-or-later
// `scripts/check-certificate`: certificates of `flatdyn certify` that hold, and others with one change.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "cli/certificate_attacks.hpp"
#include "cli/program.hpp"

namespace flatdyn::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* kPlanarArm =
    "certify robots/planar_2r_example_7_2.toml --scene docs/examples/planar_2r_limits.toml ";

// A copy of a certificate of the planar arm, and the program that tries to refute it.
class CheckCertificate : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    has_mpmath_ = std::system("python3 -c 'import mpmath' > /dev/null 2>&1") == 0;
    original_ = std::make_unique<Scratch>();
    ASSERT_EQ(run_flatdyn(kPlanarArm + std::string(kFast) + original_->path()).code, 0);
  }
  static void TearDownTestSuite() { original_.reset(); }

  void SetUp() override {
    if (!has_mpmath_) GTEST_SKIP() << "no mpmath: scripts/setup";
    restore();
  }

  // Checks all that is expected by one run of the program, as half of its time is that of its start.
  void TearDown() override {
    if (expected_.empty()) return;
    int code = 0;
    std::string files;
    for (std::size_t k = 0; k < expected_.size(); ++k) {
      code = std::max(code, expected_[k].code);
      files += fmt::format(" {}", tampered_.path(fmt::format("{}/{}", k, kFile)));
    }
    EXPECT_EQ(run(files, 10), code);
    const std::string seen = scratch_.read("seen");
    for (std::size_t k = 0; k < expected_.size(); ++k) {
      const std::size_t begin = seen.find(tampered_.path(fmt::format("{}/", k)));
      ASSERT_NE(begin, std::string::npos);
      const std::size_t end = seen.find(tampered_.path(fmt::format("{}/", k + 1)));
      const std::string part = seen.substr(begin, end - begin);
      EXPECT_THAT(part, HasSubstr(expected_[k].message));
      EXPECT_THAT(part, HasSubstr(expected_[k].code == 1 ? "REFUTED: " : "check-certificate: "));
    }
  }

  void restore() {
    constexpr auto kOver = std::filesystem::copy_options::overwrite_existing | std::filesystem::copy_options::recursive;
    std::filesystem::copy(original_->path(), scratch_.path(), kOver);
  }

  void certify(const std::string& options, const std::string& robot = kPlanarArm) {
    ASSERT_EQ(run_flatdyn(robot + options + kFast + scratch_.path()).code, 0);
  }

  int run(const std::string& files, int states) {
    const std::string command = fmt::format("{}/scripts/check-certificate {} --states {} > {} 2>&1", FLATDYN_SOURCE_DIR,
                                            files, states, scratch_.path("seen"));
    return WEXITSTATUS(std::system(command.c_str()));
  }

  int check(int states = 300, const char* file = kFile) { return run(scratch_.path(file), states); }

  // Expects that the certificate is refuted (1), or that something is missing (2), with this message; then restores it.
  void expect(int code, const std::string& message) {
    const std::string folder = tampered_.path(std::to_string(expected_.size()));
    std::filesystem::copy(scratch_.path(), folder, std::filesystem::copy_options::recursive);
    expected_.push_back({code, message});
    restore();
  }

  // Writes other text in a script: "tau_1", "roundings_1".
  void edit(const std::string& script, const std::string& before, const std::string& after) {
    replace(script_file(script), before, after);
  }

  void replace(const std::string& file, const std::string& before, const std::string& after) {
    std::string text = scratch_.read(file);
    const std::size_t at = text.find(before);
    ASSERT_NE(at, std::string::npos) << before;
    scratch_.write(file, text.replace(at, before.size(), after));
  }

  // Writes other text in the header behind these words, and the header's new hash into the certificate.
  void rewrite_header(const std::string& before, const std::string& after,
                      const char* from = "The numbers of a state") {
    rewrite(kHeader, kFile, before, after, from);
  }

  void rewrite(const std::string& header, const std::string& certificate_file, const std::string& before,
               const std::string& after, const char* from = "") {
    std::string text = scratch_.read(header);
    const std::size_t at = text.find(before, text.find(from));
    ASSERT_NE(at, std::string::npos) << before;
    scratch_.write(header, text.replace(at, before.size(), after));
    const std::string sum = fmt::format("sha1sum '{}' > '{}'", scratch_.path(header), scratch_.path("sum"));
    ASSERT_EQ(std::system(sum.c_str()), 0);
    json certificate = json::parse(scratch_.read(certificate_file));
    certificate["hash"] = "sha1:" + scratch_.read("sum").substr(0, 40);
    scratch_.write(certificate_file, certificate.dump());
  }

  // A robot file of a kind; returns its path.
  std::string write_robot(const std::string& kind) {
    constexpr const char *kLimits = "limits = { velocity = 3, acceleration = 20 }\n",
                         *kMass =
                             "mass = 1\ncom = [0.1, 0, 0.2]\ninertia_about = \"com\"\n"
                             "inertia = { xx = 0.02, yy = 0.02, zz = 0.01 }\n";
    const auto link = [&](const std::string& joint, const std::string& type, const std::string& limits) {
      return fmt::format("[[link]]\njoint = \"{}\"\n{}{}{}", joint, type, kMass, limits);
    };
    const std::string ball = "type = \"spherical\"\n", slide = "type = \"prismatic\"\nviscous = 0.3\n";
    const std::string of_slide = "limits = { lower = -0.2, upper = 0.3, velocity = 3, acceleration = 20 }\n";
    std::string text = fmt::format("name = \"{}\"\n", kind);
    if (kind == "slide") text += link("slide", slide + "axis = [1, 0, 0]\n", of_slide);
    if (kind == "ball") text += link("ball", ball, kLimits);
    if (kind == "ball_and_slide") text += link("ball", ball, kLimits) + link("slide", slide, of_slide);
    if (kind == "hinge_and_balls") {
      text += link("hinge", "axis = [0, 1, 0]\n", "limits = { velocity = 30, acceleration = 20 }\n") +
              link("ball", ball, kLimits) + link("ball2", ball + "xyz = [0, 0, 0.3]\n", kLimits);
    }
    if (kind == "body") {
      text += fmt::format("[base]\nmotion = \"floating\"\n{}", kMass);
      scratch_.write("scene.toml",
                     "[base_limits]\nlinear_velocity = 2\nangular_velocity = 3\nlinear_acceleration = 10\n"
                     "angular_acceleration = 20\nforce = 100\nmoment = 200\n");
    }
    scratch_.write(kind + ".toml", text);
    return scratch_.path(kind + ".toml") + (kind == "body" ? " --scene " + scratch_.path("scene.toml") : "");
  }

  struct Kind {
    const char *robot, *options;  // a file, or a kind of write_robot()
  };

  void expect_nothing_refuted(const std::vector<Kind>& kinds) {
    std::string files;
    for (const Kind& kind : kinds) {
      const std::string robot = kind.robot, folder = scratch_.path(std::to_string(files.size()));
      const std::string file = robot.find('/') != std::string::npos ? robot : write_robot(robot);
      const Outcome outcome = run_flatdyn(fmt::format("certify {} {}{}{}", file, kind.options, kFast, folder));
      ASSERT_EQ(outcome.code, 0) << robot << ": " << outcome.err;
      const std::string stem = std::filesystem::path(robot.substr(0, robot.find(' '))).stem();
      files += fmt::format(" {}/{}.certificate.json", folder, stem);
    }
    EXPECT_EQ(run(files, 10), 0) << scratch_.read("seen");
  }

  // The certificate with this limit, "Real(3.0)", wherever its model has the one that was replaced.
  static std::string with_constants_of_header(json certificate, const std::string& limit) {
    const double number = std::stod(limit.substr(limit.find('(') + 1));
    const char* const table = number == 300 ? "velocity_limit" : number == 3 ? "position_upper" : "acceleration_limit";
    const std::size_t place = number == 300 ? 1 : number == 3 ? 3 : 0;
    certificate["constants"][table][place] = number;
    return certificate.dump();
  }

  // Changes the certificate. `change` gets the whole, and the function inverse_dynamics.
  template <class Change>
  void change(Change change) {
    json certificate = json::parse(scratch_.read(kFile));
    change(certificate, certificate["functions"][0]);
    scratch_.write(kFile, certificate.dump());
  }

  static std::string script_file(const std::string& script) {
    return "planar_2r_example_7_2.gappa/inverse_dynamics." + script + ".g";
  }

  // Makes the first bound that a script states smaller.
  void tighten(const std::string& script, const std::string& before) {
    std::string text = scratch_.read(script);
    const std::size_t at = text.find(" in [-", text.find(before)), end = text.find(',', at);
    ASSERT_NE(end, std::string::npos);
    const std::string bound = text.substr(at + 6, end - at - 6);
    for (std::size_t k = text.find(bound); k != std::string::npos; k = text.find(bound, k + 1)) {
      text.replace(k, bound.size(), std::string(bound.size(), '0').replace(1, 1, "."));
      text[k + bound.size() - 1] = '1';
    }
    scratch_.write(script, text);
  }

  static constexpr const char* kFile = "planar_2r_example_7_2.certificate.json";
  static constexpr const char* kHeader = "planar_2r_example_7_2.hpp";
  static constexpr const char* kFast = " -q --states 100 --time-limit 0 -o ";
  Scratch scratch_;

 private:
  struct Expected {
    int code;
    std::string message;
  };

  std::vector<Expected> expected_;
  Scratch tampered_;  // copies of what was expected to be refuted
  static inline std::unique_ptr<Scratch> original_;
  static inline bool has_mpmath_ = false;
};

TEST_F(CheckCertificate, RefutesNothingThatHolds) {
  for (const char* options :
       {"--scalar double", "--scalar float", "--fma", "--fma --scalar float", "--trigonometry-ulp 50",
        "--functions gravity,kinetic_energy,potential_energy,forward_kinematics,jacobian,jacobian_dot_qd,christoffel,"
        "coriolis_matrix,bias,base_regressor,base_parameters,regressor,inverse_dynamics_derivatives"}) {
    certify(options);
    EXPECT_EQ(check(60), 0) << scratch_.read("seen");
    EXPECT_THAT(scratch_.read("seen"), HasSubstr(" bounds, errors of up to ")) << options;
  }
}

// Every kind of robot that `certify` accepts, beside arms with hinges.
TEST_F(CheckCertificate, RefutesNothingOfAnyKindOfRobot) {
  expect_nothing_refuted({{"slide", ""},
                          {"slide", "--scalar float"},
                          {"ball", ""},
                          {"ball", "--fma --scalar float"},
                          {"ball_and_slide", ""},
                          {"ball_and_slide", "--functions gravity,coriolis_matrix,jacobian,kinetic_energy"},
                          {"hinge_and_balls", "--functions inverse_dynamics"},
                          {"body", ""}});
}

TEST_F(CheckCertificate, RefutesNothingOfLargerRobots) {
  expect_nothing_refuted({{"docs/examples/ball_wrist.toml --scene docs/examples/ball_wrist_limits.toml", ""},
                          {"robots/quadruped12.urdf --scene docs/examples/quadruped12_limits.toml",
                           "--base floating --functions gravity,bias"},
                          {"robots/puma560.toml --scene docs/examples/puma560_limits.toml", "--fma"},
                          {"hinge_and_balls", "--scalar float"}});
}

// A larger limit of a ball, and of a slide behind it, whose entries of v and of q are others than their joint's.
TEST_F(CheckCertificate, RefutesLargerLimitsOfJointsBehindBalls) {
  struct Edit {
    const char *robot, *before, *after, *message;
  };
  for (const Edit& edit :
       {Edit{"hinge_and_balls", "Real(3.0)", "Real(300.0)", "velocity_limit is [30.0, 300.0, 3.0, 3.0, "},
        Edit{"ball", "Real(20.0)", "Real(20.5)", "acceleration_limit is [20.5, 20.0, 20.0] in the header"},
        Edit{"ball_and_slide", "Real(0.3)", "Real(3.0)", "position_upper is [Infinity, Infinity, Infinity, 3.0]"}}) {
    const std::string robot = edit.robot, file = robot + ".certificate.json";
    const std::string certify = "certify " + write_robot(robot) + " --functions inverse_dynamics";
    ASSERT_EQ(run_flatdyn(certify + kFast + scratch_.path()).code, 0);
    rewrite(robot + ".hpp", file, edit.before, edit.after);
    EXPECT_EQ(check(5, file.c_str()), 1);
    EXPECT_THAT(scratch_.read("seen"), HasSubstr(edit.message));
    scratch_.write(file, with_constants_of_header(json::parse(scratch_.read(file)), edit.after));
    EXPECT_EQ(check(5, file.c_str()), 1);
    EXPECT_THAT(scratch_.read("seen"), HasSubstr("assumes a smaller limit of"));
  }
}

TEST_F(CheckCertificate, RefutesASizeADerivativeAndABoundThatAreTooSmall) {
  tighten(script_file("roundings_1"), "{");
  expect(1, "REFUTED: inverse_dynamics: the size of x");
  tighten(script_file("tau_0"), "/\\ a");
  expect(1, "REFUTED: inverse_dynamics: the derivative of tau[0]");
  change([](json&, json& function) { function["outputs"][0]["bound"] = 1e-20; });
  expect(1, "REFUTED: inverse_dynamics: the error of tau[0]");
}

TEST_F(CheckCertificate, RefutesADerivativeByAConstantThatIsTooSmall) {
  std::string constant, derivative;
  const json certificate = json::parse(scratch_.read(kFile));
  for (const json& leaf : certificate["functions"][0]["leaves"]) {
    if (leaf["name"].get<std::string>().front() != 'k') continue;
    constant = leaf["name"];
    derivative = fmt::format("/\\ a{} ", leaf["operation"].get<int>());
    if (scratch_.read(script_file("tau_0")).find(derivative) != std::string::npos) break;
  }
  tighten(script_file("tau_0"), derivative);
  expect(1, "REFUTED: inverse_dynamics: the derivative of tau[0] by " + constant);
}

TEST_F(CheckCertificate, RefutesErrorsThatAreSmallerThanTheOtherScriptsProve) {
  edit("tau_1", "r9 in [-1b-50, 1b-50]", "r9 in [-1b-51, 1b-51]");
  expect(1, "inverse_dynamics.tau_1.g assumes an error of x9 of 4.44089e-16, but it can be 8.88178e-16");
  edit("tau_1", "r4 in [-1b-53, 1b-53]", "r4 in [-1b-54, 1b-54]");
  expect(1, "inverse_dynamics.tau_1.g assumes an error of s_1 of 5.55112e-17, but it can be 1.11022e-16");
  tighten(script_file("tau_1"), "r8 in");
  expect(1, "inverse_dynamics.tau_1.g assumes an error of k8 of");
}

TEST_F(CheckCertificate, RefutesASumWithoutAnErrorOrWithOneTwice) {
  edit("tau_1", "\n  + a14 * r14", "");
  expect(1, "tau[1] depends on x14, whose error is missing in inverse_dynamics.tau_1.g");
  edit("tau_1", "+ a14 * r14", "+ a14 * r14\n  + a14 * r14");
  expect(1, "inverse_dynamics.tau_1.g counts the error of x14 more than once");
  edit("tau_1", "r4 * r4 + r5 * r5", "r4 * r4 + r4 * r5");
  expect(1, "is not a derivative times a length");
}

TEST_F(CheckCertificate, RefutesABoundThatItsScriptDoesNotProveAndAnErrorAboveIt) {
  change([](json&, json& function) { function["outputs"][1]["bound"] = 1.038e-12; });
  expect(1, "inverse_dynamics.tau_1.g has 1.039e-12 as bound of tau[1], the certificate has 1.038e-12");
  change([](json&, json& function) { function["outputs"][1]["seen"] = 1.04e-12; });
  expect(1, "an error of tau[1] was seen that is larger than its bound");
}

TEST_F(CheckCertificate, RefutesConstantsOfTheScriptsThatAreOthersThanTheHeaders) {
  edit("roundings_1", "k15 = rnd(22.5)", "k15 = rnd(22.25)");
  expect(1, "k15 is 22.25 in inverse_dynamics.roundings_1.g, but 22.5 in the certificate");
  const auto change_constant = [](json&, json& function) {
    for (json& leaf : function["leaves"]) {
      if (leaf["name"] == "k15") leaf.update({{"meaning", "22.25"}, {"exact", {"89/4"}}});
    }
  };
  edit("roundings_1", "k15 = rnd(22.5)", "k15 = rnd(22.25)");
  change(change_constant);
  expect(1, "tau[0] of the header is another number than that of the scripts");
}

TEST_F(CheckCertificate, RefutesOperationsOfTheScriptsThatAreOthersThanTheHeaders) {
  edit("roundings_1", "  x9 - x10 in", "  (k8 * s_1) - x10 in");  // rounded once instead of twice
  edit("roundings_1", "rnd(x9 - x10) - (x9 - x10)", "rnd((k8 * s_1) - x10) - ((k8 * s_1) - x10)");
  expect(1, "tau[0] of the header is another number than that of the scripts");
}

TEST_F(CheckCertificate, RefutesLimitsBelowThoseOfTheHeader) {
  change([](json&, json& function) { function["leaves"][0]["limit"] = 2.99; });
  expect(1, "the certificate assumes a smaller limit of qd_1 than the header states, 3");
}

TEST_F(CheckCertificate, RefutesTheTextOfAnotherHeader) {
  replace(kHeader, "Generated by", "Made by");
  expect(1, "planar_2r_example_7_2.hpp is not the header that was certified: its hash is sha1:");
}

TEST_F(CheckCertificate, RefutesSinesAndAScalarThatDoNotFit) {
  change([](json& certificate, json&) { certificate["trigonometry_ulp"] = 1000; });
  expect(1, "sines that are off by 1000 ulp are not off by 1.11022e-16");
  change([](json& certificate, json&) {
    certificate["trigonometry_ulp"] = 1024;
    certificate["trigonometry_error"] = 0x1p-43;
  });
  expect(1, "assumes an error of s_1 of 1.11022e-16, but it can be 1.13687e-13");
  change([](json& certificate, json&) { certificate["scalar"] = "float"; });
  expect(1, "inverse_dynamics.roundings_1.g is not about float");
}

TEST_F(CheckCertificate, RefutesNothingOfThePanda) {
  certify("", "certify robots/panda.urdf ");
  EXPECT_EQ(check(300, "panda.certificate.json"), 0) << scratch_.read("seen");
}

// Its last joint follows another one, so that its angle is computed, and rounded.
TEST_F(CheckCertificate, RefutesNothingOfAFingerButAnAngleWithoutError) {
  certify("", "certify robots/finger.toml ");
  EXPECT_EQ(check(50, "finger.certificate.json"), 0) << scratch_.read("seen");
  replace("finger.certificate.json", "sin(x10)", "s_4");
  EXPECT_EQ(check(10, "finger.certificate.json"), 1);
  EXPECT_THAT(scratch_.read("seen"), HasSubstr("the angle of s_4 of the header is another number"));
}

TEST_F(CheckCertificate, SaysWhichFileIsMissing) {
  for (const char* file : {kFile, kHeader}) {
    std::filesystem::remove(scratch_.path(file));
    expect(2, std::string(file) + "'");
  }
  std::filesystem::remove(scratch_.path(script_file("tau_1")));
  expect(2, "inverse_dynamics.tau_1.g is missing: tau[1] can have an error");
  scratch_.write(kFile, "{}");
  expect(2, "nothing is called 'header'");
}

TEST_F(CheckCertificate, RefutesWhatIsSilentOrContradictsItself) {
  change([](json&, json& function) { function["outputs"].erase(1); });
  expect(1, "inverse_dynamics has no bound of tau[1]");
  change([](json& certificate, json&) { certificate["functions"].clear(); });
  expect(1, "it says nothing of inertia_matrix, inverse_dynamics");
  scratch_.write(script_file("tau_1"), "{ a1 in [-1, 1] -> a1 in [-1, 1] }");
  expect(1, "a1 is not a derivative times errors");
  std::filesystem::remove(scratch_.path(script_file("roundings_1")));
  expect(1, "adds r9, of which no other script says anything");
  edit("tau_1", "a14 in ", "a99 in ");
  expect(1, "nothing is called 'a14'");
  change([](json&, json& function) {
    for (json& leaf : function["leaves"]) {
      if (leaf["name"] == "k15") leaf["exact"] = {"451/20"};
    }
  });
  expect(1, "k15 stands for 451/20, which is not 22.5");
}

TEST_F(CheckCertificate, RefutesScriptsThatAreNotAboutTheHeadersSines) {
  const std::string proofs = std::filesystem::path(script_file("")).parent_path() / "sines.";
  replace(proofs + "sine.g", "|M - S| <= 8e-18", "|M - S| <= 2e-18");
  expect(1, "sines.sine.g takes 2e-18 for an error of ");
  replace(proofs + "cosine.g", "|missing| <= 1.9e-16", "|missing| <= 1e-16");
  expect(1, "the scripts about sines differ in how large the missing part of an angle is");
  replace(proofs + "reduction.g", "0x1.0b4611a6p-34", "0x1.0b4611a7p-34");
  expect(1, "sines.reduction.g is not about the header's missing at ");
  replace(proofs + "sine.g", "2.75573137070700676789e-06", "2.75573137070700776789e-06");
  expect(1, "sines.sine.g is about another polynomial p than the header's");
}

TEST_F(CheckCertificate, RefutesTextAroundTheFunctionsThatFlatdynDoesNotWrite) {
  for (const Attack& attack : kAttacksAroundFunctions) {
    SCOPED_TRACE(attack.kind);
    rewrite_header(attack.before, attack.after, attack.behind);
    expect(1, attack.message);
  }
  const std::string text = scratch_.read(kHeader);
  rewrite_header(text.substr(text.size() - 40), text.substr(text.size() - 40) + "int behind;\n", "#endif  // FLATDYN");
  expect(1, "\"int\" behind the end");
}

TEST_F(CheckCertificate, RefutesFunctionsThatFlatdynDoesNotWrite) {
  for (const Attack& attack : kAttacksOnFunctions) {
    SCOPED_TRACE(attack.kind);
    rewrite_header(attack.before, attack.after, attack.behind);
    expect(1, attack.message);
  }
}

// Arrays of sines are those of angles, where joints are coupled; each angle is that of its joint.
TEST_F(CheckCertificate, RefutesAnglesOfOtherJoints) {
  const std::string certify = fmt::format("certify robots/finger.toml{}{}", kFast, scratch_.path());
  for (const auto& [before, after, message] :
       {std::tuple("angle[1] = q[1]", "angle[1] = q[0]", "the angle of c_2 of the header is another number"),
        std::tuple("angle[3] = Scalar(0.6666666666666666)", "angle[3] = Scalar(0.5)", "the angle of c_4 of the header"),
        std::tuple("  detail::angles(q, angle);", "", "sines and cosines that are asked for at another place"),
        std::tuple("angle[2] = q[2];", "", "an angle that is not computed")}) {
    ASSERT_EQ(run_flatdyn(certify).code, 0);
    rewrite("finger.hpp", "finger.certificate.json", before, after);
    EXPECT_EQ(check(5, "finger.certificate.json"), 1);
    EXPECT_THAT(scratch_.read("seen"), HasSubstr(message));
  }
}

TEST_F(CheckCertificate, RefutesFusedMultiplyAddsThatAreOthersThanWritten) {
  const auto attack = [this](const char* before, const char* after, const char* from, const char* message) {
    certify("--fma");
    rewrite_header(before, after, from);
    expect(1, message);
  };
  attack("return std::fma(a, b, c);", "return a * b + c;", "MultiplyAdd<double>", "\"std\" expected instead of \"a\"");
  attack("fma(-c_2, domega_2_z, ", "(-c_2 * domega_2_z + ", kFunction, kAnother);
  attack("constexpr detail::MultiplyAdd<Scalar> fma{};", "", kFunction, "nothing is called fma");
  attack("MultiplyAdd<Scalar> fma{};", "MultiplyAdd<float> fma{};", kFunction, "no statement that flatdyn writes");
}

// Whoever renews the answer of rounding_is_as_written(), too, still has other scripts.
TEST_F(CheckCertificate, RefutesAHeaderWhoseOwnHashesAreRenewed) {
  rewrite_header("qd_1 = qd[0]", "qd_1 = qd[1]", kFunction);
  const std::string program = fmt::format(
      "import pathlib, sys; sys.path.insert(0, '{}/scripts'); sys.dont_write_bytecode = True\n"
      "from certificate_check.header import Header\nfrom certificate_check.rounding import KnownState\n"
      "state = KnownState(Header(pathlib.Path('{}')))\n"
      "print('is_float ? 0x%016xu : 0x%016xu);' % (state.hash('float'), state.hash('double')))\n",
      FLATDYN_SOURCE_DIR, scratch_.path(kHeader));
  scratch_.write("renew.py", program);
  const std::string run = fmt::format("python3 '{}' > '{}'", scratch_.path("renew.py"), scratch_.path("renewed"));
  ASSERT_EQ(std::system(run.c_str()), 0);
  const std::string text = scratch_.read(kHeader);
  const std::size_t at = text.find("is_float ? 0x", text.find("return hash =="));
  const std::string before = text.substr(at, text.find('\n', at) - at), renewed = scratch_.read("renewed");
  rewrite_header(before, renewed.substr(0, renewed.size() - 1), "return hash ==");
  expect(1, kAnother);
}

}  // namespace
}  // namespace flatdyn::testing
