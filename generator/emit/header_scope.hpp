// SPDX-License-Identifier: GPL-2.0-or-later
// The context in the header that the text of a function depends on.
#pragma once

#include "emit/dialect.hpp"
#include "lower/scope.hpp"

namespace flatdyn {

struct HeaderScope : Scope {
  explicit HeaderScope(const Dialect& in) : dialect(in) { language = in.traits(); }

  const Dialect& dialect;
};

}  // namespace flatdyn
