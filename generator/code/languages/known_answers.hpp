// SPDX-License-Identifier: GPL-2.0-or-later
// The hashes that rounding_is_as_written() compares with: of the results that the text has in arithmetic as it is
// written. The text is read back for that.
#pragma once

#include <string>
#include <vector>

#include "code/readback/emitted_text.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Fills the answers into texts that belong together, which the reader of their language reads.
void fill_in_known_answers(const Mechanism& mechanism, const std::vector<Function>& functions,
                           const AnyLanguageReader& language, std::vector<std::string>& texts);

}  // namespace flatdyn
