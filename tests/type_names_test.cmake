# Checks that every type's qualified name is defined once in all sources. Two types of one name in two libraries
# violate the one-definition rule: neither compiler nor linker reports it, and which of their inline functions the
# program gets depends on the optimisation.
#   Run: cmake -DROOT=<repository> -DCTAGS=<universal-ctags> -DSCRATCH=<folder> -P type_names_test.cmake

# Finds types that files define twice, with the places. Excluded are types that other sources cannot see (in unnamed
# namespaces or functions), and full specialisations, which are further definitions of a template.
function(find_types_defined_twice files count twice)
    list(JOIN files "\n" list)
    file(WRITE ${SCRATCH}/files "${list}\n")
    execute_process(
        COMMAND ${CTAGS} --quiet --options=NONE --sort=no -L ${SCRATCH}/files -x --languages=C++ --langmap=C++:.h.cpp
            --c++-kinds=csgu "--_xformat=%s|%N|%p|%{C++.template}|%F:%n"
        OUTPUT_VARIABLE types COMMAND_ERROR_IS_FATAL ANY)
    string(REPLACE ";" "," types "${types}")
    string(REGEX REPLACE "\n$" "" types "${types}")
    string(REPLACE "\n" ";" types "${types}")
    set(known 0)
    set(repeated)
    foreach(type IN LISTS types)
        string(REGEX MATCH "^([^|]*)[|]([^|]*)[|]([^|]*)[|](.*)[|]([^|]+)$" type "${type}")
        set(name "${CMAKE_MATCH_1}::${CMAKE_MATCH_2}")
        set(scope_kind "${CMAKE_MATCH_3}")
        set(template "${CMAKE_MATCH_4}")
        set(place "${CMAKE_MATCH_5}")
        if(name MATCHES "__anon" OR scope_kind STREQUAL function OR template STREQUAL "<>")
            continue()
        endif()
        math(EXPR known "${known} + 1")
        if(DEFINED "place_of_${name}")
            list(APPEND repeated "${name}: ${place_of_${name}} and ${place}")
        endif()
        set("place_of_${name}" ${place})
    endforeach()
    set(${count} ${known} PARENT_SCOPE)
    set(${twice} "${repeated}" PARENT_SCOPE)
endfunction()

# Tests the function itself: it must find exactly the duplicates.
file(WRITE ${SCRATCH}/first.h "namespace a {
struct Twice { int x; };
struct Outer { struct Once {}; };
struct Declared;
template<typename T> struct Special {};
template<> struct Special<int> {};
namespace { struct Hidden {}; }
}
")
file(WRITE ${SCRATCH}/second.cpp "namespace a {
struct Once {};
struct Declared {};
namespace { struct Hidden {}; }
}
class a::Twice final : public Declared {};
")
find_types_defined_twice("${SCRATCH}/first.h;${SCRATCH}/second.cpp" count twice)
if(NOT twice STREQUAL "a::Twice: ${SCRATCH}/first.h:2 and ${SCRATCH}/second.cpp:6" OR NOT count EQUAL 7)
    message(FATAL_ERROR "${CTAGS} does not see what it should: ${count} types, twice: ${twice}")
endif()

set(sources)
foreach(folder engine drivers calib sim app tests)
    file(GLOB_RECURSE found ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
    list(APPEND sources ${found})
endforeach()
find_types_defined_twice("${sources}" count twice)
foreach(name IN LISTS twice)
    message(SEND_ERROR "Defined twice: ${name}")
endforeach()
message("${count} types outside unnamed namespaces")
