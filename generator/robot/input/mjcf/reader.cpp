// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/reader.hpp"

#include <algorithm>

#include "robot/input/mjcf/actuators.hpp"
#include "robot/input/mjcf/bodies.hpp"
#include "robot/input/mjcf/equalities.hpp"
#include "robot/input/mjcf/expansion.hpp"
#include "robot/input/mjcf/floating.hpp"
#include "robot/input/mjcf/inertials.hpp"
#include "robot/input/mjcf/keyframe.hpp"
#include "robot/input/mjcf/names.hpp"
#include "robot/input/mjcf/tendons.hpp"

namespace flatdyn {

namespace {

std::ptrdiff_t error_count(const Diagnostics& diagnostics) {
  return std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                       [](const Diagnostic& each) { return each.severity == Severity::error; });
}

}  // namespace

void read_mjcf(const std::string& text, const std::string& file, ReadContext& context, Robot& robot) {
  const std::optional<XmlDocument> document = parse_xml(text, file, kMjcfForm, context.diagnostics);
  if (!document || refuse_content_beside(*document, kMjcfForm, context.diagnostics)) return;
  context.mjcf_was_read = true;
  FileNode tree = mjcf_tree(document->root, context, robot);
  check_mjcf_names(tree, context.diagnostics);
  const std::ptrdiff_t errors = error_count(context.diagnostics);
  expand_mjcf(tree, file, context, robot);
  if (error_count(context.diagnostics) > errors) return;  // what is not copied or attached would be missed below
  const MjcfDefaults defaults(tree, context.diagnostics);
  const MjcfValues values(defaults, context);
  const MjcfSettings settings = mjcf_settings(tree, values, robot);
  MjcfModel model{tree, values, settings, robot, RobotBuilder(context, robot)};
  robot.name = tree.value("model");
  robot.in_degrees = robot.in_degrees || settings.angles.degrees;
  read_mjcf_bodies(model);
  add_mjcf_inertias(model);
  read_mjcf_tendons(model);
  read_mjcf_actuators(model);
  read_mjcf_equalities(model);
  read_mjcf_keyframe(model);
  take_mjcf_free_joints(model);  // leaves joints out, so that indices of others change
  add_mjcf_tendons(model);
  refuse_mjcf_flags(tree, values, robot);
}

}  // namespace flatdyn
