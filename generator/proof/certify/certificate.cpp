// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/diagnostics/diagnostics.hpp"
#include "code/emit/literals.hpp"
#include "code/languages/readers.hpp"
#include "code/readback/emitted_text.hpp"
#include "functions/units.hpp"
#include "proof/certify/error_terms.hpp"
#include "proof/certify/gappa_script.hpp"
#include "proof/certify/model_constants.hpp"

namespace flatdyn {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

RoundingModel rounding_model(const ModelConstants& constants, const RoundingFormat& format,
                             const CertifyOptions& options) {
  return {format, trigonometry_error(options),
          [&constants, &format](double literal) { return constants.error(literal, format); }};
}

bool is_torque(const Output& output) { return output.quantity == OutputQuantity::joint_torque; }

std::optional<double> effort_of(const Mechanism& mechanism, const Output& output, int entry) {
  if (!is_torque(output)) return std::nullopt;
  const std::optional<Value>& limit = mechanism.joint(entry).limits.effort;
  if (!limit || has_symbols(limit->number) || vanishes(limit->number)) return std::nullopt;
  return std::abs(nearest_double(limit->number));
}

// The extra bits of the type that errors are measured in: long double has 11 bits more than double, double has 29 more
// than float; two are reserved for the accumulation of errors.
int bits_more(const RoundingFormat& format) { return format.scalar == "float" ? 27 : 9; }

bool asks_gappa(const CertifyOptions& options) { return options.time_limit > 0 && has_gappa(); }

class Certifier {
 public:
  Certifier(const Mechanism& mechanism, const Function& function, const StraightLine& text,
            const CertifyOptions& options)
      : mechanism_(mechanism),
        function_(function),
        format_(rounding_format(options.scalar)),
        options_(options),
        constants_(function),
        analysis_(with_constants_unshared(text, [this](double literal) { return constants_.is_ambiguous(literal); }),
                  rounding_model(constants_, format_, options), input_limits(mechanism, options.scalar),
                  std::make_unique<MotionRecogniser>(mechanism, input_limits(mechanism, options.scalar),
                                                     [this](double literal) { return constants_.exact_size(literal); }),
                  options.effort) {
    result_.name = function.name;
  }

  CertifiedFunction run(Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    progress.step("bounding the errors of " + function_.name);
    find_leaves();
    find_outputs();
    result_.scripts = rounding_scripts(function_.name, analysis_, format_);
    roundings_ = result_.scripts.size();
    for (std::size_t k = 0; k < operations_.size(); ++k) bound(k);
    result_.seconds = seconds_since(start);
    progress.step("looking for errors of " + function_.name);
    const std::vector<double> observed =
        observed_errors(mechanism_, analysis_.text(), operations_, function_, exact_, format_, observed_options());
    for (std::size_t k = 0; k < observed.size(); ++k) result_.outputs[k].observed = observed[k];
    if (asks_gappa(options_)) ask(progress);
    return std::move(result_);
  }

 private:
  // The sines of <cmath> use up a part of the allowed error, and adding the rest of it rounds.
  ObservedOptions observed_options() const {
    constexpr double kOfCmath = 1, kOfSum = 1;
    ObservedOptions options = options_.observed;
    options.sine_error = std::ldexp(std::max(0.0, options_.trigonometry_ulp - kOfCmath - kOfSum), -format_.precision);
    return options;
  }

  // Lists inputs, sines, cosines, signs and constants.
  void find_leaves() {
    const InputLimits limit = input_limits(mechanism_, options_.scalar);
    for (int k = 0; k < analysis_.executed(); ++k) {
      const Operation& operation = analysis_.text()[k];
      const std::string name = name_in_scripts(analysis_, k);
      if (operation.step == Step::input) {
        result_.leaves.push_back({k, name, name, limit(operation.input), {}});
      } else if (operation.step == Step::sine || operation.step == Step::cosine) {
        const char* const of = operation.step == Step::sine ? "sin" : "cos";
        const bool is_of_joint = operation.a < 0;
        result_.leaves.push_back(
            {k, name, is_of_joint ? name : fmt::format("{}({})", of, name_in_scripts(analysis_, operation.a)), {}, {}});
      } else if (operation.step == Step::sign) {
        result_.leaves.push_back({k, name, "sign(" + name_in_scripts(analysis_, operation.a) + ")", {}, {}});
      } else if (operation.step == Step::constant) {
        result_.leaves.push_back({k, name, decimal_literal(operation.value), {}, {}});
        for (const Rational& exact : constants_.exact_sizes(operation.value)) {
          result_.leaves.back().exact.push_back(exact.str());
        }
      }
    }
  }

  // Lists the outputs: one for every operation whose result is stored in an entry.
  void find_outputs() {
    for (std::size_t o = 0; o < function_.outputs.size(); ++o) {
      const Output& output = function_.outputs[o];
      for (std::size_t e = 0; e < output.entries.size(); ++e) {
        const int operation = analysis_.text().outputs[o][e];
        if (operation >= 0) find_output(output, e, operation);
      }
    }
  }

  void find_output(const Output& output, std::size_t entry, int operation) {
    const bool is_zero = function_.graph.is_zero(output.entries[entry]);
    if (is_zero) return;
    const auto known = std::find(operations_.begin(), operations_.end(), operation);
    if (known != operations_.end()) {
      result_.outputs[static_cast<std::size_t>(known - operations_.begin())].also.push_back(
          certified_name(output, entry));
      return;
    }
    CertifiedOutput found;
    found.name = certified_name(output, entry);
    found.unit = unit_of(mechanism_, function_, output, static_cast<std::size_t>(entry));
    found.result = name_in_scripts(analysis_, operation);
    found.effort = effort_of(mechanism_, output, static_cast<int>(entry));
    result_.outputs.push_back(std::move(found));
    operations_.push_back(operation);
    joints_.push_back(is_torque(output) ? std::optional(static_cast<int>(entry)) : std::nullopt);
    exact_.push_back(output.entries[entry]);
  }

  void bound(std::size_t k) {
    CertifiedOutput& output = result_.outputs[k];
    const OutputError error = analysis_.error_of(operations_[k], joints_[k]);
    output.bound = error.bound;
    output.terms = error.terms();
    output.reference_error =
        std::ldexp(error.bound, -bits_more(format_)) +
        std::ldexp(analysis_.norms().largest(operations_[k]), -format_.precision - bits_more(format_));
    if (!error.groups.empty()) result_.scripts.push_back(sum_script(function_.name, output.name, output.unit, error));
  }

  // Asks Gappa for verdicts. An output is proven if its sum and all roundings are, or if it cannot have an error.
  void ask(Progress& progress) {
    progress.step("asking Gappa about " + function_.name);
    const auto start = std::chrono::steady_clock::now();
    const std::vector<Verdict> verdicts = run_gappa(result_.scripts, options_.time_limit);
    Verdict of_roundings = Verdict::proven;
    for (std::size_t k = 0; k < roundings_; ++k) {
      if (verdicts[k] != Verdict::proven) of_roundings = verdicts[k];
    }
    std::size_t next = roundings_;
    for (CertifiedOutput& output : result_.outputs) {
      const Verdict of_sum = output.terms == 0 ? Verdict::proven : verdicts[next++];
      output.verdict = of_roundings == Verdict::proven ? of_sum : of_roundings;
    }
    result_.gappa_seconds = seconds_since(start);
  }

  const Mechanism& mechanism_;
  const Function& function_;
  const RoundingFormat& format_;
  CertifyOptions options_;
  ModelConstants constants_;
  ErrorAnalysis analysis_;
  CertifiedFunction result_;
  std::vector<int> operations_;             // by output
  std::vector<std::optional<int>> joints_;  // by output: the joint whose torque it is
  std::vector<NodeId> exact_;               // by output
  std::size_t roundings_ = 0;               // number of scripts about roundings, which come before those of outputs
};

// Says of a function that divides that it does, before limits are asked for that would not help.
void refuse_divisions(const StraightLine& lines) {
  for (int k = 0; k < lines.size(); ++k) {
    if (lines[k].step != Step::divide) continue;
    throw Failure(FailureKind::unsupported, "it divides",
                  "certify bounds sums and products only: name other --functions");
  }
}

}  // namespace

// The error of a sine or cosine; its unit in the last place is that of numbers from 1/2 to 1, as no sine is larger.
double trigonometry_error(const CertifyOptions& options) {
  return std::ldexp(options.trigonometry_ulp, -rounding_format(options.scalar).precision);
}

std::string certified_name(const Output& output, std::size_t entry) {
  return output.layout == Layout::scalar ? output.name : fmt::format("{}[{}]", output.name, entry);
}

CertifiedFunction certify(const Mechanism& mechanism, const Function& function, const StraightLine& text,
                          const CertifyOptions& options, Progress& progress) {
  return Certifier(mechanism, function, text, options).run(progress);
}

Certificate certify(const Mechanism& mechanism, const std::vector<Function>& functions, const std::string& header,
                    const CertifyOptions& options, Progress& progress) {
  const EmittedText text(header, header_reader());
  Certificate result{mechanism.name, options.scalar, asks_gappa(options), options, {}};
  for (std::size_t k = 0; k < functions.size(); ++k) {
    try {
      const StraightLine lines = text.operations(k, functions[k]);
      refuse_divisions(lines);
      result.functions.push_back(certify(mechanism, functions[k], lines, options, progress));
    } catch (const Failure& failure) {
      if (failure.kind() != FailureKind::unsupported) throw;
      throw Failure(failure.kind(), fmt::format("{} cannot be certified: {}", functions[k].name, failure.what()),
                    failure.hint());
    }
  }
  return result;
}

bool is_refuted(const Certificate& certificate) {
  for (const CertifiedFunction& function : certificate.functions) {
    for (const CertifiedOutput& output : function.outputs) {
      if (certificate.by_gappa && output.verdict == Verdict::refused) return true;
      if (output.observed > output.bound + output.reference_error) return true;
    }
  }
  return false;
}

}  // namespace flatdyn
