// SPDX-License-Identifier: GPL-2.0-or-later
// Changes of emitted text that its proof has to notice.
#pragma once

#include <string>
#include <vector>

namespace flatdyn::testing {

struct Mutant {
  const char* kind;
  const char* forms;        // "c++ pair": those of form_of() whose text is changed so
  const char *from, *to;    // the text at the first place, and what replaces it
  const char* behind = "";  // the place is behind this text
  const char* robot = "arm";
  bool has_parts = false;  // whether functions have so few lines that they are written in parts
};

inline bool is_in(const Mutant& mutant, const std::string& form) {
  return (" " + std::string(mutant.forms) + " ").find(" " + form + " ") != std::string::npos;
}

// All of them.
std::vector<Mutant> mutants();

// Those of C++, C, JavaScript, of C over states and of Rust alone.
std::vector<Mutant> mutants_in_cpp();
std::vector<Mutant> mutants_in_c();
std::vector<Mutant> mutants_in_javascript();
std::vector<Mutant> mutants_over_states();
std::vector<Mutant> mutants_in_rust();

}  // namespace flatdyn::testing
