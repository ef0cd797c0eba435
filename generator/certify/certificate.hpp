// SPDX-License-Identifier: GPL-2.0-or-later
// How large the rounding errors of emitted functions can be: proven bounds, from the text itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/effort.hpp"
#include "certify/gappa.hpp"
#include "certify/observed.hpp"
#include "diagnostics/progress.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "readback/straight_line.hpp"

namespace flatdyn {

struct CertifyOptions {
  std::string scalar = "double";
  double trigonometry_ulp = 1;  // what sines and cosines may be off, in last places of numbers below 1
  ObservedOptions observed;
  int effort = kUsualEffort;  // for small bounds
  double time_limit = 120;    // of Gappa for one script, s; 0: it is not asked
};

// The same as an absolute error.
double trigonometry_error(const CertifyOptions& options);

// One number that a function computes; it may go to several entries.
struct CertifiedOutput {
  std::string name;                    // "tau[0]"
  std::vector<std::string> also;       // "B[7]" of B[1]
  std::string unit;                    // "N m"; empty: SI
  double bound = 0;                    // of the absolute error
  double observed = 0;                 // largest absolute error seen
  double doubt = 0;                    // what the values that errors are measured against may be off themselves
  int terms = 0;                       // errors that add up to it
  std::optional<double> effort;        // of a torque: its joint's effort limit
  Verdict verdict = Verdict::refused;  // Gappa's
};

struct CertifiedFunction {
  std::string name;
  std::vector<CertifiedOutput> outputs;
  std::vector<GappaScript> scripts;
  double seconds = 0;        // that the bounds took
  double gappa_seconds = 0;  // that Gappa took
};

struct Certificate {
  std::string robot, scalar;
  bool by_gappa = false;  // it was asked, and is there
  CertifyOptions options;
  std::vector<CertifiedFunction> functions;
};

// Of the functions in the text of a header, which has these functions and no other. The exact value is that of the
// function's graph: with the model's exact numbers. Throws Failure(unsupported) where a bound is out of reach: for
// inputs without limits, and divisions.
Certificate certify(const Mechanism& mechanism, const std::vector<Function>& functions, const std::string& header,
                    const CertifyOptions& options, Progress& progress);

// Of one function, as it is executed.
CertifiedFunction certify(const Mechanism& mechanism, const Function& function, const StraightLine& text,
                          const CertifyOptions& options, Progress& progress);

// How a certificate names an entry: "tau[0]"; "U" of a number.
std::string certified_name(const Output& output, std::size_t entry);

// A bound is wrong: Gappa was asked and refuses it, or a larger error was seen.
bool is_refuted(const Certificate& certificate);

}  // namespace flatdyn
