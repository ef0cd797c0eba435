// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/known_answers.hpp"

#include <fmt/format.h>

#include <cstring>
#include <map>
#include <type_traits>

#include "code/emit/known_answer.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/angles.hpp"
#include "code/readback/emitted_text.hpp"
#include "code/readback/execute.hpp"

namespace flatdyn {
namespace {

// The known state, and arithmetic with T's rounding.
template <class T>
class KnownArithmetic {
 public:
  using Scalar = T;

  // `angles`: the number of angles with sines and cosines.
  explicit KnownArithmetic(int angles) {
    for (int k = 0; k < angles; ++k) {
      const T t = number(kTangentSeed, k), square = t * t, divisor = T(1) + square;
      sine_.push_back(T(2) * t / divisor);
      cosine_.push_back((T(1) - square) / divisor);
    }
  }

  // Entry k of an array that is filled from a seed.
  T number(std::uint32_t seed, int k) {
    std::vector<T>& numbers = numbers_[seed];
    std::uint32_t& state = states_.emplace(seed, seed).first->second;
    while (static_cast<int>(numbers.size()) <= k) {
      state = state * 1664525U + 1013904223U;
      numbers.push_back((T(state >> 8U) - T(8388608)) / T(8388608));
    }
    return numbers[static_cast<std::size_t>(k)];
  }

  T constant(double value) const { return static_cast<T>(value); }
  T input(const Input& input) { return number(seed_of(input.kind), input.index); }
  T sine(const Input& angle) const { return sine_[static_cast<std::size_t>(angle.index)]; }
  T cosine(const Input& angle) const { return cosine_[static_cast<std::size_t>(angle.index)]; }
  T sine(const T&) const { throw std::logic_error("an angle without an index"); }
  T cosine(const T&) const { throw std::logic_error("an angle without an index"); }
  T divide(const T& a, const T& b) const { return a / b; }
  T sign(const T& x) const { return static_cast<T>((x > 0 ? 1 : 0) - (x < 0 ? 1 : 0)); }
  T sqrt(const T& x) const { return std::sqrt(x); }
  T fused(const T& a, const T& b, const T& c) const { return std::fma(a, b, c); }

 private:
  std::map<std::uint32_t, std::vector<T>> numbers_;
  std::map<std::uint32_t, std::uint32_t> states_;
  std::vector<T> sine_, cosine_;
};

// The operations with every sine and cosine read by the index of its angle.
StraightLine with_given_sines(const StraightLine& lines) {
  StraightLine result;
  for (int k = 0; k < lines.size(); ++k) {
    Operation operation = lines[k];
    if (operation.step == Step::sine || operation.step == Step::cosine) operation.a = -1;
    result.append(operation);
  }
  result.outputs = lines.outputs;
  return result;
}

// Hashes (FNV-1a) as the text does.
template <class T>
std::uint64_t hash_of(T x, std::uint64_t hash) {
  std::conditional_t<sizeof(T) == sizeof(float), std::uint32_t, std::uint64_t> bits = 0;
  if (x < 0 || x >= 0) std::memcpy(&bits, &x, sizeof(bits));
  hash = (hash ^ bits) * 1099511628211U;
  return hash ^ (hash >> 32U);
}

template <class T>
std::string answer(const std::vector<StraightLine>& functions, int angles) {
  KnownArithmetic<T> arithmetic(angles);
  std::uint64_t hash = 14695981039346656037U;
  for (const StraightLine& lines : functions) {
    std::vector<T> values;
    execute(lines, lines.size(), arithmetic, values);
    int place = 0;
    for (const std::vector<int>& output : lines.outputs) {
      for (const int entry : output) {
        const T unwritten = arithmetic.number(0, place++);
        hash = hash_of(entry < 0 ? unwritten : values[static_cast<std::size_t>(entry)], hash);
      }
    }
  }
  return fmt::format("0x{:016x}", hash);
}

}  // namespace

void fill_in_known_answers(const Mechanism& mechanism, const std::vector<Function>& functions,
                           const AnyLanguageReader& language, std::vector<std::string>& texts) {
  if (functions.empty()) return;
  std::string whole;
  for (const std::string& text : texts) whole += text;
  const EmittedText text(whole, language);
  std::vector<StraightLine> operations;
  for (std::size_t k = 0; k < functions.size(); ++k) {
    if (computes_angles(functions[k])) continue;
    operations.push_back(with_given_sines(text.operations(k, functions[k])));
  }
  const int angles = mechanism.position_count() + static_cast<int>(multiples_of_positions(mechanism).size());
  for (const auto& [placeholder, value] : {std::pair(kDoubleAnswer, answer<double>(operations, angles)),
                                           std::pair(kFloatAnswer, answer<float>(operations, angles))}) {
    for (std::string& each : texts) each = with_replaced(std::move(each), placeholder, value);
  }
}

}  // namespace flatdyn
