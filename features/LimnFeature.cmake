# limn_embed(target function BASE dir FILES ...)
# Compiles text files into `target` as std::span<const limn::EmbeddedFile> limn::embedded::function(),
# so that the program needs no data folder beside it. Paths are relative to BASE.
function(limn_embed target function)
    cmake_parse_arguments(ARG "" "BASE" "FILES" ${ARGN})
    set(entries "")
    foreach(path ${ARG_FILES})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARG_BASE}/${path})
        file(READ ${ARG_BASE}/${path} text)
        string(APPEND entries "    {\"${path}\", R\"limn_embed(${text})limn_embed\"sv},\n")
    endforeach()
    file(CONFIGURE OUTPUT embedded_${function}.cpp @ONLY CONTENT [[
#include <limn/base/EmbeddedFile.h>
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Woverlength-strings" // files may have more than 64 KiB
namespace limn::embedded
{
std::span<const EmbeddedFile> @function@();
std::span<const EmbeddedFile> @function@()
{
    using namespace std::string_view_literals; // with the length: counting it, Clang gives up
    static constexpr EmbeddedFile files[] = {
@entries@    };
    return files;
}
}
#pragma GCC diagnostic pop
]])
    target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded_${function}.cpp)
endfunction()

# limn_add_feature(name SOURCES ... [SHADERS ...])
# A plug-in `<name>.so` for `limn --plugin`, which holds its shaders and what they include (.shader,
# .hlsl, .cginc, .compute), and lies in the build folder. One of SOURCES has LIMN_PLUGIN of
# <limn/features/Plugin.h>. Paths are relative to the current folder, and so are those of #include.
# <name>_objects is what it is made of, to link a test with as well.
function(limn_add_feature name)
    cmake_parse_arguments(ARG "" "" "SOURCES;SHADERS" ${ARGN})
    if(NOT name MATCHES "^[A-Za-z_][A-Za-z0-9_]*$" OR NOT ARG_SOURCES)
        message(FATAL_ERROR "limn_add_feature(${name}): a name of letters, digits and _, and SOURCES, "
            "are expected")
    endif()
    add_library(${name}_objects OBJECT ${ARG_SOURCES})
    set_target_properties(${name}_objects PROPERTIES POSITION_INDEPENDENT_CODE ON)
    if(TARGET limn_features) # in limn's own build, which makes a header
        add_dependencies(${name}_objects limn_features)
    endif()
    target_compile_features(${name}_objects PUBLIC cxx_std_20)
    # Else a copy that is built and loaded later has its static variables in common with this one.
    target_compile_options(${name}_objects PRIVATE
        $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>)
    target_include_directories(${name}_objects PUBLIC
        $<TARGET_PROPERTY:limn::features,INTERFACE_INCLUDE_DIRECTORIES>)
    target_compile_definitions(${name}_objects PUBLIC
        $<TARGET_PROPERTY:limn::features,INTERFACE_COMPILE_DEFINITIONS>)
    foreach(shader ${ARG_SHADERS})
        if(NOT shader MATCHES "\\.(shader|hlsl|cginc|compute|glslinc)$")
            message(FATAL_ERROR "limn_add_feature(${name}): SHADERS: ${shader} is none of .shader, "
                ".hlsl, .cginc, .compute; a C++ file stands behind SOURCES")
        endif()
    endforeach()
    if(ARG_SHADERS)
        limn_embed(${name}_objects ${name}_shaders BASE ${CMAKE_CURRENT_SOURCE_DIR}
            FILES ${ARG_SHADERS})
        # In a file of its own: only it is compiled again for another checkout.
        file(CONFIGURE OUTPUT embedded_${name}_folder.cpp @ONLY CONTENT [[
namespace limn::embedded
{
const char* @name@_shader_folder();
const char* @name@_shader_folder()
{
    return R"limn_embed(@CMAKE_CURRENT_SOURCE_DIR@)limn_embed";
}
}
]])
        target_sources(${name}_objects PRIVATE
            ${CMAKE_CURRENT_BINARY_DIR}/embedded_${name}_folder.cpp)
        target_compile_definitions(${name}_objects PRIVATE LIMN_PLUGIN_NAME="${name}.so"
            LIMN_PLUGIN_SHADERS=${name}_shaders LIMN_PLUGIN_SHADER_FOLDER=${name}_shader_folder)
    endif()
    add_library(${name} MODULE $<TARGET_OBJECTS:${name}_objects>)
    set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX .so LINKER_LANGUAGE CXX)
    # Static libraries of limn are in the program already, which hands them to what it loads; a second
    # copy would know nothing of the first one's shaders and names.
    get_target_property(type limn::features TYPE)
    if(type STREQUAL SHARED_LIBRARY)
        target_link_libraries(${name} PRIVATE limn::features)
    endif()
endfunction()
