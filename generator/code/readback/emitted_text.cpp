// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/emitted_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "code/emit/literals.hpp"
#include "code/readback/execution.hpp"
#include "code/readback/language_reader.hpp"
#include "code/readback/scan.hpp"
#include "code/readback/unreadable_text.hpp"

namespace flatdyn {

EmittedText::EmittedText(const std::string& text, AnyLanguageReader language)
    : language_(std::move(language)), tokens_(tokens_of(text)) {
  ScannedText found = language_->scan(tokens_);
  scalar_ = language_->scalar(found);
  verdict_ = language_->verdict(found);
  functions_ = std::move(found.functions);
  parts_ = std::move(found.parts);
  fields_ = std::move(found.fields);
  counts_ = std::move(found.counts);
}

std::string EmittedText::constants() const { return language_->constants(); }

const ScannedCount* EmittedText::count(const std::string& name) const {
  const auto found = counts_.find(name);
  return found == counts_.end() ? nullptr : &found->second;
}

const ScannedCount& EmittedText::count_of_angles() const {
  for (const char* name : {"angle_count", "position_count", "joint_count"}) {
    if (const ScannedCount* found = count(name)) return *found;
  }
  throw Failure(FailureKind::bug, "emitted text cannot be read back: no count of joints");
}

const std::vector<std::string>* EmittedText::fields(const std::string& structure) const {
  const auto found = fields_.find(structure);
  return found == fields_.end() ? nullptr : &found->second;
}

void EmittedText::refuse(std::size_t token, const std::string& what) const {
  if (tokens_.empty()) throw Failure(FailureKind::bug, "emitted text cannot be read back: it is empty");
  const Token& at = tokens_[std::min(token, tokens_.size() - 1)];
  throw UnreadableText(at.line, fmt::format("{} at \"{}\"", what, at.text));
}

// The function with the types of its parameters, which in JavaScript follow from their order.
ScannedFunction EmittedText::as_called(std::size_t k, const Function& like) const {
  ScannedFunction written = functions_.at(k);
  if (language_->names_types()) return written;
  const bool has_symbols = !written.parameters.empty() && written.parameters.front().name == "parameters";
  const bool is_value = written.parameters.size() == like.inputs.size() + (has_symbols ? 1 : 0);
  const bool is_checked = written.end - written.begin > 2 && tokens_[written.end - 3].text == "return";
  written.returns = is_value ? scalar_ : is_checked ? "bool" : "void";
  const std::size_t outputs = is_value ? 0 : like.outputs.size();
  for (std::size_t p = written.parameters.size() - std::min(outputs, written.parameters.size());
       p < written.parameters.size(); ++p) {
    written.parameters[p].is_output = true;
  }
  return written;
}

StraightLine EmittedText::operations(std::size_t k, const Function& like) const {
  const ScannedFunction written = as_called(k, like);
  return Execution(*this, written, like).run();
}

Function EmittedText::read(std::size_t k, const Function& like) const { return graph_of(operations(k, like), like); }

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
    const bool is_scaled = has_scale(function, k);
    result.validity_conditions.push_back(is_scaled ? result.graph.scaled(kPivotSignificance, value) : value);
    if (k >= function.pivot_scales.size()) continue;
    result.pivot_scales.push_back(is_scaled ? image[static_cast<std::size_t>(function.pivot_scales[k])]
                                            : result.validity_conditions.back());
  }
  return result;
}

}  // namespace flatdyn
