// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/stage_text.hpp"

#include <map>

#include "code/emit/writer.hpp"
#include "code/lower/names.hpp"
#include "graph/count.hpp"
#include "graph/passes/fuse_products.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {
namespace {

// Gives a field the same name in both stages, and none that the header uses otherwise.
void rename_fields(Stages& stages, const HeaderScope& scope) {
  std::set<std::string> taken = scope.names;
  taken.insert("with");
  for (const Stage* stage : {&stages.configuration, &stages.motion}) {
    for (const Function& member : stage->members) taken.insert(cpp_identifier(member.name));
  }
  NameTable names(taken);
  std::map<std::string, std::string> renamed;
  for (Stage* stage : {&stages.configuration, &stages.motion}) {
    for (std::string& field : stage->fields) {
      if (renamed.count(field) == 0) renamed[field] = names.unique(field);
      field = renamed[field];
    }
  }
}

StageText stage_text(const Stage& stage, const std::string& name, HeaderScope make_scope) {
  HeaderScope member_scope = make_scope;
  member_scope.parameters.clear();  // the parameters that a member needs are stored
  member_scope.enclosing_stage = name;
  member_scope.stored = stage.fields;
  make_scope.made = name;
  make_scope.fields = stage.fields;
  const FunctionText make = function_text(stage.make, stage.make.name, make_scope);
  StageText text{name, make, to_string(operations_as_written(stage.make, make.uses_fma)), {}, ""};
  NameTable names(std::set<std::string>{"with"});
  for (const Function& member : stage.members) {
    text.members.push_back({member, function_text(member, names.unique(member.name), member_scope)});
  }
  if (!stage.fields.empty()) text.fields = list_line(make_scope.dialect.arrays(), stage.fields, ";", kStatementIndent);
  return text;
}

}  // namespace

std::vector<StageText> stage_texts(Stages stages, const HeaderScope& scope) {
  rename_fields(stages, scope);
  std::vector<StageText> texts = {stage_text(stages.configuration, "Configuration", scope)};
  if (stages.motion.members.empty()) return texts;
  HeaderScope motion_scope = scope;
  motion_scope.parameters.clear();
  motion_scope.enclosing_stage = texts.front().name;
  motion_scope.stored = stages.configuration.fields;
  texts.push_back(stage_text(stages.motion, "Motion", motion_scope));
  return texts;
}

}  // namespace flatdyn
