// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/stress/plain_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <random>

namespace flatdyn {
namespace {

class RandomSource {
 public:
  explicit RandomSource(unsigned seed) : engine_(seed) {}

  int from(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  bool one_in(int times) { return from(1, times) == 1; }
  PlainVector vector(int size) {
    PlainVector v;
    for (int& entry : v) entry = from(-size, size);
    return v;
  }

 private:
  std::mt19937 engine_;
};

// The kind of robot that all links share.
struct Kind {
  bool is_chain, has_prismatic, is_nice, has_motors, has_friction;
};

// The carrier of a motor: the joint's parent, or a link before it.
int carrier_of(RandomSource& random, const std::vector<PlainLink>& links, int parent) {
  while (parent != 0 && random.one_in(2)) parent = links[static_cast<std::size_t>(parent - 1)].parent;
  return parent;
}

PlainMotor motor_of(RandomSource& random, const std::vector<PlainLink>& links, const PlainLink& link) {
  PlainMotor motor;
  motor.mass = random.from(0, 99);
  motor.inertia = random.from(1, 99);
  motor.ratio = random.from(1, 120) * (random.one_in(4) ? -1 : 1);
  motor.position = random.vector(30);
  if (random.one_in(2)) motor.axis = {random.from(-99, 99), random.from(-99, 99), 100};
  if (random.one_in(3)) motor.carrier = carrier_of(random, links, link.parent);
  return motor;
}

// The parent of the next link: the base, the last link, or one a little before that.
int parent_of(RandomSource& random, const Kind& kind, int links) {
  return kind.is_chain ? links : random.from(std::max(0, links - 2), links);
}

void add_body(RandomSource& random, PlainLink& link) {
  link.mass = random.from(10, 500);
  link.com = random.vector(50);
  for (std::size_t k = 0; k < 3; ++k) {
    link.particles[k] = random.from(10, 99);
    link.arms[k] = random.vector(30);
  }
}

PlainLink link_of(RandomSource& random, const Kind& kind, const std::vector<PlainLink>& before) {
  PlainLink link;
  link.parent = parent_of(random, kind, static_cast<int>(before.size()));
  link.is_prismatic = kind.has_prismatic && random.one_in(3);
  link.has_quarter_turns = kind.is_nice || random.one_in(4);
  link.xyz = random.vector(99);
  if (random.one_in(3)) link.xyz[0] = link.xyz[1] = 0;
  link.rpy = random.vector(link.has_quarter_turns ? 2 : 99);
  if (!link.has_quarter_turns) link.axis = {random.from(-99, 99), random.from(-99, 99), random.one_in(2) ? 100 : -50};
  add_body(random, link);
  if (kind.has_friction) link.viscous = random.from(0, 99);
  if (kind.has_friction && random.one_in(2)) link.coulomb = random.from(1, 99);
  link.has_motor = kind.has_motors && !random.one_in(3);
  if (link.has_motor) link.motor = motor_of(random, before, link);
  return link;
}

// Couples a joint to its neighbours or to all before it, like a gripper's second finger or a belt's angle.
void couple(RandomSource& random, PlainRobot& robot) {
  for (std::size_t k = 1; k < robot.links.size(); ++k) {
    PlainLink& link = robot.links[k];
    if (random.one_in(2)) continue;
    const int before = static_cast<int>(k);
    const int leaders = random.one_in(3) ? 2 : 1;
    const int most = robot.links.size() > 5 ? 1 : 2;  // turns multiply along followers of followers
    for (int i = 0; i < leaders && i < before; ++i) {
      const bool is_whole = !link.is_prismatic && random.one_in(2);
      const int factor = is_whole ? 100 * random.from(-most, most) : random.from(-150, 150);
      const bool slides = robot.links[static_cast<std::size_t>(before - i - 1)].is_prismatic;
      if (factor != 0 && (link.is_prismatic || !slides)) link.follows.push_back({before - i, factor});
    }
    if (link.follows.empty()) continue;
    link.has_coordinate = random.one_in(4);
    if (random.one_in(2)) link.offset = random.from(-99, 99);
  }
}

// A spherical joint has no axis, motor or Coulomb friction.
void make_spherical(PlainLink& link) {
  link.is_spherical = true;
  link.is_prismatic = link.has_motor = false;
  link.motor = {};
  link.coulomb = 0;
  link.axis = {0, 0, 100};
}

// Lets some robots float, and some joints turn in all directions.
void set_free(RandomSource& random, PlainRobot& robot) {
  const auto follows = [](const PlainLink& link) { return !link.follows.empty(); };
  if (random.one_in(3)) add_body(random, robot.base.emplace());
  if (std::any_of(robot.links.begin(), robot.links.end(), follows) || !random.one_in(3)) return;
  for (PlainLink& link : robot.links) {
    if (random.one_in(2)) make_spherical(link);
  }
}

// The integer value / 10^places as text, such as "-0.25".
std::string decimal(std::int64_t value, int places) {
  std::int64_t whole = 1;
  for (int k = 0; k < places; ++k) whole *= 10;
  const std::int64_t size = value < 0 ? -value : value;
  std::string text = fmt::format("{}{}.{:0{}}", value < 0 ? "-" : "", size / whole, size % whole, places);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string hundredths(int value) { return decimal(value, 2); }

std::string list(const PlainVector& v) {
  return fmt::format("[{}, {}, {}]", hundredths(v[0]), hundredths(v[1]), hundredths(v[2]));
}

std::string angles(const PlainLink& link) {
  if (!link.has_quarter_turns) return list(link.rpy);
  const auto turn = [](int quarters) { return quarters == 0 ? "0" : fmt::format("\"{}*pi/2\"", quarters); };
  return fmt::format("[{}, {}, {}]", turn(link.rpy[0]), turn(link.rpy[1]), turn(link.rpy[2]));
}

// The inertia of the particles, Σ m (r·r 1 - r rᵀ), in 1e-6 kg m².
std::int64_t inertia_entry(const PlainLink& link, std::size_t row, std::size_t column) {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlainVector& r = link.arms[k];
    const std::int64_t square = std::int64_t{r[0]} * r[0] + std::int64_t{r[1]} * r[1] + std::int64_t{r[2]} * r[2];
    sum += link.particles[k] * ((row == column ? square : 0) - std::int64_t{r[row]} * r[column]);
  }
  return sum;
}

std::string inertia_of(const PlainLink& link) {
  static constexpr struct {
    const char* key;
    std::size_t row, column;
  } kEntries[] = {{"xx", 0, 0}, {"yy", 1, 1}, {"zz", 2, 2}, {"xy", 0, 1}, {"xz", 0, 2}, {"yz", 1, 2}};
  std::string text;
  for (const auto& entry : kEntries) {
    const std::int64_t value = inertia_entry(link, entry.row, entry.column);
    if (value != 0) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", entry.key, decimal(value, 6));
  }
  return text;
}

std::string link_name(int link) { return link == 0 ? "base" : fmt::format("link{}", link); }

// Writes "key = value", unless it is the default of the file's reader.
class Lines {
 public:
  void add(const std::string& line) { text_ += line + "\n"; }
  void add(const char* key, int value) {
    if (value != 0) add(fmt::format("{} = {}", key, hundredths(value)));
  }
  void add(const char* key, const PlainVector& value, const PlainVector& usual) {
    if (value != usual) add(fmt::format("{} = {}", key, list(value)));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string position_of(const PlainLink& link, int own) {
  std::string text = link.has_coordinate ? fmt::format("joint{}", own) : "";
  for (const PlainFollowing& leader : link.follows) {
    text += fmt::format("{}{}*joint{}", text.empty() ? "" : " + ", hundredths(leader.factor), leader.joint);
  }
  if (link.offset != 0) text += " + " + hundredths(link.offset);
  return text;
}

void add_motor(const PlainMotor& motor, Lines& lines) {
  lines.add("[link.motor]");
  lines.add("mass", motor.mass);
  if (motor.inertia != 0) lines.add("inertia = " + decimal(motor.inertia, 5));
  if (motor.inertia != 0) lines.add("inertia_transverse = " + decimal(motor.inertia, 5));
  lines.add(fmt::format("gear_ratio = {}", motor.ratio));
  lines.add("axis", motor.axis, {0, 0, 100});
  lines.add("position", motor.position, kNoVector);
  if (motor.carrier >= 0) lines.add(fmt::format("carrier = \"{}\"", link_name(motor.carrier)));
}

void add_inertia(const PlainLink& link, Lines& lines) {
  lines.add("mass", link.mass);
  lines.add("com", link.com, kNoVector);
  if (const std::string inertia = inertia_of(link); !inertia.empty()) {
    lines.add(fmt::format("inertia = {{ {} }}\ninertia_about = \"com\"", inertia));
  }
}

void add_link(const PlainLink& link, int before, Lines& lines) {
  lines.add("\n[[link]]");
  if (link.parent != before) lines.add(fmt::format("parent = \"{}\"", link_name(link.parent)));
  if (link.is_prismatic) lines.add("type = \"prismatic\"");
  if (link.is_spherical) lines.add("type = \"spherical\"");
  if (!link.follows.empty()) lines.add(fmt::format("position = \"{}\"", position_of(link, before + 1)));
  lines.add("xyz", link.xyz, kNoVector);
  if (link.rpy != kNoVector) lines.add("rpy = " + angles(link));
  lines.add("axis", link.axis, {0, 0, 100});
  add_inertia(link, lines);
  lines.add("viscous", link.viscous);
  lines.add("coulomb", link.coulomb);
  if (link.has_motor) add_motor(link.motor, lines);
}

}  // namespace

PlainRobot plain_robot(unsigned seed) {
  RandomSource random(seed);
  static constexpr int kJoints[] = {1, 1, 1, 2, 2, 2, 2, 3, 3, 4};
  const int joints = random.one_in(100) ? random.from(5, 8) : kJoints[random.from(0, 9)];
  const Kind kind{random.one_in(2), random.one_in(2), random.one_in(2), random.one_in(2), random.one_in(2)};
  PlainRobot robot{fmt::format("random_{}", seed), {}};
  for (int k = 0; k < joints; ++k) robot.links.push_back(link_of(random, kind, robot.links));
  if (random.one_in(3)) couple(random, robot);
  constexpr unsigned kFreedom = 0x66726565;  // what is drawn before stays what it was without these
  RandomSource freedom(seed ^ kFreedom);
  set_free(freedom, robot);
  return robot;
}

std::string robot_file(const PlainRobot& robot, const std::vector<std::string>& comment) {
  Lines lines;
  for (const std::string& line : comment) lines.add("# " + line);
  lines.add(fmt::format("name = \"{}\"", robot.name));
  if (robot.base) {
    lines.add("\n[base]\nmotion = \"floating\"");
    add_inertia(*robot.base, lines);
  }
  int before = 0;
  for (const PlainLink& link : robot.links) add_link(link, before++, lines);
  return lines.text();
}

}  // namespace flatdyn
