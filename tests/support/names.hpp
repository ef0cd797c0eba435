// SPDX-License-Identifier: GPL-2.0-or-later
// Readable names of the parameters of parameterised tests.
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <string>

namespace flatdyn::testing {

// The parameter, a file's name or another short text, with letters and digits only: "panda_urdf".
template <class Text>
std::string name_of_text(const ::testing::TestParamInfo<Text>& test) {
  std::string name(test.param);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

}  // namespace flatdyn::testing
