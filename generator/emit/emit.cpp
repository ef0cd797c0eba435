// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <sstream>

#include "diagnostics/diagnostics.hpp"
#include "diagnostics/version.hpp"
#include "emit/angles.hpp"
#include "emit/base_constants.hpp"
#include "emit/batch_section.hpp"
#include "emit/c_section.hpp"
#include "emit/facts.hpp"
#include "emit/function_text.hpp"
#include "emit/global_names.hpp"
#include "emit/javascript_section.hpp"
#include "emit/joints.hpp"
#include "emit/name_space.hpp"
#include "emit/names.hpp"
#include "emit/page.hpp"
#include "emit/pair_section.hpp"
#include "emit/sections.hpp"
#include "emit/shape_section.hpp"
#include "emit/stage_section.hpp"
#include "emit/text_hash.hpp"
#include "emit/writer.hpp"
#include "emit/written.hpp"
#include "flatdyn/interface.hpp"
#include "graph/count.hpp"
#include "model/identifiers.hpp"
#include "model/loop_closure.hpp"
#include "symbolic/notation/coupled_text.hpp"
#include "symbolic/notation/number_text.hpp"
#include "templates.hpp"

namespace flatdyn {

namespace {

using kainjow::mustache::data;

// Reduces several blank lines to one: a section of a template that is left out leaves its own.
std::string squeezed(const std::string& text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (k >= 2 && text[k] == '\n' && text[k - 1] == '\n' && text[k - 2] == '\n') continue;
    result += text[k];
  }
  return result;
}

std::string file_name(const Mechanism& mechanism, const EmitOptions& options) {
  return options.file_name.empty() ? cpp_identifier(mechanism.name) : options.file_name;
}

// Collects the data for the templates of all languages.
class PageWriter {
 public:
  PageWriter(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
             const std::optional<Stages>& stages)
      : PageWriter(mechanism, functions, options, stages, dialect_of(mechanism, options)) {}

  PageWriter(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
             const std::optional<Stages>& stages, Dialect dialect)
      : mechanism_(mechanism),
        functions_(functions),
        options_(options),
        stages_(stages),
        namespace_(namespace_of(mechanism.name, options.name_space)),
        dialect_(std::move(dialect)),
        names_(global_names(mechanism, functions, dialect_)) {
    if (options.scalar != "double" && options.scalar != "float") {
      throw Failure(ExitCode::usage, fmt::format("unknown scalar \"{}\"", options.scalar), "use double or float");
    }
    make_scope();
  }

  data page() {
    data header;
    write_documentation(header);
    write_constants(header);
    write_functions(header);
    write_stages(header);
    if (dialect_.is_cpp()) write_shapes(header, shapes_, namespace_);
    write_loop_closing(header);
    write_angles(header);
    if (is_pair()) write_instantiations(header);
    header["uses_sign"] = uses_sign_;
    header["header_sign?"] = uses_sign_ && !is_pair();
    header["interface"] = std::to_string(kInterface);
    header["asks_runtime?"] = !is_pair();  // header and source are compiled without the runtime
    header["uses_sqrt"] = uses_sqrt_;
    header["header_sqrt?"] = uses_sqrt_ && !is_pair();
    header["uses_trigonometry"] = uses_trigonometry_;
    if (dialect_.is_c()) write_c_names(header, dialect_, header_name(mechanism_, options_));
    if (dialect_.is_lanes()) write_batch_names(header, functions_, dialect_);
    header["uses_math"] = uses_trigonometry_ || uses_sqrt_ || uses_infinity();
    return header;
  }

  std::vector<StraightCall> straight_calls() const {
    std::vector<StraightCall> calls;
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      const FunctionText text = text_of(k);
      if (text.given) {
        calls.push_back({text.given->name, text.given->arguments});
        continue;
      }
      StraightCall call{text.name, {}};
      if (!mechanism_.symbols.empty()) call.arguments.emplace_back("parameters");
      for (const auto* arrays : {&text.inputs, &text.outputs}) {
        for (const ArrayArgument& array : *arrays) call.arguments.push_back(array.name);
      }
      calls.push_back(std::move(call));
    }
    return calls;
  }

  // The names that the text exports, in order.
  const std::vector<std::string>& exported_names() const { return exports_; }

 private:
  // Sets up the scope that functions use.
  void make_scope() {
    scope_.dialect = dialect_;
    if (is_pair()) scope_.compiled = compiled_scalars(options_);
    scope_.joints = mechanism_.size();
    scope_.positions = mechanism_.position_count();
    scope_.angles = multiples_of_positions(mechanism_);
    scope_.most_lines = options_.most_lines;
    scope_.names = names_.taken;
    for (const std::string& part : parts_of_namespace(namespace_)) scope_.names.insert(part);
    NameTable members({"Scalar", "Parameters", "Real", "restrict"});
    for (const FreeSymbol& symbol : mechanism_.symbols) scope_.parameters.push_back(members.unique(symbol.name));
  }

  void write_documentation(data& header) const {
    header["robot"] = comment_text(mechanism_.name);
    header["summary"] = joints_text(mechanism_);
    const std::string version = kProgramVersion;
    header["version"] = version;
    std::vector<std::string> stamp;
    if (!options_.options_stamp.empty()) stamp.push_back("Options: " + comment_text(options_.options_stamp));
    if (!options_.input_hash.empty()) stamp.push_back("Input: " + comment_text(options_.input_hash));
    for (const std::string& line : wrapped_words(comment_text(options_.scene_stamp), kCommentWidth)) {
      stamp.push_back(line);
    }
    header["stamp"] = list_of(stamp);
    header["joint_table"] = list_of(joint_table(mechanism_));
    header["writes"] = list_of(writing_rule(functions_, !dialect_.is_cpp()));
    header["facts"] = list_of(wrapped_words(facts_of(mechanism_, options_.scene_facts), kCommentWidth));
    header["guard"] = guard_of(namespace_, dialect_.is_c() ? "H" : "HPP",
                               {version, options_.options_stamp, options_.input_hash, options_.scene_stamp});
    header["matrices?"] = std::any_of(functions_.begin(), functions_.end(), [](const Function& function) {
      return std::any_of(function.outputs.begin(), function.outputs.end(), is_array_of_arrays);
    });
    header["namespace"] = namespace_;
    header["scalar"] = options_.scalar;
    header["float?"] = options_.scalar == "float";
  }

  void write_constants(data& header) {
    exports_.emplace_back("joint_count");
    header["joint_count"] = std::to_string(mechanism_.size());
    data constants(data::type::list);
    header["loops?"] = mechanism_.has_loops();
    if (mechanism_.size() > 0) {
      std::vector<std::string> joints;
      for (const Body& body : mechanism_.joints()) joints.push_back(dialect_.text(body.joint));
      exports_.emplace_back("joint_names");
      constants << constant("As the robot file names them", per_joint("const char*", "joint_names", joints));
    }
    if (mechanism_.has_loops()) write_position_constants(header, constants);
    for (const LimitColumn& kind : limits_given(mechanism_)) {
      const std::vector<std::string> entries = limit_entries(mechanism_, kind, dialect_);
      exports_.emplace_back(kind.constant);
      constants << constant(kind.meaning, per_joint(kReal, kind.constant, entries));
    }
    header["constants"] = data(constants);
    header["base?"] = !names_.base.empty();
    if (!names_.base.empty()) {
      write_base_constants(header);
    }
    header["parameters?"] = !scope_.parameters.empty();
    header["parameters"] = list_of(members_with_units());
    if (!scope_.parameters.empty()) exports_.emplace_back("parameter_names");
    std::vector<std::string> names;
    for (const std::string& name : scope_.parameters) names.push_back(dialect_.text(name));
    header["parameter_names"] = without_newline(dialect_.definition({"const char*", "parameter_names", "", names}));
  }

  // The members of the parameters with their units: "m_1;  // kg", in JavaScript "m_1 - kg".
  std::vector<std::string> members_with_units() const {
    std::vector<std::string> members = scope_.parameters;
    const bool is_statement = !dialect_.is_javascript();
    for (std::size_t k = 0; k < members.size(); ++k) {
      const std::string& unit = mechanism_.symbols[k].unit;
      if (is_statement) members[k] += ";";
      if (!unit.empty()) members[k] += (is_statement ? "  // " : " - ") + unit;
    }
    return members;
  }

  // For robots whose q is longer than qd: constants that list the independent entries.
  void write_position_constants(data& header, data& constants) {
    header["position_count"] = std::to_string(mechanism_.position_count());
    header["positions"] = dialect_.count_name("position_count");
    std::vector<std::string> joints, entries;
    for (int p = 0; p < mechanism_.position_count(); ++p) {
      joints.push_back(dialect_.text(mechanism_.joint_at(p).joint));
    }
    for (const int p : mechanism_.independent) entries.push_back(std::to_string(p));
    exports_.emplace_back("position_count");
    exports_.emplace_back("position_names");
    exports_.emplace_back("independent_positions");
    constants << constant("The joints of q", {"const char*", dialect_.global("position_names"),
                                              dialect_.count_name("position_count"), joints});
    constants << constant("The entries of q that qd, qdd and tau belong to",
                          per_joint("int", "independent_positions", entries));
  }

  void write_angles(data& header) {
    const bool asks = uses_trigonometry_ && !scope_.angles.empty() && !dialect_.is_javascript();
    header["angles?"] = asks;
    header["header_angles?"] = asks && !is_pair();
    if (!asks) return;
    const std::string count =
        dialect_.count_definition(dialect_.count_name("angle_count"), static_cast<int>(scope_.angle_count()));
    header["angles_comment"] = list_of(angles_comment(scope_));
    header["angle_count"] = without_newline(count);
    header["angles_definition"] = angles_definition(scope_);
  }

  void write_base_constants(data& header) {
    const BaseConstants base = base_constants(mechanism_, names_.base, dialect_);
    const std::string count = dialect_.count_definition(names_.base[0], base.count);
    std::string definitions, declarations;
    exports_.push_back(names_.base[0]);
    for (const ConstantArray& array : base.arrays) {
      exports_.push_back(array.name);
      definitions += dialect_.definition(array);
      declarations += dialect_.declaration(array);
    }
    header["base_comment"] = list_of(base.comment);
    header["base_definitions"] = without_newline(dialect_.is_c() ? definitions : count + definitions);
    header["base_declarations"] = without_newline(count + declarations);
  }

  ConstantArray per_joint(const char* type, const char* name, std::vector<std::string> entries) const {
    return {type, dialect_.global(name), dialect_.count_name("joint_count"), std::move(entries)};
  }

  data constant(const std::string& comment, const ConstantArray& array) const {
    data item;
    item["comment"] = comment;
    item["definition"] = without_newline(dialect_.definition(array));
    item["declaration"] = without_newline(dialect_.declaration(array));
    return item;
  }

  FunctionText text_of(std::size_t k) const {
    return function_text(functions_[k], names_.functions[k], scope_, dialect_.is_c() ? names_.given[k] : "");
  }

  void write_functions(data& header) {
    data list(data::type::list);
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      const FunctionText text = text_of(k);
      note_needs(text);
      if (k == 0) header["example"] = list_of(example(text));
      data item;
      item["nonzero"] = nonzero(k);
      write_parts(item, text);
      item["comment"] = list_of(function_comment(functions_[k], text));
      item["header_parameters"] = template_parameters(text);
      item["signature"] = signature(text);
      item["body"] = without_newline(text.body);
      if (dialect_.is_c()) write_c_function(item, functions_[k], text, dialect_.is_lanes() ? "static " : "");
      if (dialect_.is_lanes()) write_batch_function(item, functions_[k], text, dialect_);
      if (is_pair()) write_pair_function(item, functions_[k], text);
      if (dialect_.is_cpp()) shapes_.push_back(shaped(functions_[k], text, scope_));
      if (dialect_.is_javascript()) write_javascript_function(item, functions_[k], text);
      list << item;
      exports_.push_back(names_.functions[k]);
    }
    header["functions"] = data(list);
  }

  bool uses_infinity() const {
    for (const LimitColumn& kind : limits_given(mechanism_)) {
      const std::vector<std::string> entries = limit_entries(mechanism_, kind, dialect_);
      if (std::count(entries.begin(), entries.end(), dialect_.infinity(kind.is_lower)) > 0) return true;
    }
    return false;
  }

  void write_stages(data& header) {
    header["staged?"] = stages_.has_value();
    if (!stages_) return;
    const std::vector<StageText> stages = stage_texts(*stages_, scope_);
    flatdyn::write_stages(header, stages, namespace_);
    add_stages(shapes_, stages, scope_);
    if (is_pair()) instantiations_.add(stages, scope_.compiled);
    for (const StageText& stage : stages) {
      note_needs(stage.make);
      for (const StageMember& member : stage.members) note_needs(member.text);
    }
  }

  bool is_pair() const { return dialect_.is_cpp() && options_.form == Form::pair; }

  void write_pair_function(data& item, const Function& function, const FunctionText& text) {
    write_declaration(item, text);
    item["brief"] = list_of(brief_comment(function));
    instantiations_.add(text);
  }

  void write_instantiations(data& header) {
    instantiations_.add_rounding(scope_.compiled);
    write_pair(header, header_name(mechanism_, options_), source_name(mechanism_, options_), scope_.compiled);
    header["declared_instances"] = list_of(instantiations_.declared);
    header["defined_instances"] = list_of(instantiations_.defined);
  }

  void note_needs(const FunctionText& text) {
    uses_sign_ = uses_sign_ || text.uses_sign;
    uses_sqrt_ = uses_sqrt_ || text.uses_sqrt;
    uses_trigonometry_ = uses_trigonometry_ || text.uses_trigonometry;
  }

  // Writes close_loops(), if all functions that it calls are emitted.
  void write_loop_closing(data& header) {
    const auto name_of = [this](const char* function) -> std::string {
      for (std::size_t k = 0; k < functions_.size(); ++k) {
        if (functions_[k].name == function && is_whole(functions_[k])) return names_.functions[k];
      }
      return "";
    };
    const std::string closure = name_of("loop_closure"), step = name_of("loop_step");
    header["closes_loops?"] = !closure.empty() && !step.empty();
    if (closure.empty() || step.empty()) return;
    std::size_t rows = 0;
    for (const LoopClosure& loop : mechanism_.loops) rows += loop.rows.size();
    header["closes_axes?"] = aligns_axes(mechanism_);
    header["loop_closure"] = closure;
    header["loop_step"] = step;
    header["closure_count"] = std::to_string(rows);
    header["closing_break"] = std::string(mechanism_.symbols.empty() ? " " : "\n    ");
    const std::string name = dialect_.global("close_loops");
    header["close_loops"] = name;
    exports_.push_back(name);
  }

  // The structural zeros of function k's matrices, a row per line.
  data nonzero(std::size_t k) {
    data list(data::type::list);
    const Function& function = functions_[k];
    for (std::size_t o = 0; o < function.outputs.size(); ++o) {
      const Output& output = function.outputs[o];
      if (!is_array_of_arrays(output)) continue;
      ConstantArray array{"bool", names_.nonzero[k][o], std::to_string(output.entries.size()), {}, output.cols};
      for (const NodeId entry : output.entries) {
        array.entries.push_back(function.graph.is_zero(entry) ? "0" : "1");  // also 0 for an entry that is left out
      }
      data item;
      item["output"] = comment_text(output.name);
      item["function"] = names_.functions[k];
      item["definition"] = without_newline(dialect_.definition(array));
      item["declaration"] = without_newline(dialect_.declaration(array));
      list << item;
      exports_.push_back(array.name);
    }
    return list;
  }

  std::vector<std::string> example(const FunctionText& text) const {
    if (dialect_.is_c()) return c_example(text, dialect_, !scope_.parameters.empty());
    if (dialect_.is_javascript()) return javascript_example(text, file_name(mechanism_, options_), scope_.parameters);
    const std::string result = text.returns == "Scalar" ? options_.scalar : text.returns;
    const std::string parameters = scope_.parameters.empty() ? "" : namespace_ + "::Parameters<>";
    return call_example(text, {namespace_ + "::" + text.name, result, options_.scalar, "{}", parameters, "parameters"});
  }

  const Mechanism& mechanism_;
  const std::vector<Function>& functions_;
  const EmitOptions& options_;
  const std::optional<Stages>& stages_;
  std::string namespace_;
  Dialect dialect_;
  GlobalNames names_;
  HeaderScope scope_;
  std::vector<std::string> exports_;
  Instantiations instantiations_;  // for C++ in header and source
  std::vector<ShapedFunction> shapes_;
  bool uses_sign_ = false, uses_sqrt_ = false, uses_trigonometry_ = false;
};

}  // namespace

std::string header_name(const Mechanism& mechanism, const EmitOptions& options) {
  const Language language = options.language;
  const char* const ending = language == Language::javascript ? ".js" : language == Language::c ? ".h" : ".hpp";
  return file_name(mechanism, options) + ending;
}

std::string source_name(const Mechanism& mechanism, const EmitOptions& options) {
  return file_name(mechanism, options) + (options.language == Language::c ? ".c" : ".cpp");
}

Dialect dialect_of(const Mechanism& mechanism, const EmitOptions& options) {
  if (options.language == Language::cpp) return {};
  if (options.language == Language::javascript) return Dialect::javascript();
  return Dialect::c(options.scalar, namespace_of(mechanism.name, options.name_space));
}

std::string emit_cpp(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options,
                     const std::optional<Stages>& stages) {
  data page = PageWriter(mechanism, functions, options, stages).page();
  page["rounding"] = without_newline(templates::rounding_hpp);
  return squeezed(rendered(templates::header_hpp, page));
}

HeaderAndSource emit_cpp_pair(const Mechanism& mechanism, const std::vector<Function>& functions,
                              const EmitOptions& options, const std::optional<Stages>& stages) {
  EmitOptions in_two = options;
  in_two.form = Form::pair;
  data page = PageWriter(mechanism, functions, in_two, stages).page();
  page["rounding"] = without_newline(templates::rounding_hpp);
  return {squeezed(rendered(templates::header_hpp, page)), squeezed(rendered(templates::source_cpp, page))};
}

HeaderAndSource emit_c(const Mechanism& mechanism, const std::vector<Function>& functions, const EmitOptions& options) {
  const std::optional<Stages> none;
  const data page = PageWriter(mechanism, functions, options, none).page();
  return {squeezed(rendered(templates::header_h, page)), squeezed(rendered(templates::source_c, page))};
}

std::vector<StraightCall> straight_calls(const Mechanism& mechanism, const std::vector<Function>& functions,
                                         const EmitOptions& options) {
  const std::optional<Stages> none;
  return PageWriter(mechanism, functions, options, none).straight_calls();
}

std::string emit_c_batch(const Mechanism& mechanism, const std::vector<Function>& functions,
                         const EmitOptions& options) {
  const std::optional<Stages> none;
  const Dialect lanes = Dialect::c_lanes(options.scalar, namespace_of(mechanism.name, options.name_space));
  data page = PageWriter(mechanism, functions, options, none, lanes).page();
  page["prefix"] = lanes.exported("");
  page["hash"] = std::string(kHash);
  page["sines"] = without_newline(rendered(templates::batch_sines_c, page));
  return squeezed(rendered(templates::batch_c, page));
}

std::string emit_javascript(const Mechanism& mechanism, const std::vector<Function>& functions,
                            const EmitOptions& options, JavascriptForm form) {
  const std::optional<Stages> none;
  EmitOptions in_javascript = options;
  in_javascript.language = Language::javascript;
  PageWriter writer(mechanism, functions, in_javascript, none);
  data page = writer.page();
  const std::string begin = form == JavascriptForm::module ? "export {" : "return {";
  page["exports"] = without_newline(list_line(begin, writer.exported_names(), "};", 0));
  return squeezed(rendered(templates::module_js, page));
}

}  // namespace flatdyn
