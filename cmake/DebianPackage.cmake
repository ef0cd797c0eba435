# SPDX-License-Identifier: GPL-2.0-or-later
# `cpack` makes flatdyn_VERSION_ARCHITECTURE.deb. dpkg-shlibdeps finds the libraries that the program needs; tools that
# only some subcommands need are recommended.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "flatdyn developers <flatdyn@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "symbolic generator of flat code for robot dynamics")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "flatdyn reads a robot file (URDF, SDF, MJCF or xacro, or TOML with DH
parameters and motors), derives the robot's dynamics, and writes code
without dependencies that computes them, in C++, C, CUDA, JavaScript, Rust, CasADi or
Python: inertia matrix, gravity, inverse and forward dynamics, regressors.
The code is proven to be equal to the Lagrangian equations of motion, and
its rounding errors can be certified.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++ | c++-compiler, gappa")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libxsimd-dev, cmake, gnuplot-nox")

# Debian's policy requires these two files.
set(debian ${CMAKE_CURRENT_BINARY_DIR}/debian)
configure_file(cmake/debian/changelog.in ${debian}/changelog @ONLY)
# It is packed at install time, like the manual pages: after a build of the program alone the package is whole, too.
find_program(GZIP gzip REQUIRED)
install(CODE "execute_process(COMMAND \"${GZIP}\" -9nkf \"${debian}/changelog\" COMMAND_ERROR_IS_FATAL ANY)")
install(FILES cmake/debian/copyright ${debian}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
include(CPack)
