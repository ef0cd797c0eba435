// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "code/walk.hpp"

namespace flatdyn {
namespace {

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
struct Called {
  std::size_t first = 0, last = 0;  // its parts, counted from 1
  std::string name;
  std::set<std::string> arguments;
};

// A statement and the variables that it makes and needs, by number.
struct PartStep {
  const code::Statement* statement = nullptr;
  std::optional<int> makes;
  std::vector<int> needs;
  std::vector<std::string> arguments;
  int lines = 0;
};

class Cutter {
 public:
  explicit Cutter(const LongBody& body) : body_(body) {
    for (const code::Statement& each : body.statements) add_step(each);
    first_use_.assign(variables_.size(), steps_.size());
    last_use_.assign(variables_.size(), 0);
    place_.resize(variables_.size());
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      for (const int variable : steps_[k].needs) {
        at(first_use_, variable) = std::min(at(first_use_, variable), k);
        at(last_use_, variable) = k;
      }
    }
  }

  Parts run(int most_calls) {
    for (std::size_t first = 0; first < steps_.size();) {
      const std::size_t number = calls_.size() + 1;
      const std::string name = fmt::format("{}_part_{}", body_.name, number);
      const std::size_t last = end_of_part(first, name);
      keep(first, last);
      definitions_.push_back(part(first, last, name));
      calls_.push_back({number, number, name, arguments(first, last)});
      first = last;
    }
    while (calls_.size() > static_cast<std::size_t>(most_calls)) gather();
    Parts parts{std::move(definitions_), {}, places_.length()};
    for (const Called& call : calls_) parts.calls.emplace_back(statement(call, false));
    for (code::Part& part : parts.definitions) {
      for (code::Argument& each : part.arguments) {
        if (each.name == kKept) each.length = static_cast<std::size_t>(parts.kept);
      }
    }
    return parts;
  }

 private:
  template <class T>
  static auto at(std::vector<T>& values, int variable) -> decltype(values[0]) {
    return values[static_cast<std::size_t>(variable)];
  }

  void add_step(const code::Statement& statement) {
    PartStep step{&statement, {}, {}, {}, body_.length.lines_of(statement)};
    code::Names names = code::names_in(statement);
    for (const std::string& name : names.variables) step.needs.push_back(number_of(name));
    step.arguments = std::move(names.others);
    if (const auto* define = std::get_if<code::Define>(&statement)) {
      step.makes = number_of(define->constants.front().name);
    }
    steps_.push_back(std::move(step));
  }

  int number_of(const std::string& variable) {
    const auto [place, is_new] = numbers_.emplace(variable, static_cast<int>(variables_.size()));
    if (is_new) variables_.push_back({variable, nullptr});
    const auto source = body_.sources.find(variable);
    if (is_new && source != body_.sources.end()) variables_.back().source = &source->second;
    return place->second;
  }

  // The end of the largest part that starts with this step and is short enough; it has at least one step.
  std::size_t end_of_part(std::size_t first, const std::string& name) const {
    std::size_t last = std::min(steps_.size(), first + static_cast<std::size_t>(body_.most_lines));
    while (last > first + 1) {
      int too_many = estimated_lines(first, last) - body_.most_lines;
      if (too_many <= 0) too_many = body_.length.lines_of(part(first, last, name)) - body_.most_lines;
      if (too_many <= 0) break;
      constexpr int kLinesOfStep = 3;  // with the lines that it needs and keeps
      last = std::max(first + 1, last - static_cast<std::size_t>((too_many + kLinesOfStep - 1) / kLinesOfStep));
    }
    return last;
  }

  // The lines of the steps, which each value that is kept makes longer by one: printing them all takes long.
  int estimated_lines(std::size_t first, std::size_t last) const {
    int lines = 0;
    for (std::size_t k = first; k < last; ++k) {
      const std::optional<int>& made = steps_[k].makes;
      const bool is_both = made && is_kept(*made, last) && first_use_[static_cast<std::size_t>(*made)] < last;
      lines += steps_[k].lines + (is_both ? 1 : 0);
    }
    return lines;
  }

  const code::Expression* source_of(int variable) const {
    return variables_[static_cast<std::size_t>(variable)].source;
  }

  bool is_kept(int variable, std::size_t last) const {
    return source_of(variable) == nullptr && last_use_[static_cast<std::size_t>(variable)] >= last;
  }

  // The variables that the steps need and do not make, in the order of their first use.
  std::vector<int> given(std::size_t first, std::size_t last) const {
    std::set<int> known;
    std::vector<int> result;
    for (std::size_t k = first; k < last; ++k) {
      for (const int variable : steps_[k].needs) {
        if (known.insert(variable).second) result.push_back(variable);
      }
      if (steps_[k].makes) known.insert(*steps_[k].makes);
    }
    return result;
  }

  code::Expression source(int variable) const {
    if (const code::Expression* known = source_of(variable)) return *known;
    return kept(variable);
  }

  // As long as it has no place, one whose text is the longest.
  code::Element kept(int variable) const {
    const std::optional<int>& place = place_[static_cast<std::size_t>(variable)];
    return {kKept, place ? *place : static_cast<int>(variables_.size())};
  }

  std::set<std::string> arguments(std::size_t first, std::size_t last) const {
    std::set<std::string> names;
    const code::Statement reads = reads_of(first, last);
    for (const std::string& name : code::names_in(reads).others) names.insert(name);
    for (std::size_t k = first; k < last; ++k) {
      names.insert(steps_[k].arguments.begin(), steps_[k].arguments.end());
      if (steps_[k].makes && is_kept(*steps_[k].makes, last)) names.insert(kKept);
    }
    return names;
  }

  code::Define reads_of(std::size_t first, std::size_t last) const {
    code::Define reads;
    for (const int variable : given(first, last)) {
      reads.constants.push_back({variables_[static_cast<std::size_t>(variable)].name, source(variable)});
    }
    return reads;
  }

  code::Part part(std::size_t first, std::size_t last, const std::string& name) const {
    code::Part result{name, passed(arguments(first, last)), {}};
    code::Define reads = reads_of(first, last);
    if (!reads.constants.empty()) result.statements.emplace_back(std::move(reads));
    for (std::size_t k = first; k < last; ++k) add_statements(steps_[k], last, result.statements);
    return result;
  }

  // A definition is also kept, or only kept, if later parts need its value.
  void add_statements(const PartStep& step, std::size_t last, code::Statements& statements) const {
    const int variable = step.makes.value_or(-1);
    const bool is_used = !step.makes || first_use_[static_cast<std::size_t>(variable)] < last;
    if (is_used) statements.push_back(*step.statement);
    if (!step.makes || !is_kept(variable, last)) return;
    const code::Define::Constant& made = std::get<code::Define>(*step.statement).constants.front();
    const code::Expression value = is_used ? code::Expression(code::Variable{made.name}) : made.value;
    statements.emplace_back(code::Store{{kept(variable)}, value});
  }

  std::vector<code::Argument> passed(const std::set<std::string>& names) const {
    std::vector<code::Argument> list;
    for (const code::Argument& argument : body_.arguments) {
      if (names.count(argument.name) != 0) list.push_back(argument);
    }
    return list;
  }

  code::CallPart statement(const Called& call, bool by_part) const {
    return {call.name, passed(call.arguments), by_part};
  }

  // Assigns places in the array. A part reads before it keeps anything, so the places of values that it reads last are
  // free for those that it keeps.
  void keep(std::size_t first, std::size_t last) {
    for (const int variable : given(first, last)) {
      if (source_of(variable) == nullptr && !is_kept(variable, last)) places_.give_back(at(place_, variable).value());
    }
    for (std::size_t k = first; k < last; ++k) {
      const std::optional<int> made = steps_[k].makes;
      if (made && is_kept(*made, last)) at(place_, *made) = places_.take();
    }
  }

  // Replaces as many calls as fit by one call of a new function.
  void gather() {
    constexpr int kBesides = 3;  // lines of the head and the closing brace
    const auto room = static_cast<std::size_t>(std::max(2, (body_.most_lines - kBesides) / 2));
    std::vector<Called> gathered;
    for (std::size_t k = 0; k < calls_.size(); k += room) {
      const std::size_t end = std::min(calls_.size(), k + room);
      Called all{calls_[k].first, calls_[end - 1].last, "", {}};
      all.name = fmt::format("{}_parts_{}_to_{}", body_.name, all.first, all.last);
      code::Statements calls;
      for (std::size_t i = k; i < end; ++i) {
        all.arguments.insert(calls_[i].arguments.begin(), calls_[i].arguments.end());
        calls.emplace_back(statement(calls_[i], true));
      }
      definitions_.push_back({all.name, passed(all.arguments), std::move(calls)});
      gathered.push_back(std::move(all));
    }
    calls_ = std::move(gathered);
  }

  struct VariableOfBody {
    std::string name;
    const code::Expression* source;  // nullptr: a part makes it
  };

  const LongBody& body_;
  std::vector<PartStep> steps_;
  std::unordered_map<std::string, int> numbers_;
  std::vector<VariableOfBody> variables_;
  std::vector<std::size_t> first_use_, last_use_;  // steps, by variable
  std::vector<std::optional<int>> place_;          // by variable
  Places places_;
  std::vector<Called> calls_;
  std::vector<code::Part> definitions_;
};

}  // namespace

Parts in_parts(const LongBody& body, int most_calls) { return Cutter(body).run(most_calls); }

}  // namespace flatdyn
