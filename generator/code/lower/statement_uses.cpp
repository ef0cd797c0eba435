// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/statement_uses.hpp"

#include <algorithm>

#include "code/lower/each_operand.hpp"
#include "code/lower/schedule.hpp"

namespace flatdyn {
namespace {

class Reader {
 public:
  Reader(const Function& function, const Schedule& schedule, const std::vector<Statement>& statements)
      : graph_(function.graph),
        schedule_(schedule),
        statements_(statements),
        value_(schedule.is_variable.size(), kUnknown) {}

  StatementUses run(const std::vector<NodeId>& at_the_end) {
    uses_.users.resize(statements_.size());
    for (std::size_t k = 0; k < statements_.size(); ++k) {
      if (statements_[k].targets.empty()) value_[static_cast<std::size_t>(statements_[k].node)] = static_cast<int>(k);
    }
    for (const Statement& statement : statements_) add(statement);
    for (const NodeId id : at_the_end) read(id);
    sort_found();
    uses_.read_at_the_end = found_;
    return std::move(uses_);
  }

 private:
  static constexpr int kUnknown = -1;

  void add(const Statement& statement) {
    const bool makes = statement.targets.empty();
    if (makes) {
      for_each_operand(graph_[statement.node], [this](NodeId operand) { read(operand); });
    } else {
      read(statement.node);
    }
    sort_found();
    for (const int value : found_) uses_.users[static_cast<std::size_t>(value)].push_back(uses_.statements());
    uses_.needs.emplace_back(found_.begin(), found_.end());
    uses_.makes.push_back(makes);
    found_.clear();
  }

  void sort_found() {
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  }

  // Collects the variables in the node's expression.
  void read(NodeId id) {
    if (!schedule_.is_variable[static_cast<std::size_t>(id)]) {
      for_each_operand(graph_[id], [this](NodeId operand) { read(operand); });
      return;
    }
    int& value = value_[static_cast<std::size_t>(id)];
    if (value == kUnknown) {
      value = static_cast<int>(uses_.users.size());
      uses_.users.emplace_back();
    }
    found_.push_back(value);
  }

  const Graph& graph_;
  const Schedule& schedule_;
  const std::vector<Statement>& statements_;
  std::vector<int> value_;  // by id
  std::vector<int> found_;
  StatementUses uses_;
};

}  // namespace

StatementUses uses_of(const Function& function, const Schedule& schedule, const std::vector<Statement>& statements,
                      const std::vector<NodeId>& at_the_end) {
  return Reader(function, schedule, statements).run(at_the_end);
}

}  // namespace flatdyn
