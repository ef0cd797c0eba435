// SPDX-License-Identifier: GPL-2.0-or-later
// The proofs of emitted functions as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verify/proof.hpp"

namespace flatdyn {

// "proven: 13 functions are what the Lagrangian says …", with the largest of the error probabilities. `constants`: how
// the constants of the text are rounded.
std::string describe_proofs(const std::vector<Proof>& proofs, const std::string& constants);
nlohmann::ordered_json proofs_json(const std::vector<Proof>& proofs);

}  // namespace flatdyn
