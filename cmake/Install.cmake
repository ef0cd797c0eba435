# SPDX-License-Identifier: GPL-2.0-or-later
# The rules of `cmake --install`, with find_package(flatdyn), pkg-config flatdyn-runtime, and `cpack` (a .deb).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(ROBOTS ${CMAKE_INSTALL_DATADIR}/flatdyn/robots)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/flatdyn)
install(TARGETS flatdyn_runtime EXPORT flatdynTargets)
install(DIRECTORY runtime/include/flatdyn DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY robots/ DESTINATION ${ROBOTS})
if(TARGET flatdyn)
  install(TARGETS flatdyn EXPORT flatdynTargets)

  # The program writes the manual pages and the completion at install time, so that a build of the program alone can be
  # installed. The lock keeps two installations at once from removing each other's pages.
  set(manual ${CMAKE_CURRENT_BINARY_DIR}/manual)
  find_program(GZIP gzip REQUIRED)
  install(CODE "
    file(LOCK \"${manual}.lock\" GUARD PROCESS)
    file(REMOVE_RECURSE \"${manual}\")
    file(MAKE_DIRECTORY \"${manual}\")
    execute_process(COMMAND \"$<TARGET_FILE:flatdyn>\" man -o \"${manual}/man1\" COMMAND_ERROR_IS_FATAL ANY)
    file(GLOB pages \"${manual}/man1/*.1\")
    execute_process(COMMAND \"${GZIP}\" -9n \${pages} COMMAND_ERROR_IS_FATAL ANY)
    foreach(shell_and_file bash:flatdyn zsh:_flatdyn fish:flatdyn.fish)
      string(REGEX MATCH \"^[a-z]+\" shell \"\${shell_and_file}\")
      string(REGEX REPLACE \"^[a-z]+:\" \"\" file \"\${shell_and_file}\")
      execute_process(COMMAND \"$<TARGET_FILE:flatdyn>\" completion \${shell} OUTPUT_FILE \"${manual}/\${file}\"
                      COMMAND_ERROR_IS_FATAL ANY)
    endforeach()")
  install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
  install(FILES ${manual}/flatdyn DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${manual}/_flatdyn DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  install(FILES ${manual}/flatdyn.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()

install(EXPORT flatdynTargets NAMESPACE flatdyn:: DESTINATION ${config_dir})
configure_package_config_file(cmake/flatdynConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/flatdynConfig.cmake
                              INSTALL_DESTINATION ${config_dir} PATH_VARS ROBOTS)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/flatdynConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/flatdynConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/flatdynConfigVersion.cmake
              cmake/FlatdynGenerate.cmake
        DESTINATION ${config_dir})

configure_file(cmake/flatdyn-runtime.pc.in flatdyn-runtime.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/flatdyn-runtime.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)

install(FILES README.md CHANGELOG.md LICENSES/BSD-3-Clause.txt DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)

if(PROJECT_IS_TOP_LEVEL)
  include(DebianPackage)
  if(TARGET flatdyn)
    add_custom_target(program DEPENDS flatdyn)  # everything that is installed
  endif()
endif()
