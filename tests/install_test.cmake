# Tests that "cmake --install" puts everything where the program and udev find it.
#   Run after the build: cmake -DBUILD=<build folder> -DPREFIX=<empty folder> -P install_test.cmake
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(file bin/tractus lib/udev/rules.d/70-tractus.rules share/tractus/models/shrub.l
        share/tractus/habits/oak.habit share/tractus/demo/shrub.tractus-log)
    if(NOT EXISTS ${PREFIX}/${file})
        message(SEND_ERROR "${file} was not installed")
    endif()
endforeach()

# The installed program must prefer its installed models to those of the source tree.
file(WRITE ${PREFIX}/share/tractus/models/only_here.l "Lsystem: 1\nderivation length: 1\n\
Axiom: F(10)F(10)\nA --> A\nendlsystem\n")
execute_process(COMMAND ${PREFIX}/bin/tractus derive only_here --count
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${PREFIX})
