// SPDX-License-Identifier: GPL-2.0-or-later
// The proofs of emitted functions as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "proof/verify/proof.hpp"

namespace flatdyn {

// "proven: 13 functions are what the Lagrangian says …", with the largest of the error probabilities. `constants`: how
// the constants of the text are rounded.
std::string describe_proofs(const std::vector<Proof>& proofs, const AsReadResult& as_read,
                            const std::string& constants);
nlohmann::ordered_json proofs_json(const std::vector<Proof>& proofs);

// "the robot as read, its 12 links and 7 rotors by themselves (1068 numbers)".
std::string describe_as_read(const AsReadResult& as_read);
nlohmann::ordered_json as_read_json(const AsReadResult& as_read);

}  // namespace flatdyn
