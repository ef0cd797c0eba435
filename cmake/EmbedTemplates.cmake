# SPDX-License-Identifier: GPL-2.0-or-later
# flatdyn_embed_templates(target folder): makes every folder/*.mustache a string in namespace flatdyn::templates of
# `target` ("header.hpp.mustache" → `header_hpp`), declared in "templates.hpp", so that the program needs no files.
#
# The same file is the script that the build runs when a template changes:
#   cmake -D TEMPLATES=a;b -D OUTPUT_DIR=dir -P EmbedTemplates.cmake

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
  file(WRITE ${OUTPUT_DIR}/templates.hpp
       "#pragma once\n\nnamespace flatdyn::templates {\n${declarations}}  // namespace flatdyn::templates\n")
  file(WRITE ${OUTPUT_DIR}/templates.cpp
       "#include \"templates.hpp\"\n\nnamespace flatdyn::templates {\n${definitions}}  // namespace flatdyn::templates\n")
  return()
endif()

set(FLATDYN_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(flatdyn_embed_templates target folder)
  file(GLOB templates CONFIGURE_DEPENDS ${folder}/*.mustache)
  set(output_dir ${CMAKE_CURRENT_BINARY_DIR}/templates)
  add_custom_command(
    OUTPUT ${output_dir}/templates.cpp ${output_dir}/templates.hpp
    COMMAND ${CMAKE_COMMAND} -D "TEMPLATES=${templates}" -D OUTPUT_DIR=${output_dir} -P ${FLATDYN_EMBED_SCRIPT}
    DEPENDS ${templates} ${FLATDYN_EMBED_SCRIPT}
    COMMENT "Embedding templates"
    VERBATIM)
  target_sources(${target} PRIVATE ${output_dir}/templates.cpp ${output_dir}/templates.hpp)
  target_include_directories(${target} PRIVATE ${output_dir})
endfunction()
