// SPDX-License-Identifier: GPL-2.0-or-later
// Options of subcommands that read logs of a robot's motion.
#include "base/diagnostics/diagnostics.hpp"
#include "cli/commands.hpp"
#include "laboratory/identify/base_motion.hpp"

namespace flatdyn {
namespace {

ClockChoice clock_choice(const std::string& how) {
  if (how == "auto") return ClockChoice::automatic;
  return how == "stamps" ? ClockChoice::stamped : ClockChoice::counted;
}

}  // namespace

void add_stream_options(CLI::App& command, StreamOptions& options) {
  command
      .add_option("--band", options.band,
                  "pass band of the zero-phase filter; default: 10 Hz where derivatives are missing, else no filter")
      ->check(positive_number())
      ->type_name("HZ");
  command
      .add_option("--decimate", options.decimate,
                  "use every N-th sample; default: three samples per period of the band")
      ->check(positive_number())
      ->type_name("N");
  command
      .add_option("--rest-speed", options.rest_speed,
                  "a joint rests while it is slower than this (rad/s, m/s; one number, or one for each joint): its "
                  "friction may then be anything, and its equation is left out; default: estimated from the log")
      ->delimiter(',')
      ->check(number_between(0, 1e6))
      ->type_name("V[,V...]");
  command
      .add_option_function<std::string>(
          "--resample", [&options](const std::string& how) { options.clock = clock_choice(how); },
          "whether samples are interpolated at their stamps onto even steps: auto (where their times differ by more "
          "than 2 % and positions are smoother so; the default), stamps (always), or off")
      ->check(CLI::IsMember({"auto", "stamps", "off"}))
      ->type_name("HOW");
  command
      .add_option("--rate", options.rate, "the samples a second of a log without times; a column of times is not used")
      ->check(positive_number())
      ->type_name("HZ");
}

void add_imu_option(CLI::App& command, std::string& imu) {
  command
      .add_option("--imu", imu,
                  "the link, fixed to a floating base, whose frame is that of the log's imu_ax to imu_wz; default: the "
                  "base link")
      ->type_name("LINK");
}

void check_imu(const Mechanism& mechanism, const std::string& imu) {
  if (!mechanism.floating_base && !imu.empty()) {
    throw Failure(FailureKind::usage, "--imu is for robots with a floating base", "give --base floating");
  }
  base_sensors(mechanism, imu);
}

}  // namespace flatdyn
