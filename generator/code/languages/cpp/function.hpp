// SPDX-License-Identifier: GPL-2.0-or-later
// The declaration of a function template: its parameters, and what it is compiled for.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "code/emit/function_text.hpp"

namespace flatdyn {

// Completes the text of a function template. `compiled`: the scalars that a source is compiled for; the template is
// then declared in a header and defined in that source.
void declare_template(FunctionText& text, const UndeclaredFunction& function, const std::vector<std::string>& compiled);

inline bool is_declared_apart(const FunctionText& text) { return !text.declared.empty(); }

// "[[nodiscard]] " where a function returns whether its results mean something.
std::string not_to_discard(const std::string& returns);

// A declaration, of a template of Of..., that is found where objects such as std::vector stand in place of arrays, and
// has a message. `scope`: of the header that has the message, "::panda::"; empty within it.
std::string refusal_of_objects(const std::string& name, const std::string& scope = "");

// Fills in the template's head, its body's parts, and, if it is declared apart, its declaration and the template
// parameters of its definition. `stage`: the stage that it is a member of, if any.
void write_template(kainjow::mustache::data& item, const FunctionText& text, const std::string& stage = "");

}  // namespace flatdyn
