# Settings for cpack. Run in the build folder, it makes Debian packages of the files that "cmake --install" installs:
# tractus and, if the Python module is built, python3-tractus.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tractus)
set(CPACK_PACKAGE_CONTACT "tractus developers <developers@tractus.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified) # What has no component of its own.
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME tractus)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "3D sketching station for plants
Draw in space on a pen tablet that moves up and down: branches of a plant model
take the shape of what is drawn, motion indicators lean the whole plant, and a
growth simulation makes a collection in which no two plants are the same.
Without a tablet, a simulated rig draws.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries loaded at the first drawing, which are therefore not found automatically.
set(drawing "libegl1, libgl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_DEPENDS ${drawing})
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS "udev")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/postinst)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# The module is compiled for one version of Python. It reads the models that come with the program.
if(TARGET tractus_python)
    list(APPEND CPACK_COMPONENTS_ALL python)
    get_target_property(python_version tractus_python TRACTUS_PYTHON_VERSION)
    string(REPLACE "." ";" next_python ${python_version})
    list(POP_BACK next_python minor)
    math(EXPR minor "${minor} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tractus)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "tractus (= ${PROJECT_VERSION}), ${drawing}, python3-numpy, \
python3 (>= ${python_version}), python3 (<< ${next_python}.${minor})")
    set(CPACK_DEBIAN_PYTHON_DESCRIPTION "plants of tractus as numpy arrays (Python 3)
L-systems, trees that grow by themselves, sessions and recorded drawings of
tractus, the 3D sketching station for plants: strings, skeletons, organs,
triangles and strokes as numpy arrays, and all formats of files.")
    # Without the module, which "all" builds and app/run does not, there is no package of it.
    set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_BINARY_DIR}/package_built.cmake)
    file(GENERATE OUTPUT ${CPACK_PROJECT_CONFIG_FILE} CONTENT
"if(NOT EXISTS \"$<TARGET_FILE:tractus_python>\")
    list(REMOVE_ITEM CPACK_COMPONENTS_ALL python)
endif()
")
endif()
include(CPack)
