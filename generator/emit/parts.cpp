// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "emit/writer.hpp"

namespace flatdyn {
namespace {

constexpr const char* kKeptValue = "kept";

int lines_of(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

// The places of an array, the first free one first.
class Places {
 public:
  int take() {
    if (free_.empty()) return length_++;
    const int place = *free_.begin();
    free_.erase(free_.begin());
    return place;
  }
  void give_back(int place) { free_.insert(place); }
  int length() const { return length_; }

 private:
  std::set<int> free_;
  int length_ = 0;
};

// A call of a function of the same file: its name and arguments.
struct Call {
  std::size_t first = 0, last = 0;  // its parts, counted from 1
  std::string name;
  std::set<std::string> arguments;
};

class Cutter {
 public:
  explicit Cutter(const LongBody& body)
      : body_(body), first_use_(body.variables.size(), body.steps.size()), last_use_(body.variables.size(), 0) {
    for (std::size_t k = 0; k < body_.steps.size(); ++k) {
      for (const NodeId id : body_.steps[k].needs) {
        at(first_use_, id) = std::min(at(first_use_, id), k);
        at(last_use_, id) = k;
      }
    }
  }

  Parts run(int most_calls) {
    for (std::size_t first = 0; first < body_.steps.size();) {
      const std::size_t number = calls_.size() + 1;
      const std::string name = fmt::format("{}_part_{}", body_.name, number);
      const std::size_t last = end_of_part(first, name);
      keep(first, last);
      define(text(first, last, name));
      calls_.push_back({number, number, name, arguments(first, last)});
      first = last;
    }
    while (calls_.size() > static_cast<std::size_t>(most_calls)) gather();
    Parts parts{std::move(definitions_), {}, places_.length()};
    for (const Call& call : calls_) parts.calls.push_back(statement(call, true, kStatementIndent));
    return parts;
  }

 private:
  template <class T>
  static auto at(std::vector<T>& values, NodeId id) -> decltype(values[0]) {
    return values[static_cast<std::size_t>(id)];
  }

  // The end of the largest part that starts with this step and is short enough; it has at least one step.
  std::size_t end_of_part(std::size_t first, const std::string& name) const {
    std::size_t last = std::min(body_.steps.size(), first + static_cast<std::size_t>(body_.most_lines));
    while (last > first + 1) {
      const int too_many = lines_of(text(first, last, name)) - body_.most_lines;
      if (too_many <= 0) break;
      constexpr int kLinesOfStep = 3;  // with the lines that it needs and keeps
      last = std::max(first + 1, last - static_cast<std::size_t>((too_many + kLinesOfStep - 1) / kLinesOfStep));
    }
    return last;
  }

  bool is_kept(NodeId id, std::size_t last) const {
    return body_.sources.count(id) == 0 && last_use_[static_cast<std::size_t>(id)] >= last;
  }

  // The variables that the steps need and do not make, in the order of their first use.
  std::vector<NodeId> given(std::size_t first, std::size_t last) const {
    std::set<NodeId> known;
    std::vector<NodeId> result;
    for (std::size_t k = first; k < last; ++k) {
      for (const NodeId id : body_.steps[k].needs) {
        if (known.insert(id).second) result.push_back(id);
      }
      if (body_.steps[k].makes) known.insert(*body_.steps[k].makes);
    }
    return result;
  }

  std::string source(NodeId id) const {
    const auto known = body_.sources.find(id);
    return known != body_.sources.end() ? known->second.text : place_text(id);
  }

  std::string place_text(NodeId id) const {
    // As long as it has no place, the longest text possible.
    const auto place = place_.find(id);
    return place == place_.end() ? fmt::format("{}[{}]", kKeptValue, last_use_.size())
                                 : fmt::format("{}[{}]", kKeptValue, place->second);
  }

  std::set<std::string> arguments(std::size_t first, std::size_t last) const {
    std::set<std::string> names;
    for (const NodeId id : given(first, last)) {
      const auto known = body_.sources.find(id);
      names.insert(known == body_.sources.end() ? kKeptValue : known->second.argument);
    }
    for (std::size_t k = first; k < last; ++k) {
      const PartStep& step = body_.steps[k];
      names.insert(step.arguments.begin(), step.arguments.end());
      if (step.makes && is_kept(*step.makes, last)) names.insert(kKeptValue);
    }
    return names;
  }

  std::string text(std::size_t first, std::size_t last, const std::string& name) const {
    std::vector<std::string> reads;
    for (const NodeId id : given(first, last)) {
      reads.push_back(body_.variables[static_cast<std::size_t>(id)] + " = " + source(id));
    }
    std::string code;
    if (!reads.empty()) code += list_line(body_.dialect.constant(), reads, ";", kStatementIndent);
    for (std::size_t k = first; k < last; ++k) {
      const PartStep& step = body_.steps[k];
      code += step.makes ? definition(step, last) : step.code;
    }
    return head(name, arguments(first, last)) + (has_fused(code) ? body_.dialect.fused_begin() : "") + code + "}\n";
  }

  // "const Scalar x = …;" and "kept[7] = x;", or only one of them.
  std::string definition(const PartStep& step, std::size_t last) const {
    const NodeId id = *step.makes;
    const bool is_used = first_use_[static_cast<std::size_t>(id)] < last;
    const std::string& variable = body_.variables[static_cast<std::size_t>(id)];
    std::string code;
    if (is_used) {
      code += code_line(fmt::format("{}{} = {};", body_.dialect.constant(), variable, step.code), kStatementIndent);
    }
    if (is_kept(id, last)) {
      code += code_line(fmt::format("{} = {};", place_text(id), is_used ? variable : step.code), kStatementIndent);
    }
    return code;
  }

  std::string head(const std::string& name, const std::set<std::string>& arguments) const {
    std::vector<std::string> declared;
    for (const PartArgument& argument : body_.arguments) {
      if (arguments.count(argument.name) != 0) declared.push_back(argument.declared);
    }
    return list_line(body_.dialect.part_begin(name), declared, body_.dialect.function_end(), 0);
  }

  // A call by the robot's own function, or by another part.
  std::string statement(const Call& call, bool by_function, std::size_t indent) const {
    std::vector<std::string> passed;
    for (const PartArgument& argument : body_.arguments) {
      if (call.arguments.count(argument.name) != 0) passed.push_back(by_function ? argument.passed : argument.name);
    }
    const std::string begin = by_function ? body_.dialect.part_call(call.name) : call.name + "(";
    return list_line(begin, passed, ");", indent);
  }

  // Assigns places in the array. A part reads before it keeps anything, so the places of values that it reads last are
  // free for those that it keeps.
  void keep(std::size_t first, std::size_t last) {
    for (const NodeId id : given(first, last)) {
      if (body_.sources.count(id) == 0 && !is_kept(id, last)) places_.give_back(place_.at(id));
    }
    for (std::size_t k = first; k < last; ++k) {
      const std::optional<NodeId> made = body_.steps[k].makes;
      if (made && is_kept(*made, last)) place_[*made] = places_.take();
    }
  }

  void define(const std::string& function) {
    definitions_ += (definitions_.empty() ? "" : "\n") + (body_.dialect.before_part() + function);
  }

  // Replaces as many calls as fit by one call of a new function.
  void gather() {
    constexpr int kBesides = 3;  // lines of the head and the closing brace
    const auto room = static_cast<std::size_t>(std::max(2, (body_.most_lines - kBesides) / 2));
    std::vector<Call> gathered;
    for (std::size_t k = 0; k < calls_.size(); k += room) {
      const std::size_t end = std::min(calls_.size(), k + room);
      Call all{calls_[k].first, calls_[end - 1].last, "", {}};
      all.name = fmt::format("{}_parts_{}_to_{}", body_.name, all.first, all.last);
      std::string calls;
      for (std::size_t i = k; i < end; ++i) {
        all.arguments.insert(calls_[i].arguments.begin(), calls_[i].arguments.end());
        calls += statement(calls_[i], false, kStatementIndent);
      }
      define(head(all.name, all.arguments) + calls + "}\n");
      gathered.push_back(std::move(all));
    }
    calls_ = std::move(gathered);
  }

  const LongBody& body_;
  std::vector<std::size_t> first_use_, last_use_;  // steps, by id
  std::map<NodeId, int> place_;
  Places places_;
  std::vector<Call> calls_;
  std::string definitions_;
};

}  // namespace

Parts in_parts(const LongBody& body, int most_calls) { return Cutter(body).run(most_calls); }

}  // namespace flatdyn
