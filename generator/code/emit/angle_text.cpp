// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/angle_text.hpp"

#include <fmt/format.h>

#include "code/emit/printer.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/angles.hpp"
#include "derivation/notation/number_text.hpp"

namespace flatdyn {

std::string angles_definition(const HeaderScope& scope) {
  std::string text;
  for (const code::Part& part : parts_of_angles(scope.dialect.global(kFunctionOfAngles), scope)) {
    text += (text.empty() ? "" : "\n" + scope.dialect.before_part()) + Printer(scope).text(part);
  }
  return without_newline(text);
}

std::vector<std::string> angles_comment(const HeaderScope& scope) {
  std::string text = "Sines and cosines, by index, are those of so many angles: of q's entries, and then of ";
  for (std::size_t k = 0; k < scope.angles.size(); ++k) {
    const MultipleOfPosition& angle = scope.angles[k];
    text += fmt::format("{}{} q[{}]", k == 0 ? "" : ", ", exact_number_text(GiNaC::numeric(angle.factor.str().c_str())),
                        angle.position);
  }
  return wrapped_words(text + ", by which coupled joints turn.", kCommentWidth);
}

}  // namespace flatdyn
