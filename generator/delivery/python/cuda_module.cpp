// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/python/cuda_module.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/version.hpp"
#include "code/emit/joints.hpp"
#include "code/emit/literals.hpp"
#include "code/emit/name_space.hpp"
#include "code/emit/page.hpp"
#include "code/emit/page_writer.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/text_hash.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/emit.hpp"
#include "code/lower/arguments.hpp"
#include "delivery/python/module.hpp"
#include "derivation/notation/coupled_text.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

// A list in brackets, on one line if it fits, else one item a line.
std::string python_list(const std::string& begin, const std::vector<std::string>& items, const std::string& end,
                        std::size_t indent) {
  constexpr std::size_t kPythonLine = 100;
  const std::string margin(indent, ' ');
  const std::string line = fmt::format("{}{}{}{}\n", margin, begin, fmt::join(items, ", "), end);
  if (line.size() <= kPythonLine) return line;
  std::string text = margin + begin + "\n";
  for (const std::string& item : items) text += margin + "    " + item + ",\n";
  return text + margin + end + "\n";
}

// A function as the module and its launcher declare it.
class Launcher {
 public:
  Launcher(const FunctionText& text, const std::string& prefix, const std::string& name_space)
      : text_(text), prefix_(prefix), name_space_(name_space) {
    for (const ArrayArgument& input : text.inputs) add(input, true);
    for (const ArrayArgument& output : text.outputs) add(output, false);
    if (text.returns == "Scalar") add({"results", 1}, false);
  }

  std::string definition() const {
    std::vector<std::string> parameters = {"int layout", "void* stream", "size_t states"};
    std::vector<std::string> passed = {"layout", "stream", "states"};
    passed.insert(passed.end(), empty_, "nullptr");
    for (std::size_t k = 0; k < names_.size(); ++k) {
      parameters.push_back((k < inputs_ ? "const Number* " : "Number* ") + names_[k]);
      passed.push_back(names_[k]);
    }
    if (is_checked()) {
      parameters.emplace_back("bool* valid");
      passed.emplace_back("valid");
    }
    return list_line(fmt::format("int {}{}(", prefix_, text_.name), parameters, ") {", 0) +
           list_line(fmt::format("return in_layout<{}::functions::{}>(", name_space_, text_.name), passed, ");", 2) +
           "}";
  }

  data python() const {
    data item;
    std::vector<std::string> parameters = names_, lines;
    for (const std::string& line : text_.arguments)
      lines.push_back(line.substr(line.find_first_not_of(' ') == 0 ? 0 : 2));
    parameters.emplace_back("layout=\"rows\"");
    parameters.emplace_back("stream=None");
    parameters.emplace_back("states=None");
    if (is_checked()) parameters.emplace_back("valid=None");
    if (text_.returns == "Scalar") lines.push_back(line_of_result(lines));
    item["lines"] = list_of(lines);
    const auto quoted = [](const std::string& name) { return "\"" + name + "\""; };
    std::vector<std::string> names, lengths;
    for (std::size_t k = 0; k < names_.size(); ++k) {
      names.push_back(quoted(names_[k]));
      lengths.push_back(std::to_string(lengths_[k]));
    }
    item["head"] = without_newline(python_list("def " + text_.name + "(", parameters, "):", 0));
    item["call"] = without_newline(python_list(
        "_call(",
        {fmt::format("_c.{}{}", prefix_, text_.name), fmt::format("[{}]", fmt::join(names, ", ")),
         fmt::format("[{}]", fmt::join(lengths, ", ")), fmt::format("[{}]", fmt::join(names_, ", ")),
         std::to_string(inputs_), is_checked() ? "layout, stream, states, valid" : "layout, stream, states"},
        ")", 4));
    return item;
  }

 private:
  // The result in columns like those of the arguments before it.
  std::string line_of_result(const std::vector<std::string>& arguments) const {
    std::string name = "results[1]";
    if (!arguments.empty()) {
      const std::size_t gap = arguments.front().find(' ');
      name.resize(std::max(name.size() + 2, arguments.front().find_first_not_of(' ', gap)), ' ');
    }
    return name + "out  " + text_.result;
  }

  void add(const ArrayArgument& array, bool is_input) {
    if (array.length == 0) {  // q of a body without joints, which comes first
      ++empty_;
      return;
    }
    names_.push_back(array.name);
    lengths_.push_back(array.length);
    inputs_ += is_input ? 1U : 0U;
  }

  bool is_checked() const { return text_.returns == "bool"; }

  const FunctionText& text_;
  const std::string &prefix_, &name_space_;
  std::vector<std::string> names_;
  std::vector<std::size_t> lengths_;
  std::size_t inputs_ = 0, empty_ = 0;
};

std::string names_of_joints(const Mechanism& mechanism) { return nlohmann::json(mechanism.joint_names()).dump(); }

// A limit as Python writes it.
std::string limit_text(const code::TableEntry& entry) {
  if (const auto* missing = std::get_if<code::Infinity>(&entry)) {
    return missing->is_negative ? "-float(\"inf\")" : "float(\"inf\")";
  }
  return decimal_literal(std::get<Rational>(entry));
}

data limits_of_joints(const Mechanism& mechanism) {
  data list(data::type::list);
  for (const LimitColumn& kind : limits_given(mechanism)) {
    std::vector<std::string> entries;
    for (const code::TableEntry& entry : limit_entries(mechanism, kind)) entries.push_back(limit_text(entry));
    data item("name", std::string(kind.constant));
    item["meaning"] = std::string(kind.meaning);
    item["entries"] = fmt::format("{}", fmt::join(entries, ", "));
    list << item;
  }
  return list;
}

}  // namespace

CudaPythonModule cuda_python_module(const Mechanism& mechanism, const std::vector<Function>& functions,
                                    const EmitOptions& options) {
  if (!mechanism.symbols.empty()) {
    throw Failure(FailureKind::usage, "--python: in CUDA not for robots with free symbols",
                  "give them values in the robot file");
  }
  const std::unique_ptr<const PageDialect> dialect = dialect_of(mechanism, options);
  const std::vector<FunctionText> texts = function_texts(*dialect, mechanism, functions, options);
  const std::string name = module_name(mechanism, options),
                    name_space = namespace_of(mechanism.name, options.name_space);
  std::string prefix = name_space + "_";
  for (std::size_t at = prefix.find("::"); at != std::string::npos; at = prefix.find("::")) prefix.replace(at, 2, "_");
  const bool is_float = options.scalar == "float";
  data page, launchers(data::type::list), python(data::type::list);
  for (std::size_t k = 0; k < texts.size(); ++k) {
    if (!can_be_launched(texts[k])) continue;
    const Launcher launcher(texts[k], prefix, name_space);
    launchers << data(launcher.definition());
    data item = launcher.python();
    item["summary"] = functions[k].summary;
    python << item;
  }
  page["robot"] = comment_text(mechanism.name);
  page["joints"] = joints_text(mechanism);
  page["version"] = std::string(kProgramVersion);
  page["name"] = name;
  page["header"] = file_name(mechanism, options) + ".cuh";
  page["compile"] = fmt::format(
      "nvcc -O3 -std=c++17 -arch=native -shared -Xcompiler -fPIC -I FLATDYN/runtime/include {0}_python.cu -o lib{0}.so",
      name);
  page["scalar"] = options.scalar;
  page["dtype"] = std::string(is_float ? "float32" : "float64");
  page["typestr"] = std::string(is_float ? "<f4" : "<f8");
  page["prefix"] = prefix;
  page["joint_names"] = names_of_joints(mechanism);
  page["joint_count"] = std::to_string(mechanism.joints().size());
  page["limits"] = limits_of_joints(mechanism);
  page["launchers"] = data(launchers);
  page["functions"] = data(python);
  page["hash"] = std::string(kHashPlaceholder);
  CudaPythonModule result{rendered(templates::python_cuda_py, page), rendered(templates::python_cuda_cu, page)};
  fill_in_hash({&result.module, &result.launchers});
  return result;
}

}  // namespace flatdyn
