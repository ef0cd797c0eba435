# SPDX-License-Identifier: GPL-2.0-or-later
# flatdyn_add_regenerate(program): the target `regenerate`, which writes generated/ again, as listed in
# generated/robots.txt.
#
# The same file is the script that the target runs:
#   cmake -D PROGRAM=flatdyn -D SOURCE_DIR=dir -P Regenerate.cmake

if(CMAKE_SCRIPT_MODE_FILE)
  cmake_minimum_required(VERSION 3.25)
  file(STRINGS ${SOURCE_DIR}/generated/robots.txt lines REGEX "^[^#]")
  if(NOT lines)
    message(FATAL_ERROR "generated/robots.txt names no robot")
  endif()
  set(staging ${SOURCE_DIR}/generated/.regenerate)
  file(REMOVE_RECURSE ${staging})
  foreach(line ${lines})
    separate_arguments(arguments UNIX_COMMAND "${line}")
    list(POP_FRONT arguments robot)
    message(STATUS "flatdyn generate ${line}")
    execute_process(COMMAND ${PROGRAM} generate ${robot} -o ${staging} ${arguments}
                    WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_QUIET RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
      file(REMOVE_RECURSE ${staging})
      message(FATAL_ERROR "${robot}: flatdyn generate ended with ${status}; generated/ is as it was")
    endif()
  endforeach()
  file(GLOB old ${SOURCE_DIR}/generated/*)
  list(FILTER old EXCLUDE REGEX "/(robots.txt|\\.regenerate)$")
  if(old)
    file(REMOVE_RECURSE ${old})
  endif()
  file(COPY ${staging}/ DESTINATION ${SOURCE_DIR}/generated PATTERN *.json EXCLUDE)
  file(REMOVE_RECURSE ${staging})
  return()
endif()

set(FLATDYN_REGENERATE_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(flatdyn_add_regenerate program)
  add_custom_target(regenerate
    COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${program}> -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
            -P ${FLATDYN_REGENERATE_SCRIPT}
    DEPENDS ${program}
    COMMENT "Writing generated/ anew"
    USES_TERMINAL VERBATIM)
endfunction()
