// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/angle_text.hpp"

#include <fmt/format.h>

#include "emit/printer.hpp"
#include "emit/sections.hpp"
#include "emit/writer.hpp"
#include "lower/angles.hpp"
#include "symbolic/notation/number_text.hpp"

namespace flatdyn {
namespace {

std::string name_of_angles(const HeaderScope& scope) { return scope.dialect.global("angles"); }

}  // namespace

std::string angle_count_name(const HeaderScope& scope) {
  if (!scope.angles.empty()) return scope.dialect.count_name("angle_count");
  const int of_base = scope.floating_base ? 6 : 0;
  return scope.dialect.count_name(of_base + scope.positions == scope.joints ? "joint_count" : "position_count");
}

std::string angles_call(const HeaderScope& scope) {
  return Printer(scope).text({code::CallPart{name_of_angles(scope), arguments_of_angles()}});
}

std::string angles_definition(const HeaderScope& scope) {
  std::string text;
  for (const code::Part& part : parts_of_angles(name_of_angles(scope), scope)) {
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
