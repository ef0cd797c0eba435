// SPDX-License-Identifier: GPL-2.0-or-later
// What was proven of emitted functions, as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verify/proof.hpp"

namespace flatdyn {

// "proven: 13 functions are what the Lagrangian says ...", with the least certain of the probabilities. `constants`:
// what those of the text are rounded to.
std::string describe_proofs(const std::vector<Proof>& proofs, const std::string& constants);
nlohmann::ordered_json proofs_json(const std::vector<Proof>& proofs);

}  // namespace flatdyn
