// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/page_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/version.hpp"
#include "code/emit/angle_text.hpp"
#include "code/emit/base_constants.hpp"
#include "code/emit/facts.hpp"
#include "code/emit/function_text.hpp"
#include "code/emit/global_names.hpp"
#include "code/emit/joints.hpp"
#include "code/emit/licence.hpp"
#include "code/emit/name_space.hpp"
#include "code/emit/page.hpp"
#include "code/emit/partial_output.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/angles.hpp"
#include "code/lower/names.hpp"
#include "derivation/notation/coupled_text.hpp"
#include "robot/model/identifiers.hpp"
#include "robot/model/inertia_bound.hpp"
#include "robot/model/loop_closure.hpp"

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

// Collects the data for the templates of all languages.
class PageWriter {
 public:
  PageWriter(const PageDialect& dialect, const Mechanism& mechanism, const std::vector<Function>& functions,
             const EmitOptions& options)
      : dialect_(dialect),
        mechanism_(mechanism),
        functions_(functions),
        options_(options),
        namespace_(namespace_of(mechanism.name, options.name_space)),
        names_(global_names(mechanism, functions, dialect)),
        scope_(dialect),
        content_{mechanism, functions, options, scope_, namespace_, file_name(mechanism, options)} {
    if (options.scalar != "double" && options.scalar != "float") {
      throw Failure(FailureKind::usage, fmt::format("unknown scalar \"{}\"", options.scalar), "use double or float");
    }
    fill_scope();
    for (std::size_t k = 0; k < functions.size(); ++k) {
      const std::string given = dialect.has_given_variants() ? names_.sin_cos_variants[k] : "";
      content_.texts.push_back(function_text(functions[k], names_.functions[k], scope_, given));
      note_needs(content_.texts.back());
    }
  }

  const std::vector<FunctionText>& texts() const { return content_.texts; }

  data page(const std::optional<Stages>& stages) {
    data header;
    if (stages) add_stages(*stages);
    write_documentation(header);
    write_constants(header);
    write_functions(header);
    write_loop_closing(header);
    write_angles(header);
    header["uses_sign"] = content_.uses_sign;
    header["uses_sqrt"] = content_.uses_sqrt;
    header["uses_excess"] = content_.uses_excess;
    header["uses_limbs"] = content_.uses_limbs;
    header["uses_zeros"] = content_.uses_zeros;
    header["uses_fma"] = content_.uses_fma;
    header["uses_trigonometry"] = content_.uses_trigonometry;
    header["own_sines?"] = content_.uses_trigonometry && options_.sines == Sines::polynomials;
    header["computed_angles?"] = std::any_of(functions_.begin(), functions_.end(), computes_angles);
    header["library_sines?"] = options_.sines == Sines::library;
    header["uses_math"] = content_.uses_trigonometry || content_.uses_sqrt || content_.uses_fma || uses_infinity();
    header["licence"] = licence_comment();
    header["position_count"] = std::to_string(mechanism_.position_count());
    dialect_.write_page(header, content_);
    return header;
  }

 private:
  // Fills the scope that functions use.
  void fill_scope() {
    scope_.counts = JointCounts(mechanism_);
    scope_.angles = multiples_of_positions(mechanism_);
    scope_.fuses = options_.fuses;
    scope_.most_lines = options_.most_lines;
    scope_.proven_positions = positions_of_inertia_bound(mechanism_);
    if (options_.limbs_in_lanes && scope_.language.has_lanes) scope_.limbs = limbs_of(mechanism_);
    scope_.names = names_.taken;
    for (const std::string& part : parts_of_namespace(namespace_)) scope_.names.insert(part);
    std::set<std::string> reserved = {"Scalar", "Parameters", "Real", "restrict"};
    for (const std::string& word : dialect_.reserved_members()) reserved.insert(word);
    NameTable members(reserved);
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
    std::vector<Function> whole;  // without the parts of kernels
    for (std::size_t k = 0; k < functions_.size() && !options_.is_kernel_part(k); ++k) whole.push_back(functions_[k]);
    header["writes"] = list_of(partial_output_rule(whole, dialect_.outputs_may_overlap_inputs()));
    header["facts"] = list_of(wrapped_words(facts_of(mechanism_, options_.scene_facts), kCommentWidth));
    header["guard"] = guard_of(namespace_, dialect_.files().front().ending.substr(1),
                               {version, options_.options_stamp, options_.input_hash, options_.scene_stamp});
    header["matrices?"] = std::any_of(functions_.begin(), functions_.end(), [](const Function& function) {
      return std::any_of(function.outputs.begin(), function.outputs.end(), is_array_of_arrays);
    });
    header["namespace"] = namespace_;
    header["scalar"] = options_.scalar;
    header["float?"] = options_.scalar == "float";
  }

  void write_constants(data& header) {
    content_.exports.emplace_back("joint_count");
    header["joint_count"] = std::to_string(mechanism_.joints().size());
    data constants(data::type::list);
    const bool has_positions = mechanism_.has_longer_positions();
    header["positions?"] = has_positions;
    header["floating?"] = mechanism_.floating_base;
    header["springs?"] = mechanism_.has_springs();
    if (mechanism_.floating_base) {
      content_.exports.emplace_back("velocity_count");
      header["velocity_count"] = std::to_string(mechanism_.size());
      header["velocities"] = dialect_.count_name("velocity_count");
    }
    if (mechanism_.joints().size() > 0) {
      std::vector<code::TableEntry> joints;
      for (const Body& body : mechanism_.joints()) joints.emplace_back(body.joint);
      content_.exports.emplace_back("joint_names");
      constants << constant("The names of the joints in the robot file",
                            per_joint(code::Table::Type::text, "joint_names", joints));
    }
    if (has_positions) write_position_constants(header, constants);
    for (const LimitColumn& kind : limits_given(mechanism_)) {
      content_.exports.emplace_back(kind.constant);
      constants << constant(kind.meaning,
                            per_joint(code::Table::Type::real, kind.constant, limit_entries(mechanism_, kind)));
    }
    header["constants"] = data(constants);
    header["base?"] = !names_.base.empty();
    if (!names_.base.empty()) {
      write_base_constants(header);
    }
    header["parameters?"] = !scope_.parameters.empty();
    header["parameters"] = list_of(members_with_units());
    if (!scope_.parameters.empty()) content_.exports.emplace_back("parameter_names");
    const std::vector<code::TableEntry> names(scope_.parameters.begin(), scope_.parameters.end());
    header["parameter_names"] =
        without_newline(dialect_.definition({code::Table::Type::text, "parameter_names", "", names}));
  }

  std::vector<std::string> members_with_units() const {
    std::vector<std::string> members;
    for (std::size_t k = 0; k < scope_.parameters.size(); ++k) {
      members.push_back(dialect_.member(scope_.parameters[k], mechanism_.symbols[k].unit));
    }
    return members;
  }

  // For robots whose q is longer than qd: constants that name its entries, and with closed loops list the independent
  // ones.
  void write_position_constants(data& header, data& constants) {
    header["position_count"] = std::to_string(mechanism_.position_count());
    header["positions"] = dialect_.count_name("position_count");
    const std::vector<std::string> names = mechanism_.position_names();
    const std::vector<code::TableEntry> joints(names.begin(), names.end());
    const std::vector<code::TableEntry> entries(mechanism_.independent.begin(), mechanism_.independent.end());
    content_.exports.emplace_back("position_count");
    content_.exports.emplace_back("position_names");
    constants << constant("The joints of q", {code::Table::Type::text, dialect_.global("position_names"),
                                              dialect_.count_name("position_count"), joints});
    if (!mechanism_.has_loops()) return;
    content_.exports.emplace_back("independent_positions");
    constants << constant(mechanism_.floating_base
                              ? "The entries of q that those of v, a and tau after the base's belong to"
                              : "The entries of q that qd, qdd and tau belong to",
                          per_joint(code::Table::Type::whole, "independent_positions", entries));
  }

  void write_angles(data& header) {
    const bool asks = content_.uses_trigonometry && !scope_.angles.empty() && !scope_.language.evaluates_sines;
    header["angles?"] = asks;
    if (!asks) return;
    const std::string count =
        dialect_.count_definition(dialect_.count_name("angle_count"), static_cast<int>(scope_.angle_count()));
    header["angles_comment"] = list_of(angles_comment(scope_));
    header["angle_count"] = without_newline(count);
    header["angles_definition"] = angles_definition(scope_);
  }

  void write_base_constants(data& header) {
    const BaseConstants base = base_constants(mechanism_, names_.base, options_.frames);
    const std::string count = dialect_.count_definition(names_.base[0], base.count);
    std::string definitions, declarations;
    content_.exports.push_back(names_.base[0]);
    for (const code::Table& table : base.tables) {
      content_.exports.push_back(table.name);
      definitions += dialect_.definition(table);
      declarations += dialect_.declaration(table);
    }
    header["base_comment"] = list_of(base.comment);
    header["base_definitions"] =
        without_newline(dialect_.declares_constants_apart() ? definitions : count + definitions);
    header["base_declarations"] = without_newline(count + declarations);
  }

  code::Table per_joint(code::Table::Type type, const char* name, std::vector<code::TableEntry> entries) const {
    return {type, dialect_.global(name), dialect_.count_name("joint_count"), std::move(entries)};
  }

  data constant(const std::string& comment, const code::Table& table) const {
    data item;
    item["comment"] = comment;
    item["definition"] = without_newline(dialect_.definition(table));
    item["declaration"] = without_newline(dialect_.declaration(table));
    return item;
  }

  void write_functions(data& header) {
    data list(data::type::list);
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      const FunctionText& text = content_.texts[k];
      data item;
      item["nonzero"] = nonzero(k);
      write_parts(item, text);
      item["comment"] = list_of(function_comment(functions_[k], text));
      item["body"] = without_newline(text.body);
      dialect_.write_function(item, functions_[k], text);
      list << item;
      content_.exports.push_back(names_.functions[k]);
    }
    header["functions"] = data(list);
  }

  bool uses_infinity() const {
    for (const LimitColumn& kind : limits_given(mechanism_)) {
      const std::vector<code::TableEntry> entries = limit_entries(mechanism_, kind);
      const auto is_missing = [](const code::TableEntry& each) { return std::holds_alternative<code::Infinity>(each); };
      if (std::any_of(entries.begin(), entries.end(), is_missing)) return true;
    }
    return false;
  }

  void add_stages(const Stages& stages) {
    content_.stages = stage_texts(stages, scope_);
    for (const StageText& stage : content_.stages) {
      note_needs(stage.make);
      for (const StageMember& member : stage.members) note_needs(member.text);
    }
  }

  void note_needs(const FunctionText& text) {
    content_.uses_sign = content_.uses_sign || text.uses_sign;
    content_.uses_sqrt = content_.uses_sqrt || text.uses_sqrt;
    content_.uses_excess = content_.uses_excess || text.uses_excess;
    content_.uses_fma = content_.uses_fma || text.uses_fma;
    content_.uses_limbs = content_.uses_limbs || text.uses_limbs;
    content_.uses_zeros = content_.uses_zeros || text.uses_zeros;
    content_.uses_trigonometry = content_.uses_trigonometry || text.uses_trigonometry || text.computes_sines;
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
    content_.exports.push_back(name);
  }

  // The structural zeros of function k's matrices, a row per line.
  data nonzero(std::size_t k) {
    data list(data::type::list);
    const Function& function = functions_[k];
    if (options_.is_kernel_part(k)) return list;
    for (std::size_t o = 0; o < function.outputs.size(); ++o) {
      const Output& output = function.outputs[o];
      if (!is_array_of_arrays(output)) continue;
      const std::string length = std::to_string(output.entries.size());
      code::Table table{code::Table::Type::flag, names_.nonzero[k][o], length, {}, output.cols};
      for (const NodeId entry : output.entries) {  // one that is left out is zero, too
        table.entries.emplace_back(code::Flag{!function.graph.is_zero(entry)});
      }
      data item;
      item["output"] = comment_text(output.name);
      item["function"] = names_.functions[k];
      item["definition"] = without_newline(dialect_.definition(table));
      item["declaration"] = without_newline(dialect_.declaration(table));
      list << item;
      content_.exports.push_back(table.name);
    }
    return list;
  }

  const PageDialect& dialect_;
  const Mechanism& mechanism_;
  const std::vector<Function>& functions_;
  const EmitOptions& options_;
  std::string namespace_;
  GlobalNames names_;
  HeaderScope scope_;
  CodeContent content_;
};

}  // namespace

std::string file_name(const Mechanism& mechanism, const EmitOptions& options) {
  return options.file_name.empty() ? cpp_identifier(mechanism.name) : options.file_name;
}

std::vector<std::string> emitted(const PageDialect& dialect, const Mechanism& mechanism,
                                 const std::vector<Function>& functions, const EmitOptions& options,
                                 const std::optional<Stages>& stages) {
  const data page = PageWriter(dialect, mechanism, functions, options).page(stages);
  std::vector<std::string> texts;
  for (const FileTemplate& file : dialect.files()) texts.push_back(squeezed(rendered(file.text, page)));
  return texts;
}

std::vector<FunctionText> function_texts(const PageDialect& dialect, const Mechanism& mechanism,
                                         const std::vector<Function>& functions, const EmitOptions& options) {
  return PageWriter(dialect, mechanism, functions, options).texts();
}

}  // namespace flatdyn
