// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/page_dialect.hpp"

namespace flatdyn {

std::string PageDialect::member(const std::string& name, const std::string& unit) const {
  return name + ";" + (unit.empty() ? "" : "  // " + unit);
}

}  // namespace flatdyn
