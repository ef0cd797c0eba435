// SPDX-License-Identifier: GPL-2.0-or-later
// Functions as text after each pass, for who works on passes.
#pragma once

#include <string>
#include <vector>

#include "pipeline/generation.hpp"

namespace flatdyn {

// Throws Failure(usage) unless each is the name of a pass, "derived" (before the first pass) or "all".
void check_pass_names(const std::vector<std::string>& names);

// Every function of the result after each of these passes, in every round of the table:
// "panda.gravity.1.share_sums.txt" is after share_sums in the first round. Functions are put through the passes again.
std::vector<GeneratedFile> pass_dump(const GenerationResult& result, const std::vector<std::string>& names);

}  // namespace flatdyn
