// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cpp/pair.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"

namespace flatdyn {

std::vector<std::string> compiled_scalars(const EmitOptions& options) {
  std::vector<std::string> scalars = {options.scalar};
  for (const std::string& scalar : options.more_scalars) {
    if (scalar != "double" && scalar != "float") {
      throw Failure(FailureKind::usage, fmt::format("unknown scalar \"{}\"", scalar), "use double or float");
    }
    if (std::count(scalars.begin(), scalars.end(), scalar) > 0) {
      throw Failure(FailureKind::usage, fmt::format("scalar \"{}\" is named twice", scalar), "name it once");
    }
    scalars.push_back(scalar);
  }
  return scalars;
}

void write_pair(kainjow::mustache::data& page, const std::string& header, const std::string& source,
                const std::vector<std::string>& scalars) {
  page["pair?"] = true;
  page["header_file"] = header;
  page["source_file"] = comment_text(source);
  const std::string text = fmt::format(
      "Every function is a template over its scalar, defined in {} and compiled there for {}, with sines and cosines "
      "from DefaultSinCos or GivenSinCos: the list is at the end. Whatever else is called does not link. Arguments are "
      "plain arrays:",
      comment_text(source), fmt::join(scalars, " and "));
  page["compiled"] = fmt::format("// {}", fmt::join(wrapped_words(text, kCommentWidth), "\n// "));
}

namespace {

constexpr const char* kDeclares = "extern template ";
constexpr const char* kDefines = "template ";

void add_both(Instantiations& list, const std::string& begin, const std::vector<std::string>& parameters,
              const char* end) {
  list.declared.push_back(without_newline(list_line(kDeclares + begin, parameters, end, 0)));
  list.defined.push_back(without_newline(list_line(kDefines + begin, parameters, end, 0)));
}

}  // namespace

void Instantiations::add(const FunctionText& text) {
  for (const Instance& instance : text.compiled) {
    add_both(*this, fmt::format("{} {}(", instance.returns, text.name), instance.parameters, ");");
  }
}

void Instantiations::add(const std::vector<StageText>& stages, const std::vector<std::string>& scalars) {
  add(stages.front().make);
  for (const std::string& scalar : scalars) {
    for (const StageText& stage : stages) add_both(*this, fmt::format("struct {}<{}>", stage.name, scalar), {}, ";");
  }
}

void Instantiations::add_rounding(const std::vector<std::string>& scalars) {
  for (const std::string& scalar : scalars) {
    add_both(*this, fmt::format("bool rounding_is_as_written<{}>(", scalar), {}, ");");
  }
}

}  // namespace flatdyn
