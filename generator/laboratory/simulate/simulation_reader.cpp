// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/diagnostics/nearest.hpp"
#include "laboratory/simulate/simulation.hpp"
#include "laboratory/trajectory/read_trajectory.hpp"
#include "robot/input/common/units.hpp"
#include "robot/input/csv/table.hpp"
#include "robot/input/toml/parts.hpp"
#include "robot/input/toml/table.hpp"
#include "robot/model/assembly.hpp"

namespace flatdyn {
namespace {

std::vector<double> doubles(const std::vector<Value>& values) {
  std::vector<double> result;
  for (const Value& value : values) result.push_back(nearest_double(value.number));
  return result;
}

constexpr double kShortestPeriod = 1e-7;  // s
constexpr std::size_t kTwist = 6;
constexpr double kPerDegree = 3.141592653589793 / 180;

class SimulationReader {
 public:
  SimulationReader(const std::string& file, const Robot& robot, const Mechanism& mechanism, Simulation& simulation,
                   Diagnostics& diagnostics)
      : file_(file), robot_(robot), mechanism_(mechanism), simulation_(simulation), diagnostics_(diagnostics) {}

  void read(TomlTable table) {
    table.text("description");
    units_.degrees = read_choice(table, "angles", {"rad", "deg"}, diagnostics_) == "deg";
    positive(table, "duration", 0, simulation_.duration);
    positive(table, "rate", 0, simulation_.rate);
    simulation_.at_limits =
        choice<AtLimits>(table, "joint_limits",
                         {{"ignore", AtLimits::go_on}, {"stop", AtLimits::stop}, {"end", AtLimits::end}})
            .value_or(simulation_.at_limits);
    if (std::optional<TomlTable> start = table.table("start")) read_start(*start);
    if (std::optional<TomlTable> torque = table.table("torque")) read_torque(*torque);
    table.reject_unknown_keys();
    if (simulation_.at_limits != AtLimits::go_on) check_ranges(table);
  }

 private:
  std::size_t joints() const { return mechanism_.joints().size(); }

  // The path of a file that this one names.
  std::filesystem::path beside(const std::string& name) {
    const std::filesystem::path path = std::filesystem::path(file_).parent_path() / name;
    simulation_.files.push_back(path.string());
    return path;
  }

  void positive(TomlTable& table, const char* key, double least, double& result) {
    const std::optional<std::vector<Value>> given = table.numbers(key, 1);
    if (!given) return;
    result = nearest_double(given->front().number);
    if (result > least) return;
    const std::string wrong = least > 0 ? fmt::format("is not above {}", least) : "is not positive";
    diagnostics_.error(given->front().place, fmt::format("{}: {} {}", key, result, wrong), "e.g. 0.001");
  }

  // Sets the entries of the joints, behind those of a floating base.
  void set_joints(const std::vector<Value>& given, std::vector<double>& result) const {
    const std::vector<double> numbers = doubles(given);
    std::copy(numbers.begin(), numbers.end(), result.begin() + mechanism_.base_bodies());
  }

  void by_joint(TomlTable& table, const char* key, std::vector<double>& result) {
    if (const auto given = table.numbers(key, joints())) set_joints(*given, result);
  }

  // Converts positions or rates to rad or m and s.
  using InSi = Number (*)(const Number&, const Body&, const Units&, const Spot&, Diagnostics&);
  void motion(TomlTable& table, const char* key, InSi in_si, std::vector<double>& result) {
    auto given = table.numbers(key, joints());
    if (!given) return;
    for (std::size_t i = 0; i < joints(); ++i) {
      Value& value = (*given)[i];
      const Body& body = mechanism_.joints()[i];
      const Spot spot{value.place, fmt::format("{}, joint \"{}\"", key, body.joint)};
      value.number = in_si(value.number, body, units_, spot, diagnostics_);
    }
    set_joints(*given, result);
  }

  template <class Choice>
  std::optional<Choice> choice(TomlTable& table, const char* key, const std::map<std::string, Choice>& choices) {
    const std::optional<std::string> text = table.text(key);
    if (!text) return std::nullopt;
    const auto found = choices.find(*text);
    if (found != choices.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, meaning] : choices) names.push_back(name);
    diagnostics_.error(table.place_of(key), fmt::format("{}: \"{}\" is none of its values", key, *text),
                       hint_for_unknown(*text, names, "values"));
    return std::nullopt;
  }

  // q with a quaternion (w, x, y, z) for each spherical joint.
  void read_positions(TomlTable& table) {
    if (!mechanism_.has_spherical_joints()) return motion(table, "q", position_in_si, simulation_.q);
    const auto given = list_of(table, "q", static_cast<std::size_t>(mechanism_.position_count()));
    if (!given) return;
    for (int k = mechanism_.base_bodies(); k < mechanism_.size(); ++k) {
      const double entry = (*given)[static_cast<std::size_t>(mechanism_.position_of(k))];
      const bool is_in_degrees = units_.degrees && !mechanism_.joint(k).prismatic && !mechanism_.is_of_spherical(k);
      simulation_.q[static_cast<std::size_t>(k)] = is_in_degrees ? entry * kPerDegree : entry;
    }
    for (std::size_t j = 0; j < simulation_.w.size(); ++j) {
      const int first = mechanism_.spherical[j];
      const auto entries = given->begin() + mechanism_.quaternion_of(first);
      const std::array<double, 4> unit = unit_quaternion(table, "q", {entries[0], entries[1], entries[2], entries[3]},
                                                         "from child axes to parent axes");
      simulation_.w[j] = unit[0];
      std::copy(unit.begin() + 1, unit.end(), simulation_.q.begin() + first);
    }
  }

  // A quaternion (w, x, y, z) that is a unit one but for rounding to a few digits, at unit length.
  std::array<double, 4> unit_quaternion(const TomlTable& table, const char* key, std::array<double, 4> entries,
                                        const char* what) {
    constexpr double kNearlyOne = 1e-3;
    double square = 0;
    for (const double x : entries) square += x * x;
    const double length = std::sqrt(square);
    if (!(std::abs(length - 1) <= kNearlyOne)) {
      diagnostics_.error(table.place_of(key), fmt::format("{}: a quaternion's length is {:.6g}, not 1", key, length),
                         fmt::format("write the unit quaternion w, x, y, z {}", what));
    }
    for (double& x : entries) x /= length;
    return entries;
  }

  void read_start(TomlTable table) {
    read_positions(table);
    motion(table, "qd", rate_in_si, simulation_.qd);
    if (mechanism_.floating_base) read_start_of_base(table);
    table.reject_unknown_keys();
  }

  void read_start_of_base(TomlTable& table) {
    BasePose& base = simulation_.base;
    if (const auto p = list_of(table, "base_position", base.position.size())) {
      std::copy(p->begin(), p->end(), base.position.begin());
    }
    if (const auto v = list_of(table, "base_velocity", kTwist)) std::copy(v->begin(), v->end(), simulation_.qd.begin());
    const auto given = list_of(table, "base_orientation", base.orientation.size());
    if (!given) return;
    base.orientation = unit_quaternion(table, "base_orientation", {(*given)[0], (*given)[1], (*given)[2], (*given)[3]},
                                       "from base axes to world axes");
  }

  // A list of this many numbers.
  std::optional<std::vector<double>> list_of(TomlTable& table, const char* key, std::size_t count) {
    const bool is_list = table.is_list(key);
    const auto given = table.numbers(key, count);
    if (!given) return std::nullopt;
    if (!is_list) {
      diagnostics_.error(table.place_of(key), fmt::format("{}: it is no list", key),
                         fmt::format("write {} numbers", count));
      return std::nullopt;
    }
    return doubles(*given);
  }

  void read_torque(TomlTable table) {
    by_joint(table, "constant", simulation_.constant);
    if (mechanism_.floating_base) {
      const auto on_base = list_of(table, "on_base", kTwist);
      if (on_base) std::copy(on_base->begin(), on_base->end(), simulation_.constant.begin());
    }
    simulation_.saturate = table.boolean("saturate").value_or(false);
    const bool has_efforts = std::any_of(mechanism_.joints().begin(), mechanism_.joints().end(),
                                         [](const Body& body) { return body.limits.effort.has_value(); });
    if (simulation_.saturate && !has_efforts) {
      diagnostics_.warning(table.place_of("saturate"), "saturate: no joint has an effort limit", "it has no effect");
    }
    read_samples(table);
    for (const auto& [key, kind] :
         {std::pair{"pd", FeedbackLaw::Kind::pd}, std::pair{"computed_torque", FeedbackLaw::Kind::computed_torque}}) {
      std::optional<TomlTable> law = table.table(key);
      if (!law) continue;
      if (simulation_.samples || simulation_.feedback) {
        diagnostics_.error(law->place(), "torque: two of samples, pd and computed_torque", "keep one of them");
      }
      simulation_.feedback = read_feedback(*law, kind);
      if (mechanism_.floating_base && kind == FeedbackLaw::Kind::computed_torque) {
        diagnostics_.error(law->place(), "computed_torque: motors do not drive a floating base",
                           "take pd, or hold the base still with --base fixed");
      }
    }
    table.reject_unknown_keys();
  }

  void read_samples(TomlTable& table) {
    const std::optional<std::string> name = table.text("samples");
    const auto between = choice<TorqueSamples::Between>(
        table, "between", {{"hold", TorqueSamples::Between::hold}, {"linear", TorqueSamples::Between::linear}});
    if (!name) {
      if (between)
        diagnostics_.error(table.place_of("between"), "torque: between what?", "give samples = \"FILE.csv\"");
      return;
    }
    simulation_.samples = read_torques(beside(*name).string(), mechanism_, diagnostics_);
    if (between) simulation_.samples->between = *between;
  }

  FeedbackLaw read_feedback(TomlTable table, FeedbackLaw::Kind kind) {
    FeedbackLaw law{kind, {}, {}, simulation_.q, false, std::nullopt};
    law.kp.assign(simulation_.q.size(), 0);
    law.kd = law.kp;
    by_joint(table, "kp", law.kp);
    by_joint(table, "kd", law.kd);
    motion(table, "position", position_in_si, law.position);
    if (const std::optional<std::string> name = table.text("trajectory")) {
      if (table.has("position")) {
        diagnostics_.error(table.place_of("trajectory"), "trajectory and position: one of them", "leave one out");
      }
      if (mechanism_.floating_base) {
        diagnostics_.error(table.place_of("trajectory"), "trajectory: not supported yet with a floating base",
                           "give position, or hold the base still with --base fixed");
        return law;
      }
      law.trajectory = read_trajectory(beside(*name), robot_, mechanism_, diagnostics_);
    }
    if (kind == FeedbackLaw::Kind::pd) law.gravity = table.boolean("gravity").value_or(false);
    refuse_spherical(table, law);
    if (table.has("period")) positive(table, "period", kShortestPeriod, simulation_.period);
    table.reject_unknown_keys();
    return law;
  }

  // Gains on positions, computed torque and trajectories are for joints with one axis.
  void refuse_spherical(const TomlTable& table, const FeedbackLaw& law) {
    const auto has_gain = [&law](int first) {
      return std::any_of(law.kp.begin() + first, law.kp.begin() + first + 3, [](double gain) { return gain != 0; });
    };
    const std::vector<int>& spherical = mechanism_.spherical;
    if (std::any_of(spherical.begin(), spherical.end(), has_gain)) {
      diagnostics_.error(table.place_of("kp"), "kp: a spherical joint has no position to which a gain leads",
                         "write 0 for its three entries; kd brakes it");
    }
    if (!spherical.empty() && (law.trajectory || law.kind == FeedbackLaw::Kind::computed_torque)) {
      diagnostics_.error(table.place(), "computed torque and trajectories are not supported yet with spherical joints",
                         "take pd with kd, or samples");
    }
  }

  void check_ranges(const TomlTable& table) {
    bool is_any = false;
    for (std::size_t i = 0; i < joints(); ++i) {
      const Body& body = mechanism_.joints()[i];
      const double q = simulation_.q[i + static_cast<std::size_t>(mechanism_.base_bodies())];
      is_any = is_any || body.limits.lower || body.limits.upper;
      const double lower = body.limits.lower ? nearest_double(body.limits.lower->number) : q;
      const double upper = body.limits.upper ? nearest_double(body.limits.upper->number) : q;
      if (body.limits.lower && body.limits.upper && lower >= upper) {
        diagnostics_.error(table.place_of("joint_limits"),
                           fmt::format("joint_limits: joint \"{}\" has no room between them", body.joint),
                           "hold it with --fix or [locked] of a scene, or leave joint_limits out");
      } else if (q < lower || q > upper) {
        diagnostics_.error(table.place_of("start"),
                           fmt::format("start: joint \"{}\" is at {}, outside of its limits", body.joint, q),
                           "give q in [start], or leave joint_limits out");
      }
    }
    if (!is_any) {
      diagnostics_.warning(table.place_of("joint_limits"), "joint_limits: no joint has limits", "it has no effect");
    }
    for (const LoopClosure& loop : mechanism_.loops) {
      for (const int p : loop.dependent) warn_of_idle_limits(table, mechanism_.joint_at(p));
    }
  }

  void warn_of_idle_limits(const TomlTable& table, const Body& dependent) {
    if (!dependent.limits.lower && !dependent.limits.upper) return;
    diagnostics_.warning(
        table.place_of("joint_limits"),
        fmt::format("joint_limits: joint \"{}\" follows from a closed loop, and goes beyond its limits",
                    dependent.joint),
        "limit the independent joints so that it does not");
  }

  const std::string& file_;
  const Robot& robot_;
  const Mechanism& mechanism_;
  Simulation& simulation_;
  Diagnostics& diagnostics_;
  Units units_;
};

void warn_of_times(const TorqueSamples& samples, const std::string& column, const Place& place,
                   Diagnostics& diagnostics) {
  if (samples.times.size() < 2) return;
  const double step = (samples.times.back() - samples.times.front()) / static_cast<double>(samples.times.size() - 1);
  if (step >= kFarApart) warn_of_time_unit(step, unit_by_size(step), column, place, diagnostics);
}

}  // namespace

TorqueSamples read_torques(const std::string& file, const Mechanism& mechanism, Diagnostics& diagnostics) {
  TorqueSamples samples;
  Diagnostics found;
  CsvTable table = read_csv(file, found);
  CsvHeading heading = table.heading(file, mechanism, found);
  const std::optional<CsvTime> time = heading.require_time();
  const int base = mechanism.base_bodies();
  const std::vector<CsvSource> torques = heading.require(CsvQuantity::tau, "torques", {base}),
                               on_base = heading.all_or_none(CsvQuantity::tau, {0, base});
  heading.finish();
  for (const std::vector<CsvSource>* each : {&torques, &on_base}) check_entries(table, *each, heading, file, found);
  if (time) samples.times = times_of(table, *time, file, found);
  for (const Diagnostic& diagnostic : found.all()) diagnostics.add(diagnostic);
  if (found.has_errors()) return samples;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (row > 0 && samples.times[row] <= samples.times[row - 1]) {
      diagnostics.error({file, table.lines[row]},
                        fmt::format("time {} does not come after {}", samples.times[row], samples.times[row - 1]),
                        "sort the rows by time");
      return samples;
    }
    std::vector<double> values;
    for (const std::vector<CsvSource>* each : {&on_base, &torques}) {
      for (const CsvSource& source : *each) values.push_back(nearest_double(exact_value(table, row, source)));
    }
    values.insert(values.begin(), static_cast<std::size_t>(mechanism.size()) - values.size(), 0.0);
    samples.torques.push_back(std::move(values));
  }
  const bool has_unit = time->clock.per_second > 1;
  if (!has_unit) warn_of_times(samples, heading.name(time->column), {file, table.heading_line}, diagnostics);
  return samples;
}

Simulation resting(const Robot& robot, const Mechanism& mechanism) {
  Simulation simulation;
  const std::vector<double> positions = assembled_positions(robot, mechanism);
  simulation.q.assign(static_cast<std::size_t>(mechanism.size()), 0);
  for (int i = mechanism.base_bodies(); i < mechanism.size() && mechanism.has_loops(); ++i) {
    simulation.q[static_cast<std::size_t>(i)] = positions[static_cast<std::size_t>(mechanism.position_of(i))];
  }
  simulation.w.assign(mechanism.spherical.size(), 1);
  simulation.qd.assign(simulation.q.size(), 0);
  simulation.constant = simulation.qd;
  return simulation;
}

void read_simulation(const std::string& file, const Robot& robot, const Mechanism& mechanism, Simulation& simulation,
                     Diagnostics& diagnostics) {
  const std::optional<std::string> text = file_text(file, diagnostics);
  if (!text) return;
  simulation.files = {file};
  const ReadOptions options;
  ReadContext context{options, diagnostics, SymbolTable(file), {}, 0, {}, {}};
  const TomlSource source(*text, file, context, "docs/simulation-format.md");
  const std::optional<toml::table> root = source.parse();
  if (root) SimulationReader(file, robot, mechanism, simulation, diagnostics).read(TomlTable(*root, "", source));
}

}  // namespace flatdyn
