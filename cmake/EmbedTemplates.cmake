# SPDX-License-Identifier: GPL-2.0-or-later
# flatdyn_embed_templates(target folder include_dir [file...]): makes every folder/*.mustache a string in namespace
# flatdyn::templates of `target` ("header.hpp.mustache" → `header_hpp`), declared in "templates.hpp", so that the program
# needs no files; other targets that include it depend on flatdyn_templates. Every *.hpp and *.cuh below include_dir becomes a row of the table `headers` there, with the path
# that it is included by. Further files are strings, too ("gpu_states.hpp" → `gpu_states`).
#
# The same file is the script that the build runs when a template changes:
#   cmake -D TEMPLATES=a;b -D HEADERS=c;d -D INCLUDE_DIR=dir -D OUTPUT_DIR=dir -P EmbedTemplates.cmake

if(CMAKE_SCRIPT_MODE_FILE)
  set(declarations "")
  set(definitions "")
  foreach(template ${TEMPLATES})
    cmake_path(GET template STEM LAST_ONLY name)
    string(MAKE_C_IDENTIFIER ${name} name)
    file(READ ${template} text)
    string(APPEND declarations "extern const char* const ${name};\n")
    string(APPEND definitions "const char* const ${name} = R\"mustache(${text})mustache\";\n")
  endforeach()
  set(rows "")
  foreach(header ${HEADERS})
    cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${INCLUDE_DIR} OUTPUT_VARIABLE path)
    file(READ ${header} text)
    string(APPEND rows "    {\"${path}\", R\"header(${text})header\"},\n")
  endforeach()
  string(APPEND declarations "struct Header {\n  const char *path, *text;\n};\n"
                             "extern const std::vector<Header> headers;\n")
  string(APPEND definitions "const std::vector<Header> headers = {\n${rows}};\n")
  file(WRITE ${OUTPUT_DIR}/templates.hpp
       "#pragma once\n\n#include <vector>\n\nnamespace flatdyn::templates {\n${declarations}}  // namespace flatdyn::templates\n")
  file(WRITE ${OUTPUT_DIR}/templates.cpp
       "#include \"templates.hpp\"\n\nnamespace flatdyn::templates {\n${definitions}}  // namespace flatdyn::templates\n")
  return()
endif()

set(FLATDYN_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(flatdyn_embed_templates target folder include_dir)
  file(GLOB templates CONFIGURE_DEPENDS ${folder}/*.mustache)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include_dir}/*.hpp ${include_dir}/*.cuh)
  list(APPEND templates ${ARGN})
  set(output_dir ${CMAKE_CURRENT_BINARY_DIR}/templates)
  add_custom_command(
    OUTPUT ${output_dir}/templates.cpp ${output_dir}/templates.hpp
    COMMAND ${CMAKE_COMMAND} -D "TEMPLATES=${templates}" -D "HEADERS=${headers}" -D INCLUDE_DIR=${include_dir}
            -D OUTPUT_DIR=${output_dir} -P ${FLATDYN_EMBED_SCRIPT}
    DEPENDS ${templates} ${headers} ${FLATDYN_EMBED_SCRIPT}
    COMMENT "Embedding templates and headers"
    VERBATIM)
  target_sources(${target} PRIVATE ${output_dir}/templates.cpp ${output_dir}/templates.hpp)
  target_include_directories(${target} PRIVATE ${output_dir})
  add_custom_target(flatdyn_templates DEPENDS ${output_dir}/templates.hpp)
  add_dependencies(${target} flatdyn_templates)
endfunction()
