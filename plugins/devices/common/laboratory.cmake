# SPDX-License-Identifier: BSD-3-Clause

# laboratory_plugin(<name> <what to install> <include variable> <library variable or ""> <files>...)
#
# Makes the device plug-in <name>.so if the header's folder and the library were found. If not, an own
# build ends and says what is missing; within the project the plug-in is left out.
find_package(Threads REQUIRED)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo)
endif()
function(laboratory_plugin name package include library)
  if(NOT ${include} OR (library AND NOT ${library}))
    set(kind FATAL_ERROR)
    if(PROJECT_NAME STREQUAL "perilymph")
      set(kind STATUS)
    endif()
    message(${kind} "The plug-in ${name} is left out: ${package} is missing. Install it, or name its places with "
      "-D${include}=FOLDER -D${library}=FILE.")
    return()
  endif()
  perilymph_device_plugin(${name} ${ARGN})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
  target_include_directories(${name} SYSTEM PRIVATE "${${include}}")
  target_compile_features(${name} PRIVATE cxx_std_20)
  set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_libraries(${name} PRIVATE Threads::Threads)
  if(library)
    target_link_libraries(${name} PRIVATE "${${library}}")
  endif()
endfunction()
