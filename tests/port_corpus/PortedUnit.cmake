# limn_ported_unit(OUTPUT FILE...) makes one source of what `limn port` writes of C# files, each in a
# namespace of its own: classes of equal names are no concern of each other's in plug-ins, and so
# neither here. PortedUnit.h has the function that the source defines.
function(limn_ported_unit output)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/ported)
    set(includes "")
    set(registrations "")
    set(written "")
    foreach(csharp ${ARGN})
        cmake_path(GET csharp STEM name)
        string(REGEX REPLACE "(Renderer|Render)?Feature$" "" plain ${name})
        file(MAKE_DIRECTORY ${folder}/${name})
        list(APPEND written ${folder}/${name}/${name}.h ${folder}/${name}/${name}.cpp)
        string(APPEND includes "namespace ported_${name}\n{\n#include \"${folder}/${name}/${name}.cpp\"\n}\n")
        string(APPEND registrations "    if (file == \"${name}\")\n    {\n"
            "        features.Register<ported_${name}::${plain}Plugin::${name}>(as);\n"
            "        limn::FeatureRegistry others;\n"
            "        ported_${name}::LimnRegisterPlugin(others, components);\n    }\n")
    endforeach()
    set(port ${PROJECT_SOURCE_DIR}/tests/port_corpus/port.cmake)
    add_custom_command(OUTPUT ${written}
        COMMAND ${CMAKE_COMMAND} -DLIMN=$<TARGET_FILE:limn> "-DFILES=${ARGN}" -DFOLDER=${folder}
            -P ${port}
        DEPENDS ${ARGN} limn ${port} COMMENT "Porting C# features" VERBATIM)
    file(CONFIGURE OUTPUT ${output} @ONLY CONTENT [[
#include "PortedUnit.h"

@includes@
void limn::test::RegisterPorted(std::string_view file, limn::FeatureRegistry& features,
                                limn::VolumeComponentRegistry& components, const char* as)
{
@registrations@}
]])
    set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${output} PROPERTIES
        OBJECT_DEPENDS "${written}" SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
