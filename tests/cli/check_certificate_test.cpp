// SPDX-License-Identifier: GPL-2.0-or-later
// `scripts/check-certificate`: certificates of `flatdyn certify` that hold, and others with one change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

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

  // Writes other text in the header behind its functions, and the header's new hash into the certificate.
  void rewrite_header(const std::string& before, const std::string& after,
                      const char* from = "The numbers of a state") {
    std::string text = scratch_.read(kHeader);
    const std::size_t at = text.find(before, text.find(from));
    ASSERT_NE(at, std::string::npos) << before;
    scratch_.write(kHeader, text.replace(at, before.size(), after));
    const std::string sum = fmt::format("sha1sum '{}' > '{}'", scratch_.path(kHeader), scratch_.path("sum"));
    ASSERT_EQ(std::system(sum.c_str()), 0);
    change([&](json& certificate, json&) { certificate["hash"] = "sha1:" + scratch_.read("sum").substr(0, 40); });
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
  for (const char* options : {"--scalar double", "--scalar float", "--fma", "--fma --scalar float"}) {
    certify(options);
    EXPECT_EQ(check(), 0) << scratch_.read("seen");
    EXPECT_THAT(scratch_.read("seen"), HasSubstr("inverse_dynamics: ")) << options;
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
  replace(kHeader, "+ N_2_z +", "+ N_2_z * tau[1] +");
  expect(1, "nothing is called 'tau_2'");
}

TEST_F(CheckCertificate, RefutesSinesOfTheHeaderThatAreNotThoseThatAreProven) {
  const std::string proofs = std::filesystem::path(script_file("")).parent_path() / "sines.";
  constexpr const char* kSines = "Angles in the lanes";
  rewrite_header("2.75573137070700676789e-06", "2.75573137070700776789e-06", kSines);
  expect(1, "sines.sine.g is about another polynomial p than the header's");
  rewrite_header("leading * rest", "leading * r", kSines);
  expect(1, "a sine of ");
  rewrite_header("(quadrant & 2u) << 62", "(quadrant & 2u) << 61", kSines);
  expect(1, "the header's own sines are not those that flatdyn writes");
  rewrite_header("class SinCos = DefaultSinCos", "class SinCos = LibrarySinCos", kSines);
  expect(1, "a function of the header has another default source of sines");
  rewrite_header("sin_cos(q, ", "sin_cos(qd, ", kSines);
  expect(1, "asks for other sines and cosines than it uses");
  replace(proofs + "sine.g", "|M - S| <= 8e-18", "|M - S| <= 2e-18");
  expect(1, "sines.sine.g takes 2e-18 for an error of ");
  replace(proofs + "cosine.g", "|rest| <= 1.9e-16", "|rest| <= 1e-16");
  expect(1, "the scripts about sines differ in how large the rest of an angle is");
  replace(proofs + "reduction.g", "0x1.0b4611a6p-34", "0x1.0b4611a7p-34");
  expect(1, "sines.reduction.g is not about the header's rest at ");
}

TEST_F(CheckCertificate, RefutesFusedMultiplyAddsThatAreOthersThanWritten) {
  certify("--fma");
  rewrite_header("return std::fma(a, b, c);", "return a * b + c;", "MultiplyAdd<double>");
  expect(1, "the header's fused multiply-adds are not those that flatdyn writes");
  certify("--fma");
  rewrite_header("fma(-c_2, domega_2_z, ", "(-c_2 * domega_2_z + ", "void inverse_dynamics(");
  expect(1, "of the header is another number than that of the scripts");
}

TEST_F(CheckCertificate, RefutesAnAnswerAboutRoundingThatIsNotTheRightOne) {
  constexpr const char *kOther = "rounding_is_as_written() is not the one that flatdyn writes",
                       *kVerdict = "return hash ==";
  rewrite_header(kVerdict, "return hash !=");
  expect(1, kOther);
  rewrite_header(kVerdict, "hash = 1; return hash ==");
  expect(1, kOther);
  rewrite_header("if (!detail::sines_are_right<Scalar>()) return false;", "");
  expect(1, kOther);
  rewrite_header("hash ^= hash >> 32;", "hash = 0;");
  expect(1, kOther);
  rewrite_header("}  // namespace planar_2r",
                 "template <> bool rounding_is_as_written<double>() { return true; }\n} //");
  expect(1, kOther);
  rewrite_header("is_float ? 0x", "is_float ? 0xf");
  expect(1, "rounding_is_as_written() expects other results than those of the header's functions");
}

}  // namespace
}  // namespace flatdyn::testing
