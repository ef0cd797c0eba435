// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/mjcf/reader.hpp"

#include "input/common/xml.hpp"
#include "input/mjcf/actuators.hpp"
#include "input/mjcf/bodies.hpp"
#include "input/mjcf/equalities.hpp"
#include "input/mjcf/inertials.hpp"
#include "input/mjcf/names.hpp"
#include "input/urdf/reader.hpp"

namespace flatdyn {

namespace {

void read_mjcf(const tinyxml2::XMLElement& root, const std::string& file, ReadContext& context, Robot& robot) {
  const MjcfElement tree = mjcf_tree(root, file, context, robot);
  check_mjcf_names(tree, context.diagnostics);
  const MjcfDefaults defaults(tree, context.diagnostics);
  const MjcfValues values(defaults, context);
  const MjcfSettings settings = mjcf_settings(tree, values, robot);
  MjcfModel model{tree, values, settings, robot};
  robot.name = tree.text("model");
  read_mjcf_bodies(model);
  add_mjcf_inertias(model);
  read_mjcf_equalities(model);
  read_mjcf_actuators(model);
  refuse_mjcf_tendons(model);
}

}  // namespace

void read_xml(const std::string& text, const std::string& file, ReadContext& context, Robot& robot) {
  tinyxml2::XMLDocument document;  // resolves no entities of its own but the five of XML; nesting is bounded (100)
  if (!parse_xml(text, file, document, context.diagnostics)) return;
  const tinyxml2::XMLElement& root = *document.RootElement();
  if (std::string_view(root.Name()) != "mujoco") {
    if (!context.options.ignored.empty()) {
      context.diagnostics.error({file, 0}, "--ignore has no effect: it is for MJCF files", "leave it out");
    }
    read_urdf(root, file, context, robot);
  } else if (const tinyxml2::XMLNode* second = content_beside(root)) {
    context.diagnostics.error({file, second->GetLineNum()},
                              "there is something else beside <mujoco>, the outermost element",
                              "an MJCF file is one <mujoco> ... </mujoco>");
  } else {
    read_mjcf(root, file, context, robot);
  }
}

}  // namespace flatdyn
