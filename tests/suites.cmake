# Included by ctest: gives a program of tests one test of ctest's for each of its suites, "program:Suite", as a process
# for each case costs more than most cases do. Long suites are run in shards, "program:Suite/1". Expects:
#   name, program       the tests' prefix, and the file that has them
#   left_out            cases that are not run here, as --gtest_filter takes them
#   shards              pairs "Suite=count" for those that are split
#   long                suites that get the label "long"
#   labels              what all are labelled with besides
#   properties          what each test has, as set_tests_properties() takes it
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
