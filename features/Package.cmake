# The Debian package: `cpack -G DEB` in a release build.
set(CPACK_PACKAGE_NAME limn)
set(CPACK_PACKAGE_VENDOR "the limn authors")
set(CPACK_PACKAGE_CONTACT "the limn authors <limn@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "draws scenes as Unity's render pipeline does, without Unity")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "limn is Unity's Universal Render Pipeline in miniature: it reads shaders, volume profiles and
scenes in Unity's formats and draws them with Vulkan, on a GPU or on the processor. It says what it
drew and what it left out, measures outlines, and begins the C++ of a render feature from its C#.
The package has the program, the libraries and headers to use it from C++, and samples.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(BUILD_SHARED_LIBS) # they are in the package themselves
    foreach(component ${components})
        get_target_property(folder limn_${component} BINARY_DIR)
        list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${folder})
    endforeach()
    list(REMOVE_DUPLICATES CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS)
endif()
# A driver for machines without a GPU, and what reads models other than glTF, which is loaded if it is there.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "mesa-vulkan-drivers, libassimp5")
# What draws graphs and reports, and what C++ programs are linked with that use the libraries.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "graphviz, gnuplot-nox, cmake, libvulkan-dev, glslang-dev, \
spirv-tools, libspirv-cross-c-shared-dev, libglm-dev, libyaml-cpp-dev, libpng-dev, libtinygltf-dev, \
nlohmann-json3-dev, libembree-dev, libtiff-dev, libopenexr-dev")
include(CPack)
