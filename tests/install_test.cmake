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

# So must the installed Python module, if it is built.
file(GLOB module ${BUILD}/python/tractus/__init__*.so)
if(module)
    file(GLOB packages ${PREFIX}/lib/python3*/dist-packages)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${packages} PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c
        "import tractus; print(tractus.Model('only_here').derive())"
        OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
    if(NOT printed STREQUAL "F(10)F(10)\n")
        message(SEND_ERROR "the installed module derives ${printed}")
    endif()
endif()
file(REMOVE_RECURSE ${PREFIX})
