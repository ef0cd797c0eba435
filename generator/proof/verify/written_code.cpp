// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/written_code.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "code/emit/literals.hpp"
#include "code/languages/language_table.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "derivation/parameters/parameters.hpp"
#include "functions/function_table.hpp"
#include "robot/model/field_mechanism.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// A number of the robot file as the nearest double; nullopt if it has symbols.
std::optional<double> value_of(const Number& number) {
  constexpr int kDigits = 40;  // of Pi and roots
  if (has_symbols(number)) return std::nullopt;
  return nearest_double(to_rational(is_rational(number) ? number : exact_decimal(to_decimal(number, kDigits))));
}

struct LimitTable {
  const char* name;
  double none;  // where there is no limit
  std::optional<Value> Limits::*value;
};

const LimitTable kLimitTables[] = {{"position_lower", -kNoLimit, &Limits::lower},
                                   {"position_upper", kNoLimit, &Limits::upper},
                                   {"velocity_limit", kNoLimit, &Limits::velocity},
                                   {"acceleration_limit", kNoLimit, &Limits::acceleration},
                                   {"effort_limit", kNoLimit, &Limits::effort}};

// The table of one kind of limits; nullopt if no joint has one.
std::optional<FileTable> limits_of(const Mechanism& mechanism, const LimitTable& kind) {
  FileTable table{"Real", kind.name, "joint_count"};
  bool any = false;
  for (const Body& body : mechanism.joints()) {
    const std::optional<Value>& limit = body.limits.*kind.value;
    const std::optional<double> value = limit ? value_of(limit->number) : std::nullopt;
    any = any || value.has_value();
    table.numbers.push_back(value.value_or(kind.none));
  }
  return any ? std::optional(table) : std::nullopt;
}

std::vector<FileTable> tables_of(const Mechanism& mechanism) {
  std::vector<FileTable> tables;
  if (mechanism.joints().size() > 0) {
    tables.push_back({"const char*", "joint_names", "joint_count"});
    tables.back().texts = mechanism.joint_names();
  }
  if (mechanism.has_longer_positions()) {
    tables.push_back({"const char*", "position_names", "position_count"});
    tables.back().texts = mechanism.position_names();
  }
  if (mechanism.has_loops()) {
    tables.push_back({"int", "independent_positions", "joint_count"});
    for (const int p : mechanism.independent) tables.back().numbers.push_back(p);
  }
  for (const LimitTable& kind : kLimitTables) {
    if (const std::optional<FileTable> table = limits_of(mechanism, kind)) tables.push_back(*table);
  }
  return tables;
}

bool takes_base_parameters(const Function& function) {
  const FunctionRow* row = find_row(function.name);
  return function.base_parameters > 0 || (row != nullptr && row->traits.uses_base_parameters);
}

void add_base(const Mechanism& mechanism, FileContents& contents) {
  const BaseParameters base = base_parameters(mechanism);
  contents.base_count = base.size();
  if (base.size() == 0) return;
  FileTable names{"const char*", "base_parameter_names", "base_parameter_count"};
  for (const int index : base.columns) names.texts.push_back(parameter_name(index, mechanism.base_bodies()));
  contents.base_tables.push_back(names);
  FileTable values{"Real", "base_parameter_values", "base_parameter_count"};
  for (const Number& number : base_values(mechanism, base)) {
    const std::optional<double> value = value_of(number);
    if (!value) return;
    values.numbers.push_back(*value);
  }
  contents.base_tables.push_back(values);
}

// Names of functions and their tables. Those of links may become the same: the later one is numbered.
class NamesOfFile {
 public:
  std::string taken(const std::string& wanted) {
    std::string name = cpp_identifier(wanted);
    const std::string begin = name + (name.ends_with('_') ? "" : "_");
    for (int k = 2; !taken_.insert(name).second; ++k) name = begin + std::to_string(k);
    return name;
  }

 private:
  std::set<std::string> taken_;
};

// Which entries of the function's matrices are not always zero.
std::vector<FileTable> zeros_of(const Function& function, const std::string& name, NamesOfFile& names) {
  std::vector<FileTable> tables;
  for (const Output& output : function.outputs) {
    const bool has_rows = output.layout == Layout::matrix || output.layout == Layout::christoffel;
    if (!has_rows || output.entries.empty()) continue;
    const std::string of_output = function.outputs.size() == 1 ? "" : "_" + output.name;
    const std::string of_table = names.taken(name + of_output + "_nonzero");
    FileTable table{"bool", of_table, std::to_string(output.entries.size())};
    for (const NodeId entry : output.entries) table.numbers.push_back(function.graph.is_zero(entry) ? 0 : 1);
    tables.push_back(table);
  }
  return tables;
}

std::vector<FileFunction> functions_of_file(const WrittenCode& code) {
  const bool has_given = language_row(code.options.language).has_given_variants;
  NamesOfFile names;
  std::vector<FileFunction> list;
  for (const Function& function : code.functions) {
    list.push_back({&function, names.taken(function.name)});
    if (has_given) list.back().given = names.taken(list.back().name + "_given");
  }
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!code.options.is_kernel_part(k)) list[k].zeros = zeros_of(*list[k].function, list[k].name, names);
  }
  return list;
}

FileStage stage_of(const Stage& stage, const std::string& name, const std::string& member_of) {
  FileStage result{name, {&stage.make, stage.make.name, {}, name, member_of}, {}};
  NamesOfFile names;
  for (const Function& member : stage.members) {
    result.members.push_back({&member, names.taken(member.name), {}, "", name});
  }
  return result;
}

// close_loops() is there if both functions that it calls are, in full.
void add_closing(const Mechanism& mechanism, const std::vector<Function>& functions, FileContents& contents) {
  const auto is_there = [&](const char* name) {
    return std::any_of(functions.begin(), functions.end(),
                       [name](const Function& each) { return each.name == name && is_whole(each); });
  };
  if (!is_there("loop_closure") || !is_there("loop_step")) return;
  FileLoops loops{"loop_closure", "loop_step"};
  for (const LoopClosure& loop : mechanism.loops) loops.rows += static_cast<int>(loop.rows.size());
  contents.closing = loops;
}

}  // namespace

std::vector<Function> functions_in_text(const WrittenCode& code) {
  std::vector<Function> list = code.functions;
  if (!code.stages) return list;
  const auto add = [&list](const Stage& stage) {
    list.push_back(stage.make);
    list.insert(list.end(), stage.members.begin(), stage.members.end());
  };
  add(code.stages->configuration);
  if (!code.stages->motion.members.empty()) add(code.stages->motion);
  return list;
}

FileContents contents_of(const WrittenCode& code) {
  const Mechanism& mechanism = code.mechanism;
  const EmitOptions& options = code.options;
  FileContents contents;
  contents.form = options.form;
  contents.sines = options.sines;
  contents.is_module = code.is_module;
  const std::string name = cpp_identifier(mechanism.name);
  contents.file_name = options.file_name.empty() ? name : options.file_name;
  contents.name_spaces = {options.name_space};
  if (options.name_space.empty()) contents.name_spaces = {name, name + "_"};
  contents.scalar = options.scalar;
  contents.scalars = {options.scalar};
  contents.scalars.insert(contents.scalars.end(), options.more_scalars.begin(), options.more_scalars.end());
  contents.joints = static_cast<int>(mechanism.joints().size());
  if (mechanism.floating_base) contents.velocities = mechanism.size();
  contents.positions = mechanism.position_count();
  contents.angles = mechanism.angle_count();
  contents.has_positions = mechanism.has_longer_positions();
  contents.tables = tables_of(mechanism);
  if (std::any_of(code.functions.begin(), code.functions.end(), takes_base_parameters)) add_base(mechanism, contents);
  for (const FreeSymbol& symbol : mechanism.symbols) contents.parameters.push_back(cpp_identifier(symbol.name));
  contents.functions = functions_of_file(code);
  if (code.stages) {
    contents.stages.push_back(stage_of(code.stages->configuration, "Configuration", ""));
    if (!code.stages->motion.members.empty()) {
      contents.stages.push_back(stage_of(code.stages->motion, "Motion", "Configuration"));
    }
  }
  add_closing(mechanism, code.functions, contents);
  contents.kernel_parts = options.kernel_parts;
  return contents;
}

}  // namespace flatdyn
