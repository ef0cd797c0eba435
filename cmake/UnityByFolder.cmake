# SPDX-License-Identifier: GPL-2.0-or-later
# Most of a compiler's time goes into the headers of GiNaC, Eigen and Boost. So sources of one folder are compiled
# together, a few at a time, which parses them less often. -DFLATDYN_UNITY_BUILD=OFF: one by one, for who changes single
# files over and over.
option(FLATDYN_UNITY_BUILD "Compile sources of one folder together" ON)

# flatdyn_unity_by_folder(TARGET SIZE SOURCES...): at most SIZE of a folder at a time; other sources stay alone.
function(flatdyn_unity_by_folder target size)
  if(NOT FLATDYN_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME folder)
    if(NOT DEFINED ${folder}_count)
      set(${folder}_count 0)
    endif()
    math(EXPR group "${${folder}_count} / ${size}")
    math(EXPR ${folder}_count "${${folder}_count} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
endfunction()
