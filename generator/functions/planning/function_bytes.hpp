// SPDX-License-Identifier: GPL-2.0-or-later
// Functions as bytes, to send them from one process to another.
#pragma once

#include <string>

#include "functions/planning/optimised_function.hpp"

namespace flatdyn {

// All of the function but the record of a search.
std::string to_bytes(const OptimisedFunction& made);

// The function with these bytes: with the same nodes, by the same numbers. Throws an exception of nlohmann's library or
// std::runtime_error for bytes that to_bytes() has not made.
OptimisedFunction from_bytes(const std::string& bytes);

}  // namespace flatdyn
