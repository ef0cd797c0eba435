// SPDX-License-Identifier: GPL-2.0-or-later
// The context in the header that the text of a function depends on.
#pragma once

#include "code/emit/dialect.hpp"
#include "code/lower/scope.hpp"

namespace flatdyn {

struct HeaderScope : Scope {
  explicit HeaderScope(const Dialect& in) : dialect(in) { language = in.traits(); }

  const Dialect& dialect;
};

}  // namespace flatdyn
