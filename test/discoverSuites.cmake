# SPDX-License-Identifier: BSD-3-Clause

# Run by ctest before the tests: adds a ctest test for each suite of a test program, listed by the program itself,
# which is built by then. The list is kept until the program changes.
#
# perilymph_add_suites(<program> <prefix> <list file> <results folder> <launcher or ""> PROPERTIES ... NIGHTLY ...)
#
# The nightly cases, named Suite.Case, are left out of their suites and are one ctest test: long/cases/<prefix>.
function(perilymph_add_suites program prefix file results launcher)
  cmake_parse_arguments(PARSE_ARGV 5 arg "" "" "PROPERTIES;NIGHTLY")
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
    foreach(case IN LISTS arg_NIGHTLY)
      string(REGEX REPLACE "^([^.]+)[.](.+)$" "(^|\n)\\1[.][^\n]*(\n  [^\n]+)*\n  \\2[ \n]" place "${case}")
      if(NOT "${listed}" MATCHES "${place}")
        message(FATAL_ERROR "${program} has no case ${case}, which is listed as nightly.")
      endif()
    endforeach()
    list(TRANSFORM suites REPLACE "[^A-Za-z0-9_/]" "")
    file(WRITE "${file}" "${suites}")
  endif()
  file(READ "${file}" suites)
  foreach(suite IN LISTS suites)
    set(test "${prefix}${suite}")
    string(REPLACE "/" "." result "${test}")
    set(without "${arg_NIGHTLY}")
    list(FILTER without INCLUDE REGEX "^${suite}[.]")
    list(JOIN without ":" without)
    if(NOT without STREQUAL "")
      string(PREPEND without "-")
    endif()
    add_test("${test}" ${launcher} "${program}" "--gtest_filter=${suite}.*${without}")
    set_tests_properties("${test}" PROPERTIES ${arg_PROPERTIES}
      SKIP_RETURN_CODE 77 ENVIRONMENT "GTEST_OUTPUT=xml:${results}/${result}.xml")
  endforeach()
  if(arg_NIGHTLY)
    string(REGEX REPLACE "/$" "" test "long/cases/${prefix}")
    string(REPLACE "/" "." result "${test}")
    list(JOIN arg_NIGHTLY ":" cases)
    add_test("${test}" ${launcher} "${program}" "--gtest_filter=${cases}")
    set_tests_properties("${test}" PROPERTIES LABELS long TIMEOUT 7200
      SKIP_RETURN_CODE 77 ENVIRONMENT "GTEST_OUTPUT=xml:${results}/${result}.xml")
  endif()
endfunction()
