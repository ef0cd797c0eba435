// SPDX-License-Identifier: GPL-2.0-or-later
#include "python/module.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "diagnostics/diagnostics.hpp"
#include "emit/arguments.hpp"
#include "emit/identifiers.hpp"
#include "emit/page.hpp"
#include "emit/sections.hpp"
#include "emit/writer.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

// "7, 7", in brackets a tuple of Python's even if there is one.
std::string tuple_of(const std::vector<std::string>& entries) {
  return fmt::format("({}{})", fmt::join(entries, ", "), entries.size() == 1 ? "," : "");
}

// Of one state: () of a number, (7,) of a vector, (7, 7) of a matrix.
std::string shape_of(const Output& output) {
  switch (output.layout) {
    case Layout::scalar:
      return "()";
    case Layout::matrix:
      return fmt::format("({}, {})", output.rows, output.cols);
    default:
      return fmt::format("({},)", output.entries.size());
  }
}

class ModuleWriter {
 public:
  ModuleWriter(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options)
      : mechanism_(mechanism), functions_(functions), options_(options), dialect_(dialect_of(mechanism, options)) {}

  PythonModule written() const {
    const data page = filled();
    return {rendered(templates::python_module_py, page), rendered(templates::python_batch_c, page)};
  }

 private:
  data filled() const {
    data page;
    page["robot"] = comment_text(mechanism_.name);
    page["version"] = std::string(FLATDYN_VERSION);
    page["name"] = module_name(mechanism_, options_);
    page["header"] = header_name(mechanism_, options_);
    page["prefix"] = dialect_.global("");
    page["scalar"] = options_.scalar;
    page["is_float"] = options_.scalar == "float";
    page["joints"] = std::to_string(mechanism_.size());
    std::vector<std::string> names;
    for (const Body& body : mechanism_.bodies) names.push_back(nlohmann::json(body.joint).dump(-1, ' ', true));
    page["joint_names"] = without_newline(list_line("joint_names = (", names, names.size() == 1 ? ",)" : ")", 0));
    page["parameters?"] = !mechanism_.symbols.empty();
    data symbols(data::type::list);
    for (const FreeSymbol& symbol : mechanism_.symbols) symbols << data("symbol", symbol.name);
    page["symbols"] = data(symbols);
    page["functions"] = functions();
    return page;
  }

  data functions() const {
    data list(data::type::list);
    for (const Function& function : functions_) list << row_of(function);
    return list;
  }

  data row_of(const Function& function) const {
    std::vector<std::string> names, lengths, shapes, in_c, arguments;
    data meanings(data::type::list);
    if (!mechanism_.symbols.empty()) {
      in_c.push_back(fmt::format("const {}* parameters", dialect_.global("parameters")));
      arguments.emplace_back("parameters");
      meanings << data("line", std::string("parameters: Parameters"));
    }
    for (const InputKind kind : function.inputs) {
      const InputArgument input = input_argument(kind, mechanism_.size(), function.base_parameters);
      names.push_back(input.name);
      lengths.push_back(std::to_string(input.length));
      in_c.push_back(dialect_.input(input.name, false));
      arguments.push_back(fmt::format("{} + {} * k", input.name, input.length));
      meanings << line_of(input.name, fmt::format("({0},) or (N, {0})", input.length), input.meaning);
    }
    data results(data::type::list);
    for (const Output& output : function.outputs) {
      shapes.push_back(shape_of(output));
      in_c.push_back(dialect_.output(output.name, false));
      if (!returns_value(function)) {
        arguments.push_back(fmt::format("{} + {} * k", output.name, output.entries.size()));
      }
      results << line_of(output.name, "of one state " + shape_of(output), output.meaning);
    }
    const bool is_checked = !function.positive.empty();
    if (is_checked) {
      in_c.emplace_back("bool* positive");
      results << data("line", std::string("Not a number where B is not positive definite."));
    }
    const std::string own = cpp_identifier(function.name);
    const std::string called = dialect_.global(own) + "(";
    const std::string result = is_checked                ? "positive[k] = "
                               : returns_value(function) ? function.outputs[0].name + "[k] = "
                                                         : "";
    data row;
    row["function"] = own;
    row["summary"] = function.summary + " " + function.equation;
    row["parameters?"] = !mechanism_.symbols.empty();
    row["arguments"] = fmt::format("{}{}", mechanism_.symbols.empty() ? "" : "parameters, ", fmt::join(names, ", "));
    row["given"] = tuple_of(names);
    row["lengths"] = tuple_of(lengths);
    row["shapes"] = tuple_of(shapes);
    row["meanings"] = data(meanings);
    row["results"] = data(results);
    row["is_checked"] = std::string(is_checked ? "True" : "False");
    in_c.insert(in_c.begin(), "size_t count");
    row["signature"] =
        without_newline(list_line(fmt::format("void {}{}_batch(", dialect_.global(""), own), in_c, ") {", 0));
    row["call"] = without_newline(list_line(result + called, arguments, ");", 4));
    return row;
  }

  static data line_of(const std::string& name, const std::string& shape, const std::string& meaning) {
    return data("line", fmt::format("{}: {}; {}", name, shape, meaning));
  }

  const Mechanism& mechanism_;
  const std::vector<Function>& functions_;
  const EmitOptions& options_;
  Dialect dialect_;
};

}  // namespace

std::string module_name(const Mechanism& mechanism, const EmitOptions& options) {
  const std::string header = header_name(mechanism, options);
  const std::string name = header.substr(0, header.find_last_of('.'));
  if (cpp_identifier(name) != name) {
    throw Failure(ExitCode::usage, fmt::format("--python: \"{}\" is no name of a module", name),
                  "use letters, digits and _ for --name");
  }
  return name;
}

PythonModule python_module(const Mechanism& mechanism, const std::vector<Function>& functions,
                           const EmitOptions& options) {
  return ModuleWriter(mechanism, functions, options).written();
}

}  // namespace flatdyn
