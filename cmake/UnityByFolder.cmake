# SPDX-License-Identifier: GPL-2.0-or-later
# Most compile time goes into headers, and into templates of Eigen, of the standard library and of JSON that the
# sources of a folder have in common. So sources of one folder are compiled together: four at a time, cli/ takes three
# times as long as all at once. -DFLATDYN_UNITY_BUILD=OFF compiles them one by one, which is faster for repeated changes
# of single files.
option(FLATDYN_UNITY_BUILD "Compile sources of one folder together" ON)

# flatdyn_unity_by_folder(TARGET SIZE SOURCES...): compiles at most SIZE sources of a folder together; other sources
# stay alone. The small folders in languages/ are one.
function(flatdyn_unity_by_folder target size)
  if(NOT FLATDYN_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH folder)
    string(REGEX REPLACE "/languages/[a-z]+$" "/languages" folder ${folder})
    cmake_path(GET folder FILENAME folder)
    if(NOT DEFINED ${folder}_count)
      set(${folder}_count 0)
    endif()
    math(EXPR group "${${folder}_count} / ${size}")
    math(EXPR ${folder}_count "${${folder}_count} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
endfunction()
