// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/firmware/target.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

constexpr const char* kArmBranches = "(b(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)|cbn?z)(\\.[nw])?";
constexpr const char* kArmPackages = "gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm make";
constexpr const char* kArmLink = "--specs=nano.specs --specs=rdimon.specs -u _printf_float -T target.ld";

// For RISC-V, picolibc has start-up code and a linker script; the memory is that of qemu's board virt.
constexpr const char* kRiscvBranches = "b(eq|ne|lt|ge|gt|le)(u|z)?";
constexpr const char* kRiscvPackages = "gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc make";
constexpr const char* kRiscvLink =
    "--oslib=semihost --crt0=hosted -Wl,--defsym=__flash=0x80000000,--defsym=__flash_size=4M"
    " -Wl,--defsym=__ram=0x80400000,--defsym=__ram_size=4M,--defsym=__stack_size=64K";

// Functions for double of the run-time ABI for Arm, and of libgcc.
constexpr const char* kArmDouble = "__aeabi_d* | __aeabi_i2d | __aeabi_ui2d | __aeabi_f2d";
constexpr const char* kRiscvDouble = "__*df2 | __*df3 | __float*df | __fix*df*i | __truncdfsf2";

constexpr FirmwareTarget kTargets[] = {
    {"cortex-m4", "arm-none-eabi-", "-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard", kArmLink,
     "qemu-system-arm -M mps2-an386 -nographic -semihosting-config enable=on,target=native -kernel", kArmBranches,
     kArmPackages, "float", kArmDouble, true},
    {"cortex-m7", "arm-none-eabi-", "-mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard", kArmLink,
     "qemu-system-arm -M mps2-an500 -nographic -semihosting-config enable=on,target=native -kernel", kArmBranches,
     kArmPackages, "double", nullptr, true},
    {"riscv32", "riscv64-unknown-elf-", "-march=rv32imafc -mabi=ilp32f -mcmodel=medany --specs=picolibc.specs",
     kRiscvLink,
     "qemu-system-riscv32 -M virt -bios none -nographic -semihosting-config enable=on,target=native -kernel",
     kRiscvBranches, kRiscvPackages, "float", kRiscvDouble},
    {"riscv64", "riscv64-unknown-elf-", "-march=rv64gc -mabi=lp64d -mcmodel=medany --specs=picolibc.specs", kRiscvLink,
     "qemu-system-riscv64 -M virt -bios none -nographic -semihosting-config enable=on,target=native -kernel",
     kRiscvBranches, kRiscvPackages, "double", nullptr},
    // Debian has no library for this target without an operating system, so the result is a program for Linux.
    {"aarch64", "aarch64-linux-gnu-", "-march=armv8-a -fno-pie", "-static -no-pie", "qemu-aarch64",
     "b\\.[a-z]+|[ct]bn?z", "gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user make", "double", nullptr},
};

}  // namespace

const FirmwareTarget& firmware_target(const std::string& name) {
  for (const FirmwareTarget& target : kTargets) {
    if (name == target.name) return target;
  }
  throw Failure(FailureKind::usage, "unknown processor \"" + name + "\"",
                fmt::format("use one of {}", fmt::join(firmware_target_names(), ", ")));
}

bool is_soft(const FirmwareTarget& target, const std::string& scalar) {
  return scalar == "double" && target.soft_double != nullptr;
}

std::string note_of_soft_scalar(const FirmwareTarget& target, const std::string& scalar) {
  constexpr int kTimes = 40;  // of the instructions in float, for inverse dynamics of the Panda on a Cortex-M4
  if (!is_soft(target, scalar)) return "";
  return fmt::format(
      "--firmware: {} has no unit for double, which takes functions of its compiler, and about {} times as many "
      "instructions as "
      "float",
      target.name, kTimes);
}

std::vector<std::string> firmware_target_names() {
  std::vector<std::string> names;
  for (const FirmwareTarget& target : kTargets) names.emplace_back(target.name);
  return names;
}

}  // namespace flatdyn
