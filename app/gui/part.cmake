# SPDX-License-Identifier: BSD-3-Clause

# perilymph_gui_part(<folder> [WITHOUT_WIDGETS] [USES folders...] [LINKS targets...] [PRIVATE_LINKS targets...] SOURCES files...)
#
#Makes the library perilymph_gui_<folder> (slashes become underscores) of a folder of app/gui.
#  - USES names the folders whose headers it may include, transitively. A folder is declared after
#    those it uses, so that there is no cycle.
#  - Headers are included by their path: "gui/scene/OperationView.h".
# test/architecture compares USES and the real includes with the table in README.md.
function(perilymph_gui_part folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WITHOUT_WIDGETS" "" "USES;LINKS;PRIVATE_LINKS;SOURCES")
  if(NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "perilymph_gui_part(${folder}) needs SOURCES and knows no '${arg_UNPARSED_ARGUMENTS}'.")
  endif()
  file(GLOB found RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS "*.cpp")
  list(REMOVE_ITEM found ${arg_SOURCES})
  if(found)
    message(FATAL_ERROR "app/gui/${folder}: ${found} is not listed in SOURCES.")
  endif()
  set(used_targets)
  foreach(used IN LISTS arg_USES)
    string(REPLACE "/" "_" used_name "${used}")
    if(NOT TARGET perilymph_gui_${used_name})
      message(FATAL_ERROR "app/gui/${folder} uses ${used}, which is not declared before it.")
    endif()
    list(APPEND used_targets perilymph_gui_${used_name})
  endforeach()

  string(REPLACE "/" "_" name "${folder}")
  add_library(perilymph_gui_${name} STATIC ${arg_SOURCES})
  set_target_properties(perilymph_gui_${name} PROPERTIES AUTOMOC ON)
  perilymph_together(perilymph_gui_${name})
  target_include_directories(perilymph_gui_${name} PUBLIC "${PROJECT_SOURCE_DIR}/app")
  # Qt's keywords collide with names in oneTBB's headers.
  target_compile_definitions(perilymph_gui_${name} PUBLIC QT_NO_KEYWORDS)
  target_link_libraries(perilymph_gui_${name}
    PUBLIC ${used_targets} ${arg_LINKS} PRIVATE perilymph_flags ${arg_PRIVATE_LINKS})
  if(arg_WITHOUT_WIDGETS)
    perilymph_precompile(perilymph_gui_${name} engine OWN)
  else()
    perilymph_precompile(perilymph_gui_${name} window)
  endif()
  set_property(GLOBAL APPEND PROPERTY PERILYMPH_GUI_PARTS perilymph_gui_${name})
endfunction()
