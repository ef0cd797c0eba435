// SPDX-License-Identifier: GPL-2.0-or-later
// Certificates: proven bounds of the rounding errors of emitted functions, derived from the text itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "code/readback/straight_line.hpp"
#include "graph/function.hpp"
#include "proof/certify/effort.hpp"
#include "proof/certify/gappa.hpp"
#include "proof/certify/observed.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct CertifyOptions {
  std::string scalar = "double";
  double trigonometry_ulp = 1;  // allowed error of sines and cosines, in last places of numbers below 1
  ObservedOptions observed;
  int effort = kUsualEffort;  // the effort spent on making bounds small
  double time_limit = 120;    // time limit for one Gappa script, s; 0: Gappa is not asked
};

// The allowed error of sines and cosines as an absolute error.
double trigonometry_error(const CertifyOptions& options);

// One number that a function computes; it may be stored in several entries.
struct CertifiedOutput {
  std::string name;                    // "tau[0]"
  std::vector<std::string> also;       // further entries with the same number: "B[7]" for B[1]
  std::string unit;                    // "N m"; empty: SI
  std::string result;                  // the name of its operation's result in the scripts: "x35"
  double bound = 0;                    // bound of the absolute error
  double observed = 0;                 // largest absolute error seen
  double reference_error = 0;          // bound of the error of the values that errors are measured against
  int terms = 0;                       // number of errors that add up to the bound
  std::optional<double> effort;        // the effort limit of the joint, if the output is a torque
  Verdict verdict = Verdict::refused;  // Gappa's verdict
};

// An operation that reads arguments, as the scripts know it.
struct CertifiedLeaf {
  int operation = 0;  // the number in the names of errors: r0
  // "s_2", "qd_1"; for the sine of an angle that is computed "s_4" and "sin(x10)", for a sign "x7" and "sign(qd_1)",
  // for a constant "k7" and "0.333".
  std::string name, meaning;
  std::optional<double> limit;  // the largest size of an input
  // For a constant: the absolute values of the model's numbers that it represents, "1/3"; none: it represents none.
  std::vector<std::string> exact;
};

struct CertifiedFunction {
  std::string name;
  std::vector<CertifiedLeaf> leaves;
  std::vector<CertifiedOutput> outputs;
  std::vector<GappaScript> scripts;
  double seconds = 0;        // time to derive the bounds, s
  double gappa_seconds = 0;  // time that Gappa took, s
};

struct Certificate {
  std::string robot, scalar;
  bool by_gappa = false;  // Gappa was asked and is available
  CertifyOptions options;
  std::vector<CertifiedFunction> functions;
};

// Certifies the functions in a header's text, which must have exactly these functions. The exact value is that of the
// function's graph, with the model's exact numbers. Throws Failure(unsupported) if there is no bound: for inputs
// without limits, and for divisions.
Certificate certify(const Mechanism& mechanism, const std::vector<Function>& functions, const std::string& header,
                    const CertifyOptions& options, Progress& progress);

// Certifies one function as it is executed.
CertifiedFunction certify(const Mechanism& mechanism, const Function& function, const StraightLine& text,
                          const CertifyOptions& options, Progress& progress);

// The name of an entry in a certificate: "tau[0]"; "U" for a scalar output.
std::string certified_name(const Output& output, std::size_t entry);

// Whether a bound is wrong: Gappa was asked and refuses it, or a larger error was observed.
bool is_refuted(const Certificate& certificate);

}  // namespace flatdyn
