# SPDX-License-Identifier: BSD-3-Clause

# perilymph_module(<name> LAYER engine|toolkit [TOGETHER] SUMMARY "..." [USES modules...] [LINKS targets...]
#                  [PRIVATE_LINKS targets...] [OPTIONS options...] [SOURCES files...])
#
# Defines the library Perilymph::<Name> of modules/<name> and enforces the dependency rules:
#   - an engine module uses engine modules only, and neither VTK nor Qt;
#   - a used module is defined before its user, so there is no cycle;
#   - headers of other modules are only reachable through USES.
#
# TOGETHER compiles several sources at a time (together.cmake).
# Headers below include/ are the module's API: each is used outside of the module (test/architecture looks).
# Those below src/ are reachable from tests only, which name the module among their INTERNALS and so link the
# INTERFACE target perilymph_<name>_internal.
function(perilymph_module name)
  cmake_parse_arguments(arg "TOGETHER" "LAYER;SUMMARY" "USES;LINKS;PRIVATE_LINKS;OPTIONS;SOURCES" ${ARGN})
  if(NOT arg_LAYER MATCHES "^(engine|toolkit)$")
    message(FATAL_ERROR "modules/${name}: LAYER is '${arg_LAYER}'; it must be engine or toolkit.")
  endif()
  if(NOT arg_SUMMARY)
    message(FATAL_ERROR "modules/${name} needs a SUMMARY of one line.")
  endif()
  foreach(used IN LISTS arg_USES)
    if(NOT TARGET perilymph_${used})
      message(FATAL_ERROR "modules/${name} uses modules/${used}, which does not stand before it.")
    endif()
    get_target_property(layer perilymph_${used} PERILYMPH_LAYER)
    if(arg_LAYER STREQUAL "engine" AND NOT layer STREQUAL "engine")
      message(FATAL_ERROR "modules/${name} is engine and may not use modules/${used} (${layer}).")
    endif()
  endforeach()
  if(arg_LAYER STREQUAL "engine" AND "${arg_LINKS};${arg_PRIVATE_LINKS}" MATCHES "VTK::|Qt[56]?::")
    message(FATAL_ERROR "modules/${name} is engine and may not link VTK or Qt.")
  endif()

  if(arg_SOURCES)
    add_library(perilymph_${name} STATIC ${arg_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(perilymph_${name} PRIVATE perilymph_flags ${arg_PRIVATE_LINKS})
    target_compile_options(perilymph_${name} PRIVATE ${arg_OPTIONS})
    if(arg_TOGETHER)
      perilymph_together(perilymph_${name})
    endif()
    set(set engine)
    if("${arg_LINKS};${arg_PRIVATE_LINKS}" MATCHES "nlohmann_json")
      set(set documents)
    endif()
    if(arg_OPTIONS)
      perilymph_precompile(perilymph_${name} ${set} OWN)
    else()
      perilymph_precompile(perilymph_${name} ${set})
    endif()
  else()
    add_library(perilymph_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(perilymph_${name} ${scope} "${CMAKE_CURRENT_SOURCE_DIR}/include")
  if(arg_SOURCES)
    target_include_directories(perilymph_${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
  endif()
  list(TRANSFORM arg_USES PREPEND perilymph_ OUTPUT_VARIABLE used_targets)
  target_link_libraries(perilymph_${name} ${scope} ${used_targets} ${arg_LINKS})
  set_target_properties(perilymph_${name} PROPERTIES
    PERILYMPH_LAYER "${arg_LAYER}" PERILYMPH_SUMMARY "${arg_SUMMARY}" PERILYMPH_USES "${arg_USES}")

  # Access to the module's private headers, for its own tests only.
  if(arg_SOURCES)
    add_library(perilymph_${name}_internal INTERFACE)
    target_include_directories(perilymph_${name}_internal INTERFACE "${CMAKE_CURRENT_SOURCE_DIR}/src")
    target_link_libraries(perilymph_${name}_internal INTERFACE perilymph_${name})
  endif()

  string(SUBSTRING ${name} 0 1 first)
  string(SUBSTRING ${name} 1 -1 rest)
  string(TOUPPER ${first} first)
  add_library(Perilymph::${first}${rest} ALIAS perilymph_${name})
  set_property(GLOBAL APPEND PROPERTY PERILYMPH_MODULES ${name})
endfunction()
