// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/c_section.hpp"

#include <fmt/format.h>

#include "emit/page.hpp"
#include "emit/sections.hpp"
#include "emit/writer.hpp"

namespace flatdyn {

using kainjow::mustache::data;

namespace {

// The definitions: if the function has a variant that takes sines and cosines, it comes before the one that calls it.
std::string definitions(const FunctionText& text, const std::string& linkage) {
  const auto definition = [&](const std::string& name, const std::vector<std::string>& parameters,
                              const std::string& body) {
    return c_signature(linkage + text.returns, name, parameters, " {") + "\n" + body + "}";
  };
  const std::string own = definition(text.name, text.parameters, text.body);
  return text.given ? definition(text.given->name, text.given->parameters, text.given->body) + "\n\n" + own : own;
}

}  // namespace

void write_c_names(data& page, const Dialect& dialect, const std::string& header) {
  const bool is_float = dialect.scalar() == "float";
  page["header_file"] = header;
  page["prefix"] = dialect.global("");
  page["count"] = dialect.count_name("joint_count");
  page["sin"] = dialect.library("sin");
  page["cos"] = dialect.library("cos");
  page["f"] = std::string(is_float ? "f" : "");
  page["half_a_place"] = std::string(is_float ? "0x1.001p-24f" : "0x1.001p-53");
  page["smallest"] = std::string(is_float ? "0x1p-126f" : "0x1p-1022");
}

void write_c_function(data& item, const Function& function, const FunctionText& text, const std::string& linkage) {
  item["brief"] = list_of(brief_comment(function));
  item["declaration"] = c_signature(text.returns, text.name, text.declared, ";");
  item["definitions"] = definitions(text, linkage);
  item["given?"] = text.given.has_value();
  if (!text.given) return;
  item["given_comment"] =
      fmt::format("The same from sine[k] = sin({0}[k]) and cosine[k] = cos({0}[k]) of the caller's, k = {1}.",
                  text.given->of, text.given->joints);
  item["given_declaration"] = c_signature(text.returns, text.given->name, text.given->declared, ";");
}

std::vector<std::string> c_example(const FunctionText& text, const Dialect& dialect, bool has_parameters) {
  const std::string parameters = has_parameters ? dialect.global("parameters") : "";
  return call_example(text, {text.name, text.returns, dialect.scalar(), "{0}", parameters, "&parameters"});
}

}  // namespace flatdyn
