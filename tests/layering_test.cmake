# Who may include whom, besides itself; and is every header compiled alone: as the first that a source
# of its name includes, or in a header set? Run: cmake -DROOT=<repository> -P layering_test.cmake
set(engine/base)
set(engine/stroke    engine/base)
set(engine/plant     engine/base engine/stroke)
set(engine/lsystem/text engine/base)
set(engine/lsystem/view engine/base engine/stroke engine/plant engine/lsystem/text)
set(engine/lsystem/language engine/base engine/lsystem/text engine/lsystem/view)
set(engine/lsystem/rewriting engine/base engine/lsystem/language)
set(engine/lsystem/fast_rewriting engine/base engine/lsystem/language engine/lsystem/rewriting)
set(engine/lsystem/turtle engine/base engine/plant engine/lsystem/view engine/lsystem/language
                          engine/lsystem/rewriting)
set(engine/lsystem/fast_drawing engine/base engine/plant engine/lsystem/view engine/lsystem/language
                                engine/lsystem/rewriting engine/lsystem/turtle)
set(engine/lsystem/derivation engine/base engine/lsystem/view engine/lsystem/language engine/lsystem/rewriting
                              engine/lsystem/fast_rewriting engine/lsystem/turtle)
set(engine/variation engine/base engine/stroke engine/plant)
set(engine/mesh      engine/base engine/plant)
set(engine/scene     engine/base engine/stroke engine/plant engine/lsystem engine/variation engine/mesh)
set(engine/export    engine/base engine/stroke engine/plant engine/lsystem engine/variation engine/mesh
                     engine/scene)
set(engine/methods/construction_lines engine/base engine/stroke engine/plant engine/lsystem
                                      engine/scene)
set(engine/methods/leaves engine/base engine/stroke engine/plant engine/scene)
set(engine/methods/silhouettes engine/base engine/stroke engine/plant engine/scene)
set(engine/methods/sketch_lsystem engine/base engine/stroke engine/plant engine/lsystem engine/scene)
set(drivers          engine/base)
set(calib            engine/base engine/stroke drivers)
set(sim              engine/base engine/stroke drivers calib)
set(app/render       engine/base engine/plant engine/mesh engine/export)
set(app/session      engine drivers)
set(app/tools        engine)
set(app/terminal     engine/base drivers)
set(app/document     engine app/session app/tools app/terminal)
set(app/station      engine drivers calib app/tools app/document app/terminal app/render app/diagnosis
                     app/calibration)
set(app/methods/indicators engine app/tools)
set(app/methods/plants engine app/tools)
set(app              engine drivers calib sim)

set(layers engine/base engine/stroke engine/plant engine/lsystem/text engine/lsystem/view
           engine/lsystem/language engine/lsystem/rewriting engine/lsystem/fast_rewriting
           engine/lsystem/turtle engine/lsystem/fast_drawing engine/lsystem/derivation engine/variation engine/mesh
           engine/scene engine/export engine/methods/construction_lines engine/methods/leaves
           engine/methods/silhouettes engine/methods/sketch_lsystem
           drivers calib sim app/render app/session app/tools app/terminal app/document app/station
           app/methods/indicators app/methods/plants app)

foreach(layer IN LISTS layers)
    set(allowed ${layer} ${${layer}})
    list(JOIN allowed "|" folders)
    file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${layer}/*.h ${ROOT}/${layer}/*.cpp)
    if(NOT sources)
        message(SEND_ERROR "${layer}: no sources; has it moved?")
    endif()
    foreach(source IN LISTS sources)
        file(STRINGS ${ROOT}/${source} includes REGEX "^#include \"")
        string(REGEX REPLACE "cpp$" "h" own ${source})
        if(source MATCHES "cpp$" AND EXISTS ${ROOT}/${own})
            list(POP_FRONT includes first)
            if(NOT first STREQUAL "#include \"${own}\"")
                message(SEND_ERROR "${source}: ${own} must be the first that it includes")
            endif()
        endif()
        foreach(include IN LISTS includes)
            if(NOT include MATCHES "\"(${folders})/")
                message(SEND_ERROR "${source}: ${include}: ${layer} may include only ${folders}")
            endif()
        endforeach()
    endforeach()

    file(GLOB_RECURSE headers ${ROOT}/${layer}/*.h)
    foreach(header IN LISTS headers)
        cmake_path(GET header PARENT_PATH folder)
        while(NOT EXISTS ${folder}/CMakeLists.txt)
            cmake_path(GET folder PARENT_PATH folder)
        endwhile()
        cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${folder} OUTPUT_VARIABLE listed)
        file(STRINGS ${folder}/CMakeLists.txt lists REGEX "[ ]${listed}([ )]|$)")
        if(NOT lists)
            message(SEND_ERROR "${header}: not in a header set of ${folder}/CMakeLists.txt")
        endif()
    endforeach()
endforeach()
