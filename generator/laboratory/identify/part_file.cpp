// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/part_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/diagnostics/version.hpp"

namespace flatdyn {
namespace {

using nlohmann::ordered_json;

constexpr const char* kKind = "part of an identification";
// The version of the file's format: it rises whenever the contents or their meaning change.
constexpr int kVersion = 7;

ordered_json numbers(const Eigen::MatrixXd& upper) {
  ordered_json list = ordered_json::array();
  for (Eigen::Index i = 0; i < upper.rows(); ++i) {
    for (Eigen::Index k = i; k < upper.cols(); ++k) list.push_back(upper(i, k));
  }
  return list;
}

Eigen::MatrixXd upper_triangle(const ordered_json& list, Eigen::Index size) {
  Eigen::MatrixXd upper = Eigen::MatrixXd::Zero(size, size);
  std::size_t at = 0;
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index k = i; k < size; ++k) upper(i, k) = list.at(at++);
  }
  return upper;
}

// The settings on which the parameters behind π_b depend.
ordered_json settings_of_equations(const FurtherParameters& further) {
  return {{"offsets", further.offsets},
          {"springs", further.springs},
          {"friction", static_cast<int>(further.law)},
          {"temperature", further.temperature ? ordered_json(*further.temperature) : ordered_json()}};
}

// The settings that all parts must share to be joined.
ordered_json settings(const StreamOptions& options, const FurtherParameters& further) {
  ordered_json json = {{"parts", options.parts}, {"equations", settings_of_equations(further)}};
  json["band"] = options.band ? ordered_json(*options.band) : ordered_json();
  json["rest_speed"] = options.rest_speed;
  json["decimate"] = options.decimate ? ordered_json(*options.decimate) : ordered_json();
  json["imu"] = options.imu;
  json["clock"] = static_cast<int>(options.clock);
  json["rate"] = options.rate ? ordered_json(*options.rate) : ordered_json();
  return json;
}

ordered_json json_of(const std::vector<ChannelNoise>& channels) {
  ordered_json list = ordered_json::array();
  for (const auto& [step, deviation] : channels) list.push_back({step, deviation});
  return list;
}

std::vector<ChannelNoise> channels_from(const ordered_json& json) {
  std::vector<ChannelNoise> channels;
  for (const ordered_json& each : json) channels.push_back({each.at(0), each.at(1)});
  return channels;
}

ordered_json logs_of(const Measurement& measurement) {
  ordered_json logs = ordered_json::array();
  for (const MeasuredLog& log : measurement.logs) {
    logs.push_back({{"name", log.identity.name},
                    {"bytes", log.identity.bytes},
                    {"beginning", log.identity.beginning},
                    {"dt", log.filter.dt},
                    {"filter_band", log.filter.band},
                    {"decimation", log.filter.decimate},
                    {"differentiations", log.differentiations},
                    {"rest_speed", log.rest_speed},
                    {"q_noise", json_of(log.q_noise)},
                    {"tau_noise", json_of(log.tau_noise)}});
  }
  return logs;
}

std::vector<MeasuredLog> logs_from(const ordered_json& json) {
  std::vector<MeasuredLog> logs;
  for (const ordered_json& log : json) {
    logs.push_back({{log.at("name"), log.at("bytes"), log.at("beginning")},
                    {log.at("dt"), log.at("filter_band"), log.at("decimation")},
                    log.at("differentiations").get<std::vector<int>>(),
                    log.at("rest_speed"),
                    channels_from(log.at("q_noise")),
                    channels_from(log.at("tau_noise"))});
  }
  return logs;
}

struct Part {
  std::filesystem::path file;
  int part = 0, parts = 0;
  ordered_json settings;
  Measurement measurement;
};

Measurement measurement_of(const ordered_json& json, const TorqueEquations& equations) {
  Measurement result;
  result.observations.parameters = equations.parameters();
  for (int i = 0; i < equations.equations(); ++i) {
    const std::vector<int>& columns = equations.columns()[static_cast<std::size_t>(i)];
    const ordered_json& joint = json.at("joints").at(static_cast<std::size_t>(i));
    const auto size = static_cast<Eigen::Index>(columns.size()) + 1;
    result.observations.joints.push_back({columns, upper_triangle(joint.at("R"), size), joint.at("rows").get<long>()});
  }
  for (const ordered_json& each : json.at("instants")) {
    EquationInstant instant{each.at(0), each.at(1), each.at(2), each.at(3), each.at(4), each.at(5)};
    instant.entries = each.at(6).get<std::vector<double>>();
    instant.right = each.at(7).get<std::vector<double>>();
    instant.used = each.at(8).get<std::vector<std::uint8_t>>();
    instant.run = each.at(9);
    instant.measured_rates = each.at(10).get<std::vector<double>>();
    instant.fast = each.at(11).get<std::vector<double>>();
    result.observations.instants.push_back(std::move(instant));
  }
  result.observations.stride = json.at("stride");
  result.count = {json.at("lines"),        json.at("used"), json.at("gaps"),
                  json.at("interpolated"), json.at("lost"), json.at("repeated")};
  result.logs = logs_from(json.at("logs"));
  set_shapes(result);
  return result;
}

ordered_json json_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) {
    // If no file matches, a shell passes its pattern on as it is.
    const bool is_pattern = file.string().find_first_of("*?[") != std::string::npos;
    throw Failure(FailureKind::io, fmt::format("{}: cannot be read", file.string()),
                  is_pattern ? "no file has such a name: make the parts with --data LOG --part k/N -o FILE" : "");
  }
  const ordered_json json = ordered_json::parse(stream, nullptr, false);
  return json.is_object() ? json : ordered_json::object();
}

// Reads a whole number from 1 to `most`.
long whole_number(const ordered_json& json, long most) {
  const double value = json.is_number_integer() ? json.get<double>() : 0;
  if (value < 1 || value > static_cast<double>(most)) throw std::invalid_argument("number");
  return static_cast<long>(value);
}

std::string names_of(const std::vector<MeasuredLog>& logs) {
  constexpr std::size_t kMost = 5;
  std::vector<std::string> names;
  for (const MeasuredLog& log : logs) {
    if (names.size() == kMost) return fmt::format("{}, ...", fmt::join(names, ", "));
    names.push_back(fmt::format("{} ({} bytes)", log.identity.name, log.identity.bytes));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::optional<Part> read_part(const std::filesystem::path& file, const TorqueEquations& equations,
                              Diagnostics& diagnostics) {
  const Place place{file.string(), 0};
  const ordered_json json = json_of(file);
  try {
    if (json.at("kind") != kKind) throw std::invalid_argument("kind");
    const ordered_json version = json.value("version", ordered_json());
    if (version != kVersion) {
      diagnostics.error(place,
                        fmt::format("the part was made by another version of flatdyn: its contents have version {}, "
                                    "and this one reads version {}",
                                    version.is_null() ? "0" : version.dump(), kVersion),
                        "make all parts again by this version: flatdyn identify ROBOT --data LOG --part k/N -o FILE");
      return std::nullopt;
    }
    if (json.at("model") != equations.model().fingerprint()) {
      diagnostics.error(place, "the part was made with another robot, other parameters or another gravity",
                        "give --merge the robot and the options that the parts were made with");
      return std::nullopt;
    }
    if (json.at("settings").at("equations") != settings_of_equations(equations.further())) {
      diagnostics.error(place, "the part was made with other parameters than these: offsets, springs or friction",
                        "give --merge the same --offsets, --springs, --friction and --temperature as the parts");
      return std::nullopt;
    }
    const long parts = whole_number(json.at("settings").at("parts"), kMostParts);
    const long part = whole_number(json.at("part"), parts);
    return Part{file, static_cast<int>(part), static_cast<int>(parts), json.at("settings"),
                measurement_of(json, equations)};
  } catch (const std::exception&) {
    diagnostics.error(place, "this is no part of an identification, or it is not whole",
                      "make it again: flatdyn identify ROBOT --data LOG --part k/N -o FILE");
    return std::nullopt;
  }
}

void check_complete(const std::vector<Part>& parts, Diagnostics& diagnostics) {
  const Part& first = parts.front();
  std::map<int, const Part*> seen;
  for (const Part& part : parts) {
    const Place place{part.file.string(), 0};
    if (part.settings != first.settings) {
      diagnostics.error(place, fmt::format("made with other options than {}", first.file.string()),
                        "the same N, --band, --decimate, --rest-speed, --resample, --rate and --imu for all parts");
    } else if (part.measurement.logs != first.measurement.logs) {
      diagnostics.error(place,
                        fmt::format("made from other logs than {}: {} instead of {}", first.file.string(),
                                    names_of(part.measurement.logs), names_of(first.measurement.logs)),
                        "the same logs for all parts");
    } else if (const auto [at, is_new] = seen.emplace(part.part, &part); !is_new) {
      diagnostics.error(place, fmt::format("part {} is there twice, also as {}", part.part, at->second->file.string()));
    }
  }
  constexpr std::size_t kMostNamed = 20;
  std::vector<int> missing;
  for (int k = 1; k <= first.parts && missing.size() <= kMostNamed; ++k) {
    if (seen.count(k) == 0) missing.push_back(k);
  }
  if (missing.empty() || diagnostics.has_errors()) return;
  const bool more = missing.size() > kMostNamed;
  if (more) missing.pop_back();
  diagnostics.error({},
                    fmt::format("missing: part {}{} of {}", fmt::join(missing, ", "), more ? ", ..." : "", first.parts),
                    fmt::format("make it again with --part {}/{}", missing.front(), first.parts));
}

}  // namespace

std::string part_text(const Measurement& measurement, const TorqueEquations& equations, const StreamOptions& options) {
  ordered_json json = {{"kind", kKind},
                       {"version", kVersion},
                       {"flatdyn", kProgramVersion},
                       {"model", equations.model().fingerprint()},
                       {"part", options.part},
                       {"settings", settings(options, equations.further())},
                       {"logs", logs_of(measurement)},
                       {"lines", measurement.count.lines},
                       {"used", measurement.count.used},
                       {"gaps", measurement.count.gaps},
                       {"interpolated", measurement.count.interpolated},
                       {"repeated", measurement.count.repeated},
                       {"lost", measurement.count.lost}};
  for (const JointObservations& joint : measurement.observations.joints) {
    json["joints"].push_back({{"rows", joint.rows}, {"R", numbers(joint.R)}});
  }
  json["stride"] = measurement.observations.stride;
  json["instants"] = ordered_json::array();
  for (const EquationInstant& each : measurement.observations.instants) {
    json["instants"].push_back({each.log, each.index, each.time, each.q, each.qd, each.qdd, each.entries, each.right,
                                each.used, each.run, each.measured_rates, each.fast});
  }
  return json.dump() + "\n";
}

Measurement merge_parts(const std::vector<std::filesystem::path>& files, const TorqueEquations& equations,
                        Diagnostics& diagnostics) {
  std::vector<Part> parts;
  for (const std::filesystem::path& file : files) {
    if (std::optional<Part> part = read_part(file, equations, diagnostics)) parts.push_back(std::move(*part));
  }
  if (!parts.empty()) check_complete(parts, diagnostics);
  if (diagnostics.has_errors()) return {};
  std::vector<Measurement> measurements;
  for (Part& part : parts) measurements.push_back(std::move(part.measurement));
  Measurement whole = joined(measurements);
  leave_out_short_motions(whole.observations, whole.count.used);
  return whole;
}

}  // namespace flatdyn
