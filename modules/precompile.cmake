# SPDX-License-Identifier: BSD-3-Clause

# Precompiled headers, shared by many targets.
#
# perilymph_precompiled_headers(<set> LINKS targets... [DEFINITIONS names...] [OPTIONS options...]
#                               HEADERS headers...)
# declares a set; perilymph_precompile(<target> <set>) compiles a target's sources with its headers
# and options. All targets of a set have the same compiler options: GCC takes the optimization level
# from the precompiled header, whatever the source's own options say. Every source still includes
# what it uses: the preset "engine" and the other presets with PERILYMPH_PRECOMPILE=OFF compile
# without precompiled headers.
option(PERILYMPH_PRECOMPILE "Compile the headers that most sources read once" ON)

function(perilymph_precompiled_headers set)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINKS;DEFINITIONS;OPTIONS;HEADERS")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/precompiled_${set}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "")
  add_library(perilymph_precompiled_${set} OBJECT "${source}")
  target_link_libraries(perilymph_precompiled_${set} PRIVATE perilymph_flags ${arg_LINKS})
  target_compile_definitions(perilymph_precompiled_${set} PRIVATE ${arg_DEFINITIONS})
  target_compile_options(perilymph_precompiled_${set} PRIVATE ${arg_OPTIONS})
  list(TRANSFORM arg_HEADERS REPLACE "(.+)" "<\\1>")
  set_target_properties(perilymph_precompiled_${set} PROPERTIES
    PERILYMPH_HEADERS "${arg_HEADERS}" PERILYMPH_OPTIONS "${arg_OPTIONS}")
  if(PERILYMPH_PRECOMPILE)
    target_precompile_headers(perilymph_precompiled_${set} PRIVATE ${arg_HEADERS})
  endif()
endfunction()

# OWN: for a target with other compiler options than the set.
function(perilymph_precompile target set)
  cmake_parse_arguments(PARSE_ARGV 2 arg "OWN" "" "")
  get_target_property(options perilymph_precompiled_${set} PERILYMPH_OPTIONS)
  target_compile_options(${target} PRIVATE ${options})
  if(NOT PERILYMPH_PRECOMPILE)
    return()
  endif()
  # GCC 12 otherwise regards the standard library's strings in a precompiled header as the project's
  # own code.
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow;-Wno-stringop-overread>")
  if(arg_OWN)
    get_target_property(headers perilymph_precompiled_${set} PERILYMPH_HEADERS)
    target_precompile_headers(${target} PRIVATE ${headers})
  else()
    target_precompile_headers(${target} REUSE_FROM perilymph_precompiled_${set})
  endif()
endfunction()

