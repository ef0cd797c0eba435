// SPDX-License-Identifier: GPL-2.0-or-later
// Families of robots that are hard on numbers: the errors as one quantity goes to an extreme.
#pragma once

#include <string>
#include <vector>

#include "laboratory/stress/stress.hpp"

namespace flatdyn {

struct FamilyMember {
  std::string label;     // "up, 1e9"
  double parameter = 0;  // the quantity that goes to the extreme, > 0
  Robot robot;
};

struct FamilySize {
  int robots = 20;  // at most
  int joints = 4;   // joints of each robot; ignored for chains, approximate for trees
  unsigned seed = 1;
};

// The name and the description of a family, for the help.
struct FamilyEntry {
  const char* name;
  const char* meaning;
  std::vector<FamilyMember> (*members)(const FamilySize&);
};
const std::vector<FamilyEntry>& family_table();

struct FamilyOptions {
  std::string family;
  int robots = 20, joints = 4;  // see FamilySize; the seed is that of `stress`
  std::vector<std::string> functions = {"inverse_dynamics", "inertia_matrix", "forward_dynamics"};
  StressOptions stress;
};

struct FamilyRow {
  std::string label;
  double parameter = 0;
  int joints = 0;
  StressRow found;
};

struct FamilyReport {
  std::string family;
  StressOptions options;
  std::vector<FamilyRow> rows;
  std::vector<std::string> left_out;  // functions that a member cannot have, with the reason
  bool passed() const;
};

// Stresses a family of robots. Throws Failure(usage) for an unknown family.
FamilyReport stress_family(const FamilyOptions& options, Progress& progress);

}  // namespace flatdyn
