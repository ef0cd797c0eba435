# SPDX-License-Identifier: BSD-3-Clause
# flatdyn_generate(TARGET
#   ROBOT file              robot file: URDF, SDF, MJCF, xacro or TOML
#   [SCENE file]            scene file
#   [FUNCTIONS name...]     what to compute; default: what the scene names, else all
#   [STAGES name...] [FUSE name...]
#   [SCALAR double|float]   default: double; of FORM pair, one or both: SCALAR double float
#   [LANGUAGE c++|c|cuda]   default: c++
#   [FORM header|pair]      of C++: a header (the default), or a library with header and source, compiled once
#   [NAMESPACE name]        in C what names begin with; default: TARGET
#   [ROUNDED_AS_WRITTEN]    of a header: targets that link with it are compiled with -ffp-contract=off, or by nvcc with
#                           -fmad=false
#   [OPTIONS option...])    other options of `flatdyn generate`
#
# Makes a library to link with. Its header is TARGET.hpp (for C: TARGET.h, for CUDA: TARGET.cuh, with flatdyn::runtime).
# It is generated again when the robot file, a file that it names, the scene, or flatdyn itself changes, and only then.
# The library can be installed and exported: install(TARGETS TARGET EXPORT ...) with PUBLIC_HEADER DESTINATION include.
#
# Certificates assume that every operation is rounded as it is written, with -ffp-contract=off. g++ 12 fuses some
# operations of vectors nevertheless, unless it is given -fno-tree-slp-vectorize, which clang knows, too. A generated
# source is compiled with both options here. A header is compiled by the targets that link with it: ROUNDED_AS_WRITTEN
# gives them the options, for all their own sources as well.
#
# g++ that tunes for a recent x86 processor, as -march=native tells it to, keeps doubles in general registers and moves
# them back and forth, which costs up to a third. $CACHE{FLATDYN_TUNING}, -mtune=generic, is given to generated sources,
# and to the C++ of targets that link with a header; empty: no option.
#
# The program is $CACHE{FLATDYN_EXECUTABLE} if set, for example in a cross build to a flatdyn of the build machine; else
# the installed program, or that of this build.

if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|amd64|i[3-6]86")
  set(FLATDYN_TUNING "-mtune=generic" CACHE STRING "options by which g++ and gcc compile generated code; may be empty")
else()
  set(FLATDYN_TUNING "" CACHE STRING "options by which g++ and gcc compile generated code; may be empty")
endif()

set(FLATDYN_EXECUTABLE "" CACHE FILEPATH "flatdyn of the machine that builds; empty: the installed one")

# Sets `result` to the command that runs flatdyn, and `dependency` to the file or target that changes with it.
function(flatdyn_find_program result dependency)
  if(FLATDYN_EXECUTABLE)
    set(program ${FLATDYN_EXECUTABLE})
    set(depends ${FLATDYN_EXECUTABLE})
  elseif(TARGET flatdyn::flatdyn)
    set(program $<TARGET_FILE:flatdyn::flatdyn>)
    set(depends $<TARGET_FILE:flatdyn::flatdyn>)
  else()
    message(FATAL_ERROR "flatdyn_generate: there is no flatdyn to run on this machine\n"
                        "Set -D FLATDYN_EXECUTABLE=/path/to/flatdyn")
  endif()
  if(CMAKE_CROSSCOMPILING AND NOT FLATDYN_EXECUTABLE AND NOT flatdyn_FOUND)
    message(FATAL_ERROR "flatdyn_generate: the flatdyn of this build does not run on this machine\n"
                        "Build one for it, and set -D FLATDYN_EXECUTABLE=/path/to/flatdyn")
  endif()
  set(${result} ${program} PARENT_SCOPE)
  set(${dependency} ${depends} PARENT_SCOPE)
endfunction()

# Sets `result` to the option with its list joined by commas; to nothing if the list is empty.
function(flatdyn_list_option result option)
  if(ARGN)
    list(JOIN ARGN "," value)
    set(${result} ${option} ${value} PARENT_SCOPE)
  else()
    set(${result} "" PARENT_SCOPE)
  endif()
endfunction()

# A namespace is a name of C, or of C++ several with :: between.
function(flatdyn_check_namespace target namespace)
  if(namespace MATCHES "^[A-Za-z_][A-Za-z0-9_]*(::[A-Za-z_][A-Za-z0-9_]*)*$")
    return()
  endif()
  string(MAKE_C_IDENTIFIER ${namespace} name)
  message(FATAL_ERROR "flatdyn_generate(${target}): \"${namespace}\" is no name of a namespace\n"
                      "Write NAMESPACE ${name}, or another name of letters, digits and _")
endfunction()

# The header is found as a system header, so that warnings of its users are about their own code; when the library is
# installed, in include/.
function(flatdyn_publish_header target scope folder header)
  target_include_directories(${target} SYSTEM ${scope} $<BUILD_INTERFACE:${folder}> $<INSTALL_INTERFACE:include>)
  set_target_properties(${target} PROPERTIES PUBLIC_HEADER ${folder}/${header})
endfunction()

function(flatdyn_generate target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "ROUNDED_AS_WRITTEN" "ROBOT;SCENE;LANGUAGE;FORM;NAMESPACE" "FUNCTIONS;STAGES;FUSE;SCALAR;OPTIONS")
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "flatdyn_generate(${target}): cannot make sense of "
                        "\"${arg_UNPARSED_ARGUMENTS}${arg_KEYWORDS_MISSING_VALUES}\"")
  endif()
  if(NOT arg_ROBOT)
    message(FATAL_ERROR "flatdyn_generate(${target}): ROBOT is missing: a file in URDF, SDF, MJCF, xacro or TOML")
  endif()
  if(NOT arg_LANGUAGE)
    set(arg_LANGUAGE c++)
  elseif(NOT arg_LANGUAGE MATCHES "^(c|c[+][+]|cuda)$")
    message(FATAL_ERROR "flatdyn_generate(${target}): LANGUAGE is c, c++ or cuda, not \"${arg_LANGUAGE}\"")
  endif()
  if(NOT arg_FORM)
    set(form "")
  elseif(NOT arg_FORM MATCHES "^(header|pair)$")
    message(FATAL_ERROR "flatdyn_generate(${target}): FORM is header or pair, not \"${arg_FORM}\"")
  elseif(NOT arg_LANGUAGE STREQUAL c++)
    message(FATAL_ERROR "flatdyn_generate(${target}): FORM is of C++ only; in C there are header and source anyhow, in "
                        "CUDA a header")
  else()
    set(form --form ${arg_FORM})
  endif()
  if(NOT arg_NAMESPACE)
    set(arg_NAMESPACE ${target})
  endif()
  flatdyn_check_namespace(${target} ${arg_NAMESPACE})
  cmake_path(ABSOLUTE_PATH arg_ROBOT BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
  set(depends ${arg_ROBOT})
  set(scene "")
  if(arg_SCENE)
    cmake_path(ABSOLUTE_PATH arg_SCENE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    list(APPEND depends ${arg_SCENE})
    set(scene --scene ${arg_SCENE})
  endif()
  flatdyn_find_program(program tool)
  flatdyn_list_option(functions --functions ${arg_FUNCTIONS})
  flatdyn_list_option(stages --stages ${arg_STAGES})
  flatdyn_list_option(fuse --fuse ${arg_FUSE})
  flatdyn_list_option(scalar --scalar ${arg_SCALAR})

  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}.flatdyn)
  set(header ${target}.hpp)
  if(arg_LANGUAGE STREQUAL cuda)
    set(header ${target}.cuh)
  endif()
  set(outputs ${folder}/${header})
  if(arg_LANGUAGE STREQUAL c)
    set(outputs ${folder}/${target}.h ${folder}/${target}.c)
  elseif(arg_FORM STREQUAL pair)
    set(outputs ${folder}/${target}.hpp ${folder}/${target}.cpp)
  endif()
  add_custom_command(
    OUTPUT ${outputs} ${folder}/${target}.json
    COMMAND ${program} generate ${arg_ROBOT} -o ${folder} --name ${target} --namespace ${arg_NAMESPACE}
            --language ${arg_LANGUAGE} ${form} ${scene} ${functions} ${stages} ${fuse} ${scalar} ${arg_OPTIONS}
            --quiet --depfile ${folder}/${target}.d > ${target}.flatdyn.log
    DEPENDS ${depends} ${tool}
    DEPFILE ${folder}/${target}.d
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}
    COMMENT "Generating the dynamics of ${target}"
    VERBATIM)
  if(arg_LANGUAGE STREQUAL c)
    add_library(${target} STATIC ${outputs})
    flatdyn_publish_header(${target} PUBLIC ${folder} ${target}.h)
    target_compile_features(${target} PUBLIC c_std_99)
    target_compile_options(${target} PRIVATE -ffp-contract=off -fno-tree-slp-vectorize
                                             "$<$<C_COMPILER_ID:GNU>:${FLATDYN_TUNING}>")
    if(UNIX)
      target_link_libraries(${target} PUBLIC m)
    endif()
    return()
  endif()
  if(arg_FORM STREQUAL pair)
    add_library(${target} STATIC ${outputs})
    flatdyn_publish_header(${target} PUBLIC ${folder} ${target}.hpp)
    target_compile_features(${target} PUBLIC cxx_std_17)
    target_compile_options(${target} PRIVATE -ffp-contract=off -fno-tree-slp-vectorize
                                             "$<$<CXX_COMPILER_ID:GNU>:${FLATDYN_TUNING}>")
    return()
  endif()
  add_library(${target} INTERFACE)
  add_custom_target(${target}_generate DEPENDS ${outputs})
  add_dependencies(${target} ${target}_generate)
  flatdyn_publish_header(${target} INTERFACE ${folder} ${header})
  target_compile_features(${target} INTERFACE cxx_std_17)
  target_compile_options(${target} INTERFACE "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:${FLATDYN_TUNING}>")
  if(arg_LANGUAGE STREQUAL cuda)
    target_link_libraries(${target} INTERFACE flatdyn::runtime)
  endif()
  if(arg_ROUNDED_AS_WRITTEN)
    target_compile_options(${target} INTERFACE
      "$<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off;-fno-tree-slp-vectorize>")
    if(arg_LANGUAGE STREQUAL cuda)
      # nvcc has its own option for kernels, and passes options to the compiler of the host.
      target_compile_options(${target} INTERFACE
        "$<$<COMPILE_LANG_AND_ID:CUDA,NVIDIA>:-fmad=false;-Xcompiler=-ffp-contract=off>"
        "$<$<COMPILE_LANG_AND_ID:CUDA,Clang>:-ffp-contract=off>")
    endif()
  endif()
endfunction()
