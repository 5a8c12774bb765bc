# Included by ctest: registers one ctest test for each suite of a test program, "program:Suite", since one process
# per case costs more than most cases do. Long suites are split into shards, "program:Suite/1".
# Variables expected:
#
#   name, program       prefix of the tests, and the program's file
#   left_out            cases not to run, as for --gtest_filter
#   shards              pairs "Suite=count" of suites to split
#   long                suites that get the label "long"
#   labels              further labels of all tests
#   properties          properties of each test, as for set_tests_properties()
cmake_policy(VERSION 3.23)
if(NOT EXISTS "${program}")
    add_test("${name}:NOT_BUILT" "${program}")
    return()
endif()
execute_process(COMMAND "${program}" --gtest_list_tests "--gtest_filter=*-${left_out}"
    OUTPUT_VARIABLE listed RESULT_VARIABLE failed)
if(failed)
    message(FATAL_ERROR "${program} does not list its tests: ${failed}")
endif()
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${listed}")
foreach(suite IN LISTS suites)
    string(REGEX REPLACE "[\n.]" "" suite "${suite}")
    set(count 1)
    foreach(split IN LISTS shards)
        if(split MATCHES "^${suite}=([0-9]+)$")
            set(count "${CMAKE_MATCH_1}")
        endif()
    endforeach()
    set(suite_labels ${labels})
    if(suite IN_LIST long)
        list(APPEND suite_labels long)
    endif()
    foreach(index RANGE 1 ${count})
        set(test "${name}:${suite}")
        set(environment "")
        if(count GREATER 1)
            string(APPEND test "/${index}")
            math(EXPR index "${index} - 1")
            set(environment ENVIRONMENT "GTEST_TOTAL_SHARDS=${count};GTEST_SHARD_INDEX=${index}")
        endif()
        add_test("${test}" "${program}" --gtest_brief=1 "--gtest_filter=${suite}.*-${left_out}")
        set_tests_properties("${test}" PROPERTIES ${properties} ${environment} LABELS "${suite_labels}")
    endforeach()
endforeach()
