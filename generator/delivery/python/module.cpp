// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/python/module.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/version.hpp"
#include "code/emit/base_constants.hpp"
#include "code/emit/facts.hpp"
#include "code/emit/global_names.hpp"
#include "code/emit/joints.hpp"
#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/text_hash.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/arguments.hpp"
#include "delivery/python/module_names.hpp"
#include "derivation/notation/coupled_text.hpp"
#include "functions/units.hpp"
#include "proof/verify/proof.hpp"
#include "robot/model/identifiers.hpp"
#include "robot/model/loop_closure.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

constexpr std::size_t kPythonWidth = 120;

// The entries as a Python tuple, "7, 7" in brackets, also for a single one.
std::string tuple_of(const std::vector<std::string>& entries) {
  return fmt::format("({}{})", fmt::join(entries, ", "), entries.size() == 1 ? "," : "");
}

// The shape of an output at one state: () for a number, (7,) for a vector, (7, 7) for a matrix.
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

// Facts about v and a, where they are not the derivatives of q; else none.
std::string velocities_text(const Mechanism& mechanism) {
  std::string text = mechanism.floating_base ? floating_base_text(mechanism) : "";
  if (!mechanism.has_spherical_joints()) return text;
  return text + (text.empty() ? "" : " ") + spherical_joints_text(mechanism);
}

// "joint_names = ("a", "b")", in ASCII.
std::string names_line(const std::string& variable, const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(nlohmann::json(name).dump(-1, ' ', true));
  return without_newline(list_line(variable + " = (", quoted, quoted.size() == 1 ? ",)" : ")", 0));
}

class ModuleWriter {
 public:
  ModuleWriter(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options)
      : mechanism_(mechanism), functions_(functions), options_(options), dialect_(dialect_of(mechanism, options)) {}

  PythonModule written() const {
    const data page = filled();
    return {rendered(templates::python_module_py, page), emit_batch(mechanism_, functions_, options_)};
  }

 private:
  data filled() const {
    data page;
    page["robot"] = comment_text(mechanism_.name);
    page["version"] = std::string(kProgramVersion);
    page["name"] = module_name(mechanism_, options_);
    page["compile"] = fmt::format(
        "cc -std=c99 -O3 -march=native -mtune=generic -ffp-contract=off -fno-tree-slp-vectorize -shared -fPIC {0}.c "
        "{0}_batch.c -o lib{0}.so -lm",
        module_name(mechanism_, options_));
    page["hash"] = std::string(kHashPlaceholder);
    page["library"] = std::string("_library_") + kShortHashPlaceholder;
    page["prefix"] = dialect_->global("");
    page["scalar"] = options_.scalar;
    page["is_float"] = options_.scalar == "float";
    const bool has_rates = !mechanism_.has_quasi_velocities();
    page["joints"] = has_rates ? fmt::format("{} joints", mechanism_.size()) : joints_text(mechanism_);
    page["velocities?"] = !has_rates;
    page["velocities"] = list_of(wrapped_words(velocities_text(mechanism_), kPythonWidth));
    page["joint_names"] = names_line("joint_names", mechanism_.joint_names());
    page["has_position_names?"] = mechanism_.has_longer_positions();
    page["position_names"] = names_line("position_names", mechanism_.position_names());
    page["parameters?"] = has_parameters();
    data symbols(data::type::list);
    for (const FreeSymbol& symbol : mechanism_.symbols) {
      data item("symbol", symbol.name);
      item["unit"] = symbol.unit;
      item["has_unit?"] = !symbol.unit.empty();
      symbols << item;
    }
    page["symbols"] = data(symbols);
    page["functions"] = functions();
    page["closes_loops?"] = closes_loops();
    page["closes_axes?"] = aligns_axes(mechanism_);
    page["positions"] = std::to_string(mechanism_.position_count());
    write_constants(page);
    return page;
  }

  // Constants of the C form, by their names there.
  void write_constants(data& page) const {
    page["joint_count"] = std::to_string(mechanism_.joints().size());
    page["floating?"] = mechanism_.floating_base;
    page["velocity_count"] = std::to_string(mechanism_.size());
    data limits(data::type::list);
    for (const LimitColumn& kind : limits_given(mechanism_)) {
      data item("name", std::string(kind.constant));
      item["meaning"] = std::string(kind.meaning);
      item["exported"] = dialect_->global(kind.constant);
      limits << item;
    }
    page["limits"] = data(limits);
    const std::vector<std::string> names = global_names(mechanism_, functions_, *dialect_).base;
    const BaseConstants base = names.empty() ? BaseConstants{} : base_constants(mechanism_, names, options_.frames);
    page["base?"] = base.count > 0;
    if (base.count == 0) return;
    page["base_count"] = std::to_string(base.count);
    page["base_names"] = names[1];
    page["base_units"] = names_line("base_parameter_units", units_of_base_parameters(mechanism_));
    page["base_values?"] = base.tables.size() > 1;
    page["base_values"] = names[2];
  }

  data functions() const {
    data list(data::type::list);
    for (const Function& function : functions_) list << row_of(function);
    return list;
  }

  bool has_parameters() const { return !mechanism_.symbols.empty(); }

  InputArgument argument(const Function& function, InputKind kind) const {
    return input_argument(kind, JointCounts(mechanism_), function);
  }

  data row_of(const Function& function) const {
    data row;
    row["function"] = cpp_identifier(function.name);
    row["summary"] = function.equation.empty() ? function.summary : function.summary + " " + function.equation;
    row["parameters?"] = has_parameters();
    write_python(function, row);
    return row;
  }

  // Fills in a method: its arguments, their meaning, and its result.
  void write_python(const Function& function, data& row) const {
    std::vector<std::string> names, lengths, shapes;
    data meanings(data::type::list), results(data::type::list);
    if (has_parameters()) meanings << data("line", std::string("parameters: Parameters"));
    for (const InputKind kind : function.inputs) {
      const InputArgument input = argument(function, kind);
      names.push_back(input.name);
      lengths.push_back(std::to_string(input.length));
      meanings << line_of(input.name, fmt::format("({0},) or (N, {0})", input.length), input.meaning);
    }
    for (const Output& output : function.outputs) {
      shapes.push_back(shape_of(output));
      results << line_of(output.name, "of one state " + shape_of(output), output.meaning);
    }
    if (!function.validity_conditions.empty())
      results << data("line", "Not a number where " + condition_of(function) + ".");
    row["arguments"] = fmt::format("{}{}", has_parameters() ? "parameters, " : "", fmt::join(names, ", "));
    std::vector<std::string> given;
    for (const std::string& name : names) given.push_back(fmt::format("\"{0}\": {0}", name));
    row["given"] = fmt::format("{{{}}}", fmt::join(given, ", "));
    row["lengths"] = tuple_of(lengths);
    row["shapes"] = tuple_of(shapes);
    row["meanings"] = data(meanings);
    row["results"] = data(results);
  }

  static std::string condition_of(const Function& function) {
    const auto loops = static_cast<std::size_t>(function.loop_conditions);
    if (loops == function.validity_conditions.size()) return "a closed loop is within 1e-6 of being singular";
    const std::string inverted = function.inverted.empty() ? "B" : function.inverted;
    return inverted + " is not positive definite" + (function.task.empty() ? "" : ", or the task is singular") +
           (loops > 0 ? ", or a closed loop is within 1e-6 of being singular" : "");
  }

  // Whether the C form has close_loops(), which it has if both of these functions are generated.
  bool closes_loops() const {
    return std::count_if(functions_.begin(), functions_.end(), [](const Function& function) {
             return function.name == "loop_closure" || function.name == "loop_step";
           }) == 2;
  }

  static data line_of(const std::string& name, const std::string& shape, const std::string& meaning) {
    return data("line", fmt::format("{}: {}; {}", name, shape, meaning));
  }

  const Mechanism& mechanism_;
  const std::vector<Function>& functions_;
  const EmitOptions& options_;
  std::unique_ptr<const PageDialect> dialect_;
};

}  // namespace

std::string module_name(const Mechanism& mechanism, const EmitOptions& options) {
  const std::string header = header_name(mechanism, options);
  const std::string name = header.substr(0, header.find_last_of('.'));
  if (cpp_identifier(name) != name || is_keyword_of_python(name)) {
    throw Failure(FailureKind::usage, fmt::format("--python: \"{}\" is no name of a module", name),
                  "use letters, digits and _ for --name");
  }
  if (is_module_of_python(name)) {
    throw Failure(FailureKind::usage,
                  fmt::format("--python: Python has a module \"{}\", in whose place this one would be imported", name),
                  fmt::format("choose another name, such as --name {}_robot", name));
  }
  return name;
}

PythonModule python_module(const Mechanism& mechanism, const std::vector<Function>& functions,
                           const EmitOptions& options) {
  PythonModule texts = ModuleWriter(mechanism, functions, options).written();
  std::vector<GeneratedFile> called = emit_code(mechanism, functions, options);
  prove_batch(called.front().text, texts.batch, {mechanism, functions, std::nullopt, options});
  std::vector<std::string*> hashed;
  for (GeneratedFile& file : called) hashed.push_back(&file.text);
  hashed.insert(hashed.end(), {&texts.module, &texts.batch});
  fill_in_hash(hashed);
  return texts;
}

}  // namespace flatdyn
