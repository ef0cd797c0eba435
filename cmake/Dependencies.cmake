# SPDX-License-Identifier: GPL-2.0-or-later
# All dependencies are Debian packages (scripts/setup lists them). Their headers are system headers, so that their
# warnings do not count.
find_package(PkgConfig REQUIRED)
pkg_check_modules(ginac REQUIRED IMPORTED_TARGET ginac)
pkg_check_modules(cln REQUIRED IMPORTED_TARGET cln)
pkg_check_modules(tinyxml2 REQUIRED IMPORTED_TARGET tinyxml2)
pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET nlopt)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Boost REQUIRED)
find_package(Ceres REQUIRED)
find_library(GMP_LIBRARY gmp REQUIRED)
# Derivation allocates many small blocks, and jemalloc saves a third of its time. Sanitizers bring an allocator of their
# own.
pkg_check_modules(jemalloc REQUIRED IMPORTED_TARGET jemalloc)
set(FLATDYN_MALLOC PkgConfig::jemalloc)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(FLATDYN_MALLOC "")
endif()
find_library(MPFR_LIBRARY mpfr REQUIRED)
