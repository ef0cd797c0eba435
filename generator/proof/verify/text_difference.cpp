// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/text_difference.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace flatdyn {
namespace {

using Words = std::vector<Token>;

// A statement up to its semicolon, up to the brace that opens a body, a brace that closes one, or a directive.
struct TokenStatement {
  Words words;
  int number = 0;  // equal for equal statements
};

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$'; }

// Divides tokens into statements. Braces of values, as in "x[2] = {1, 2};", do not divide.
class Divider {
 public:
  explicit Divider(const Words& words) : words_(words) {}

  std::vector<TokenStatement> run() {
    for (std::size_t k = 0; k < words_.size(); ++k) take(k);
    end();
    return std::move(statements_);
  }

 private:
  void take(std::size_t k) {
    const Token& word = words_[k];
    if (word.is_directive()) end();
    statement_.words.push_back(word);
    if (word.is_directive()) return end();
    if (word.text == "(" || word.text == "[") ++depth_;
    if (word.text == ")" || word.text == "]") --depth_;
    const bool is_opening = word.text == "{", is_closing = word.text == "}";
    if (values_ > 0 || (is_opening && begins_values(k))) {
      values_ += is_opening ? 1 : is_closing ? -1 : 0;
    } else if (is_opening || is_closing || (word.text == ";" && depth_ <= 0)) {
      end();
    }
  }

  bool begins_values(std::size_t k) const {
    const bool is_empty = k + 1 < words_.size() && words_[k + 1].text == "}";
    return is_empty || (k > 0 && (words_[k - 1].text == "=" || words_[k - 1].text == "return"));
  }

  void end() {
    depth_ = values_ = 0;
    if (!statement_.words.empty()) statements_.push_back(std::move(statement_));
    statement_ = {};
  }

  const Words& words_;
  int depth_ = 0, values_ = 0;  // open brackets, and braces of values
  TokenStatement statement_;
  std::vector<TokenStatement> statements_;
};

// The words as one line of text.
std::string as_one_line(const Words& words) {
  constexpr std::size_t kLongest = 200;
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k].text;
    const bool is_tight = word.find_first_of(";,)].") == 0 || word == "::" || word == "->" || word == "[" ||
                          (word == "(" && !text.empty() && is_of_name(text.back()));
    const bool follows_tightly = !text.empty() && (text.back() == '(' || text.back() == '[' || text.back() == '.' ||
                                                   text.ends_with("::") || text.ends_with("->"));
    if (!text.empty() && !is_tight && !follows_tightly) text += ' ';
    text += word;
    if (text.size() > kLongest) return text.substr(0, kLongest) + " …";
  }
  return text;
}

void number_alike(std::vector<TokenStatement>& held, std::vector<TokenStatement>& own) {
  std::map<std::string, int> numbers;
  for (std::vector<TokenStatement>* list : {&held, &own}) {
    for (TokenStatement& statement : *list) {
      std::string key;
      for (const Token& word : statement.words) key += word.text + '\n';
      statement.number = numbers.emplace(key, static_cast<int>(numbers.size())).first->second;
    }
  }
}

// A range of statements that is another one in the other text.
struct Hunk {
  std::size_t held_begin = 0, held_end = 0, own_begin = 0, own_end = 0;
};

// Myers' algorithm: the shortest list of statements to remove and to add.
class StatementDifference {
 public:
  StatementDifference(const std::vector<TokenStatement>& held, const std::vector<TokenStatement>& own)
      : held_(held), own_(own) {}

  // The hunks in order; false: they are too many.
  bool run(std::vector<Hunk>& hunks) {
    const int n = static_cast<int>(held_.size()), m = static_cast<int>(own_.size());
    constexpr int kMost = 400;
    std::vector<int> farthest(2 * kMost + 3, 0);
    for (int d = 0; d <= std::min(n + m, kMost); ++d) {
      for (int k = -d; k <= d; k += 2) {
        int& x = farthest[static_cast<std::size_t>(k + kMost + 1)];
        const int below = farthest[static_cast<std::size_t>(k + kMost)];
        const int above = farthest[static_cast<std::size_t>(k + kMost + 2)];
        x = k == -d || (k != d && below < above) ? above : below + 1;
        while (x < n && x - k < m && held_[at(x)].number == own_[at(x - k)].number) ++x;
        if (x < n || x - k < m) continue;
        farthest_.push_back(farthest);
        trace(d, k, kMost + 1, hunks);
        return true;
      }
      farthest_.push_back(farthest);
    }
    return false;
  }

  Hunk whole() const {
    Hunk hunk{0, held_.size(), 0, own_.size()};
    while (hunk.held_begin < hunk.held_end && hunk.own_begin < hunk.own_end &&
           held_[hunk.held_begin].number == own_[hunk.own_begin].number) {
      ++hunk.held_begin, ++hunk.own_begin;
    }
    return hunk;
  }

 private:
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  // Goes back from the end, and joins neighbouring changes.
  void trace(int d, int k, int middle, std::vector<Hunk>& hunks) const {
    for (; d > 0; --d) {
      const std::vector<int>& before = farthest_[at(d - 1)];
      const int below = before[at(k - 1 + middle)], above = before[at(k + 1 + middle)];
      const bool is_added = k == -d || (k != d && below < above);  // to the own text
      const int x = is_added ? above : below;
      k += is_added ? 1 : -1;
      const int y = x - k;
      const Hunk one{at(x), at(is_added ? x : x + 1), at(y), at(is_added ? y + 1 : y)};
      if (!hunks.empty() && hunks.back().held_begin == one.held_end && hunks.back().own_begin == one.own_end) {
        hunks.back().held_begin = one.held_begin;
        hunks.back().own_begin = one.own_begin;
      } else {
        hunks.push_back(one);
      }
    }
    std::reverse(hunks.begin(), hunks.end());
  }

  const std::vector<TokenStatement>&held_, &own_;
  std::vector<std::vector<int>> farthest_;
};

int line_at(const std::vector<TokenStatement>& statements, std::size_t k) {
  if (k < statements.size()) return statements[k].words.front().line;
  return statements.empty() ? 0 : statements.back().words.back().line;
}

// Two statements, one of which takes the place of the other.
TextDifference changed(const TokenStatement& held, const TokenStatement& own) {
  TextDifference result{
      held.words.front().line, own.words.front().line, "", as_one_line(held.words), as_one_line(own.words), "", ""};
  std::size_t k = 0;
  const std::size_t most = std::min(held.words.size(), own.words.size());
  while (k < most && held.words[k].text == own.words[k].text) ++k;
  if (k < held.words.size()) {
    result.held_word = held.words[k].text;
    result.line = held.words[k].line;
  }
  if (k < own.words.size()) result.own_word = own.words[k].text;
  return result;
}

}  // namespace

std::vector<TextDifference> differences_of(const Words& held_words, const Words& own_words, bool& is_only_first) {
  std::vector<TokenStatement> held = Divider(held_words).run(), own = Divider(own_words).run();
  number_alike(held, own);
  StatementDifference comparison(held, own);
  std::vector<Hunk> hunks;
  std::vector<TextDifference> result;
  if (!comparison.run(hunks)) {
    is_only_first = true;
    const Hunk whole = comparison.whole();
    hunks = {{whole.held_begin, std::min(whole.held_begin + 1, whole.held_end), whole.own_begin,
              std::min(whole.own_begin + 1, whole.own_end)}};
  }
  for (const Hunk& hunk : hunks) {
    std::size_t h = hunk.held_begin, o = hunk.own_begin;
    for (; h < hunk.held_end && o < hunk.own_end; ++h, ++o) {
      if (held[h].number != own[o].number) result.push_back(changed(held[h], own[o]));
    }
    for (; h < hunk.held_end; ++h) {
      result.push_back({line_at(held, h), line_at(own, o), "", as_one_line(held[h].words), "", "", ""});
    }
    for (; o < hunk.own_end; ++o) {
      result.push_back({line_at(held, h), line_at(own, o), "", "", as_one_line(own[o].words), "", ""});
    }
  }
  return result;
}

}  // namespace flatdyn
