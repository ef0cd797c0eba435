// SPDX-License-Identifier: GPL-2.0-or-later
// The call of every function at the known state (code/emit/known_answer.hpp) in Rust, where arrays have known lengths.
#pragma once

#include <cstddef>
#include <string>

#include "code/emit/page_dialect.hpp"

namespace flatdyn {

// The statements that go on from `hash`. Empty: there are no functions.
std::string rust_known_answer(const CodeContent& content, std::size_t indent);

}  // namespace flatdyn
