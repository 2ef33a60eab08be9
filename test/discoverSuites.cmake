# SPDX-License-Identifier: BSD-3-Clause

# Run by ctest before the tests: adds a ctest test for each suite of a test program, listed by the program itself,
# which is built by then. The list is kept until the program changes.
#
# perilymph_add_suites(<program> <prefix> <list file> <results folder> <launcher or ""> PROPERTIES ...)
function(perilymph_add_suites program prefix file results launcher)
  cmake_parse_arguments(PARSE_ARGV 5 arg "" "" "PROPERTIES")
  if(NOT EXISTS "${program}")
    add_test("${prefix}NOT_BUILT" "${program}")
    return()
  endif()
  if(NOT EXISTS "${file}" OR "${program}" IS_NEWER_THAN "${file}")
    execute_process(COMMAND "${program}" --gtest_list_tests TIMEOUT 120
      OUTPUT_VARIABLE listed ERROR_VARIABLE errors RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
      message(FATAL_ERROR "${program} could not list its tests: ${status}\n${listed}${errors}")
    endif()
    # A suite is a line that begins it and ends in a dot; cases are indented; what follows # is a type parameter.
    string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\.(\n|  #)" suites "${listed}")
    list(TRANSFORM suites REPLACE "[^A-Za-z0-9_/]" "")
    file(WRITE "${file}" "${suites}")
  endif()
  file(READ "${file}" suites)
  foreach(suite IN LISTS suites)
    set(test "${prefix}${suite}")
    string(REPLACE "/" "." result "${test}")
    add_test("${test}" ${launcher} "${program}" "--gtest_filter=${suite}.*")
    set_tests_properties("${test}" PROPERTIES ${arg_PROPERTIES}
      SKIP_RETURN_CODE 77 ENVIRONMENT "GTEST_OUTPUT=xml:${results}/${result}.xml")
  endforeach()
endfunction()
