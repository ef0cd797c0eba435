// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/sines.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "proof/certify/gappa.hpp"

namespace flatdyn {
namespace {

constexpr double kSecondsOfSines = 120;

TEST(ScriptsOfSines, AreProvenByGappa) {
  ASSERT_TRUE(has_gappa()) << "scripts/setup installs it";
  for (const char* scalar : {"double", "float"}) {
    const std::vector<GappaScript> scripts = scripts_of_sines(scalar);
    EXPECT_EQ(scripts.size(), 4u);
    const std::vector<Verdict> verdicts = run_gappa(scripts, kSecondsOfSines);
    for (std::size_t k = 0; k < scripts.size(); ++k) {
      EXPECT_EQ(verdicts[k], Verdict::proven) << scripts[k].name << " of " << scalar;
    }
  }
}

// Parts of pi/2 with a digit too many, a remainder in place of the missing part, a product with another sign.
TEST(ScriptsOfSines, AreRefusedWithASlip) {
  const std::pair<const char*, const char*> slips[] = {{"P1 = 0x1.921fb544p+0", "P1 = 0x1.921fb54442p+0"},
                                                       {"leading * missing", "leading * r"},
                                                       {"lost + product", "lost - product"}};
  std::vector<GappaScript> scripts = scripts_of_sines("double");
  for (std::size_t k = 0; k < std::size(slips); ++k) {
    const std::size_t at = scripts[k].text.find(slips[k].first);
    ASSERT_NE(at, std::string::npos) << slips[k].first;
    scripts[k].text.replace(at, std::string(slips[k].first).size(), slips[k].second);
  }
  scripts.pop_back();
  for (const Verdict verdict : run_gappa(scripts, kSecondsOfSines)) EXPECT_EQ(verdict, Verdict::refused);
}

}  // namespace
}  // namespace flatdyn
