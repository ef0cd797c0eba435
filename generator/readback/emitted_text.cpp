// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/emitted_text.hpp"

#include "emit/literals.hpp"
#include "readback/scan.hpp"

namespace flatdyn {

EmittedText::EmittedText(const std::string& text, const std::string& scalar)
    : notation_(notation_of(scalar)), tokens_(tokens_of(text)) {
  ScannedText found = scan(tokens_, scalar);
  functions_ = std::move(found.functions);
  parts_ = std::move(found.parts);
  fields_ = std::move(found.fields);
}

Function as_printed(const Function& function, const std::string& scalar) {
  Graph graph;
  const auto printed = [&scalar](const Rational& value) {
    return Rational(scalar == "float" ? double(float_of(value)) : nearest_double(value));
  };
  std::vector<NodeId> image;
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    Node node = function.graph[id];
    node.value = printed(node.value);
    for (Term& term : node.terms) term.coefficient = printed(term.coefficient);
    image.push_back(graph.copy(node, image));
  }
  Function result = with_graph(function, std::move(graph), image);
  result.validity_conditions.clear();
  result.pivot_scales.clear();
  for (std::size_t k = 0; k < function.validity_conditions.size(); ++k) {
    if (always_holds(function, k)) continue;
    const NodeId value = image[static_cast<std::size_t>(function.validity_conditions[k])];
    result.validity_conditions.push_back(
        k < function.pivot_scales.size() ? result.graph.scaled(kPivotSignificance, value) : value);
  }
  return result;
}

}  // namespace flatdyn
