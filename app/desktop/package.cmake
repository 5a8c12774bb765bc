# Settings for cpack. Run in the build folder, it makes a Debian package of the files that "cmake --install" installs.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tractus)
set(CPACK_PACKAGE_CONTACT "tractus developers <developers@tractus.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "3D sketching station for plants
Draw in space on a pen tablet that moves up and down: branches of a plant model
take the shape of what is drawn, motion indicators lean the whole plant, and a
growth simulation makes a collection in which no two plants are the same.
Without a tablet, a simulated rig draws.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries loaded at the first drawing, which are therefore not found automatically.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "udev")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/postinst)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
