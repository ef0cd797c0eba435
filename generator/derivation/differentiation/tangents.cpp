// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/differentiation/tangents.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

// An entry of a × e_k, as a multiple of an entry of a; 0: it is zero.
struct CrossEntry {
  int of = 0, sign = 0;
};

CrossEntry cross_entry(int entry, int k) {
  if (entry == k) return {};
  const int of = 3 - entry - k;
  return {of, (entry + 1) % 3 == of ? 1 : -1};
}

}  // namespace

Tangents::Tangents(const Mechanism& mechanism, const std::vector<InputKind>& arguments, int base_parameters)
    : mechanism_(mechanism) {
  for (const InputKind kind : arguments) {
    switch (argument_row(kind).length) {
      case ArgumentLength::positions:
      case ArgumentLength::velocities:
        add(kind, mechanism.size());
        break;
      case ArgumentLength::wrench:
        add(kind, kWrenchLength);
        break;
      case ArgumentLength::vector:
        add(kind, kVectorLength);
        break;
      case ArgumentLength::base_parameters:
        add(kind, base_parameters);
        break;
      case ArgumentLength::one:
        add(kind, 1);
        break;
      case ArgumentLength::own:
        break;
      case ArgumentLength::symbols:
      case ArgumentLength::none:
        throw Failure(FailureKind::bug, std::string("no directions of argument ") + argument_row(kind).name);
    }
  }
  if (!mechanism.symbols.empty()) add(InputKind::parameter, static_cast<int>(mechanism.symbols.size()));
}

void Tangents::add(InputKind kind, int length) {
  blocks_.push_back({kind, count_, length});
  count_ += length;
}

const TangentBlock* Tangents::find(InputKind argument) const {
  const auto found = std::find_if(blocks_.begin(), blocks_.end(),
                                  [argument](const TangentBlock& block) { return block.kind == argument; });
  return found == blocks_.end() ? nullptr : &*found;
}

bool Tangents::commute(InputKind a, InputKind b) const {
  if (mechanism_.has_loops() && a != b) {
    const auto is_one = [a, b](InputKind kind) { return a == kind || b == kind; };
    if (is_one(InputKind::q) && is_one(InputKind::parameter)) return false;
  }
  const auto turns = [](InputKind kind) { return kind == InputKind::q || kind == InputKind::g_b; };
  const bool are_g_b = a == InputKind::g_b && b == InputKind::g_b;
  return !mechanism_.has_quasi_velocities() || !turns(a) || !turns(b) || are_g_b;
}

std::vector<Tangents::Rate> Tangents::rates_of(Input input, Graph& graph) const {
  std::vector<Rate> rates;
  for (const TangentBlock& block : blocks_) {
    if (block.kind == InputKind::q && input.kind == InputKind::q) {
      add_rates_of_position(input.index, block.first, graph, rates);
    } else if (block.kind == input.kind) {
      rates.push_back({graph.constant(1), block.first + input.index});
    } else if (block.kind == InputKind::q && input.kind == InputKind::g_b) {
      for (int k = 0; k < kVectorLength; ++k) {  // g_b × δ
        const CrossEntry entry = cross_entry(input.index, k);
        if (entry.sign == 0) continue;
        rates.push_back(
            {graph.scaled(entry.sign, graph.input({InputKind::g_b, entry.of})), block.first + kVectorLength + k});
      }
    }
  }
  return rates;
}

void Tangents::add_rates_along_loops(int entry, int first, const Graph& graph, std::vector<Rate>& rates) const {
  if (motion_.empty()) throw Failure(FailureKind::bug, "derivatives along closed loops need the loops' motion");
  const auto independent = static_cast<int>(mechanism_.independent.size());
  for (int a = 0; a < independent; ++a) {
    const NodeId rate = motion_[static_cast<std::size_t>(entry * independent + a)];
    if (!graph.is_zero(rate)) rates.push_back({rate, first + mechanism_.base_bodies() + a});
  }
}

// The rates of an entry of a quaternion (w, r): ẇ = -½ r · δ, ṙ = ½ (w δ + r × δ).
void Tangents::add_rates_of_position(int entry, int first, Graph& graph, std::vector<Rate>& rates) const {
  if (mechanism_.has_loops()) {
    add_rates_along_loops(entry, first, graph, rates);
    return;
  }
  if (!mechanism_.is_of_quaternion(entry)) {
    for (int k = mechanism_.base_bodies(); k < mechanism_.size(); ++k) {
      if (!mechanism_.is_of_spherical(mechanism_.body_of(k)) && mechanism_.position_of(k) == entry) {
        rates.push_back({graph.constant(1), first + k});
      }
    }
    return;
  }
  const int body = mechanism_.body_at(entry), w = mechanism_.quaternion_of(body), own = entry - w - 1;
  const int first_of_joint = body + 1 - mechanism_.body(body).spherical;
  const auto half = [&](int of, int sign) {
    return graph.scaled(Rational(sign, 2), graph.input({InputKind::q, w + of}));
  };
  for (int k = 0; k < kVectorLength; ++k) {
    const int direction = first + first_of_joint + k;
    if (own < 0) {
      rates.push_back({half(1 + k, -1), direction});
    } else if (own == k) {
      rates.push_back({half(0, 1), direction});
    } else {
      const CrossEntry across = cross_entry(own, k);
      rates.push_back({half(1 + across.of, across.sign), direction});
    }
  }
}

std::string name_of(const TangentBlock& block) {
  return block.kind == InputKind::parameter ? "parameters" : argument_row(block.kind).name;
}

std::string name_of_second_derivatives(const TangentBlock& a, const TangentBlock& b) {
  return fmt::format("H_{}_{}", name_of(a), name_of(b));
}

std::string words_for(const TangentBlock& block) {
  return block.kind == InputKind::parameter ? "the parameters" : name_of(block);
}

std::string Tangents::words_for_entry(const TangentBlock& block, const std::string& index) const {
  const bool turns = block.kind == InputKind::q && mechanism_.has_quasi_velocities();
  if (block.kind == InputKind::q && mechanism_.has_loops() && !turns) return fmt::format("independent joint {}", index);
  return turns ? fmt::format("q, or a turn, along entry {} of v", index) : fmt::format("{}[{}]", name_of(block), index);
}

std::string Tangents::words_for_all() const {
  std::string text;
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    if (k > 0) text += k + 1 == blocks_.size() ? ", then " : ", ";
    const bool turns = blocks_[k].kind == InputKind::q && mechanism_.has_quasi_velocities();
    const bool follows = blocks_[k].kind == InputKind::q && mechanism_.has_loops() && !turns;
    text += fmt::format("{}{} ({})", words_for(blocks_[k]),
                        turns     ? " along the entries of v"
                        : follows ? " along the independent joints"
                                  : "",
                        blocks_[k].length);
  }
  return text;
}

}  // namespace flatdyn
