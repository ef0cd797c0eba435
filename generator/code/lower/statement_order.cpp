// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/statement_order.hpp"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

namespace flatdyn {
namespace {

// An item of a list by statement or value.
template <class List>
decltype(auto) item(List& list, int k) {
  return list[static_cast<std::size_t>(k)];
}

std::vector<int> sizes_of(const std::vector<std::vector<int>>& lists, int count) {
  std::vector<int> sizes;
  for (int k = 0; k < count; ++k) sizes.push_back(static_cast<int>(item(lists, k).size()));
  return sizes;
}

// Statements with ranks, of which the one with the least rank is next. A statement whose rank becomes less is added
// once more; it is passed over when its other entries come up.
template <class Rank>
class Queue {
 public:
  void add(const Rank& rank) {
    ranks_.push_back(rank);
    std::push_heap(ranks_.begin(), ranks_.end(), std::greater<Rank>());
  }
  bool empty() const { return ranks_.empty(); }
  Rank take() {
    std::pop_heap(ranks_.begin(), ranks_.end(), std::greater<Rank>());
    const Rank least = ranks_.back();
    ranks_.pop_back();
    return least;
  }

 private:
  std::vector<Rank> ranks_;
};

// Goes from the last statement to the first. Of the statements whose users all have a place, the one comes next that
// makes fewest values live beyond those that it ends; then the one whose value got its first user last.
class FromTheEnd {
 public:
  explicit FromTheEnd(const StatementUses& uses)
      : uses_(uses),
        users_left_(sizes_of(uses.users, uses.statements())),
        growth_(sizes_of(uses.needs, uses.statements())),
        asked_(uses_.needs.size(), 0),
        is_live_(uses.users.size(), false),
        is_ready_(uses.needs.size(), false) {}

  std::vector<int> run() {
    for (const int value : uses_.read_at_the_end) begin_life(value);
    for (int k = 0; k < uses_.statements(); ++k) {
      if (item(users_left_, k) == 0) make_ready(k);
    }
    while (!ready_.empty()) {
      const int next = -std::get<2>(ready_.take());
      if (!item(is_ready_, next)) continue;
      item(is_ready_, next) = false;
      order_.push_back(next);
      for (const int value : item(uses_.needs, next)) use(value);
    }
    std::reverse(order_.begin(), order_.end());
    return std::move(order_);
  }

 private:
  using Rank = std::tuple<int, int, int>;  // the least one is next

  Rank rank(int k) const { return {item(growth_, k) - (item(is_live_, k) ? 1 : 0), -item(asked_, k), -k}; }

  void make_ready(int k) {
    item(is_ready_, k) = true;
    ready_.add(rank(k));
  }

  void begin_life(int value) {
    if (item(is_live_, value)) return;
    item(is_live_, value) = true;
    for (const int user : item(uses_.users, value)) {
      --item(growth_, user);
      if (item(is_ready_, user)) ready_.add(rank(user));
    }
  }

  void use(int value) {
    begin_life(value);
    if (value >= uses_.statements()) return;
    item(asked_, value) = static_cast<int>(order_.size());
    if (--item(users_left_, value) == 0) make_ready(value);
  }

  const StatementUses& uses_;
  std::vector<int> users_left_;  // by statement
  std::vector<int> growth_;      // by statement: the values it needs that are not live yet
  std::vector<int> asked_;       // by statement: when its value was used last
  std::vector<bool> is_live_;    // by value
  std::vector<bool> is_ready_;   // by statement
  Queue<Rank> ready_;
  std::vector<int> order_;
};

// Goes from the first statement to the last. Of the statements whose needs all have a place, the one comes next that
// ends most lives; ties are in an order that is given.
class FromTheBeginning {
 public:
  FromTheBeginning(const StatementUses& uses, const std::vector<int>& order)
      : uses_(uses),
        users_left_(sizes_of(uses.users, static_cast<int>(uses.users.size()))),
        needs_left_(uses.needs.size(), 0),
        ended_(uses.needs.size(), 0),
        place_(uses.needs.size(), 0),
        is_ready_(uses.needs.size(), false),
        given_(order) {
    for (std::size_t k = 0; k < order.size(); ++k) item(place_, order[k]) = static_cast<int>(k);
    // No statement ends the life of a value that is read at the end.
    for (const int value : uses.read_at_the_end) ++item(users_left_, value);
    for (int k = 0; k < uses.statements(); ++k) {
      const std::vector<int>& needs = item(uses.needs, k);
      item(needs_left_, k) = static_cast<int>(
          std::count_if(needs.begin(), needs.end(), [&uses](int value) { return value < uses.statements(); }));
    }
  }

  std::vector<int> run() {
    for (int k = 0; k < uses_.statements(); ++k) {
      if (item(users_left_, k) == 1) credit_last_user(k);
      if (item(needs_left_, k) == 0) make_ready(k);
    }
    std::vector<int> order;
    while (!ready_.empty()) {
      const int next = item(given_, std::get<1>(ready_.take()));
      if (!item(is_ready_, next)) continue;
      item(is_ready_, next) = false;
      order.push_back(next);
      place(next);
    }
    return order;
  }

 private:
  using Rank = std::tuple<int, int>;

  Rank rank(int k) const { return {(item(uses_.makes, k) ? 1 : 0) - item(ended_, k), item(place_, k)}; }

  void make_ready(int k) {
    item(is_ready_, k) = true;
    ready_.add(rank(k));
  }

  void place(int k) {
    item(needs_left_, k) = kPlaced;
    for (const int value : item(uses_.needs, k)) {
      if (value < uses_.statements() && --item(users_left_, value) == 1) credit_last_user(value);
    }
    if (!item(uses_.makes, k)) return;
    for (const int user : item(uses_.users, k)) {
      if (--item(needs_left_, user) == 0) make_ready(user);
    }
  }

  // The one user that is left ends the value's life. There is no such user if the value is read at the end.
  void credit_last_user(int value) {
    for (const int user : item(uses_.users, value)) {
      if (item(needs_left_, user) == kPlaced) continue;
      ++item(ended_, user);
      if (item(is_ready_, user)) ready_.add(rank(user));
    }
  }

  static constexpr int kPlaced = -1;

  const StatementUses& uses_;
  std::vector<int> users_left_;  // by value
  std::vector<int> needs_left_;  // by statement
  std::vector<int> ended_;       // by statement: lives that it ends
  std::vector<int> place_;       // by statement, in the given order
  std::vector<bool> is_ready_;   // by statement
  const std::vector<int>& given_;
  Queue<Rank> ready_;
};

struct LiveValues {
  long sum = 0;   // over the statements
  long most = 0;  // at once
};

LiveValues live_values(const StatementUses& uses, const std::vector<int>& order) {
  std::vector<std::size_t> born(uses.users.size(), 0), last(uses.users.size(), 0);
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const int value : item(uses.needs, order[k])) item(last, value) = k;
    if (item(uses.makes, order[k])) item(born, order[k]) = item(last, order[k]) = k;
  }
  for (const int value : uses.read_at_the_end) item(last, value) = order.size();
  std::vector<long> change(order.size() + 1, 0);
  for (std::size_t value = 0; value < born.size(); ++value) {
    ++change[born[value]];
    --change[last[value]];
  }
  LiveValues live;
  long now = 0;
  for (const long more : change) {
    now += more;
    live.sum += now;
    live.most = std::max(live.most, now);
  }
  return live;
}

std::vector<int> order_as_given(const StatementUses& uses) {
  std::vector<int> as_given;
  for (int k = 0; k < uses.statements(); ++k) as_given.push_back(k);
  return as_given;
}

}  // namespace

std::vector<int> order_of_fewest_values(const StatementUses& uses) {
  std::vector<int> best = order_as_given(uses);
  long fewest = live_values(uses, best).most;
  const auto consider = [&](const std::vector<int>& order) {
    const long most = live_values(uses, order).most;
    if (most >= fewest) return;
    fewest = most;
    best = order;
  };
  const std::vector<int> from_the_end = FromTheEnd(uses).run();
  consider(FromTheBeginning(uses, best).run());
  consider(from_the_end);
  consider(FromTheBeginning(uses, from_the_end).run());
  return best;
}

long most_live(const StatementUses& uses) { return live_values(uses, order_as_given(uses)).most; }

std::vector<int> order_of_short_lives(const StatementUses& uses) {
  const std::vector<int> as_given = order_as_given(uses);
  // Measured: with fewer values at once, short lives cost more than they save.
  constexpr long kFew = 40;
  const LiveValues given = live_values(uses, as_given);
  if (given.most <= kFew) return as_given;
  std::vector<int> shorter = FromTheBeginning(uses, FromTheEnd(uses).run()).run();
  return live_values(uses, shorter).sum < given.sum ? shorter : as_given;
}

}  // namespace flatdyn
