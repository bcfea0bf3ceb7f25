# limn_feature_folders(ROOT FUNCTION)
# What lies in the folders below ROOT, one a feature, found again whenever one is added:
#   feature_folders  those with C++, which have include/ and src/
#   feature_sources  their sources, and a generated one that defines limn::FUNCTION(FeatureRegistry&,
#                    VolumeComponentRegistry&), which calls the function that one of the sources of
#                    each defines: limn::RegisterRimOutline of rim_outline
#   feature_shaders  the .shader files of all folders, relative to ROOT
#   feature_header   the generated limn/features/AllFeatures.h, which includes their public headers
function(limn_feature_folders root function)
    file(GLOB sources CONFIGURE_DEPENDS ${root}/*/src/*.cpp)
    file(GLOB shaders CONFIGURE_DEPENDS RELATIVE ${root} ${root}/*/*.shader)
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${root}/*/include/*.h)
    list(TRANSFORM headers REPLACE "^.*/include/(limn/.*)$" "#include <\\1>\n")
    list(SORT headers)
    list(JOIN headers "" headers)
    set(header ${CMAKE_CURRENT_BINARY_DIR}/include/limn/features/AllFeatures.h)
    file(CONFIGURE OUTPUT ${header} CONTENT "#pragma once\n\n@headers@" @ONLY)
    set(names ${sources})
    list(TRANSFORM names REPLACE "^.*/([^/]+)/src/[^/]+$" "\\1")
    list(REMOVE_DUPLICATES names)
    set(declarations "")
    set(calls "")
    set(folders "")
    foreach(name ${names})
        set(register Register)
        string(REPLACE "_" ";" words ${name})
        foreach(word ${words})
            string(SUBSTRING ${word} 0 1 initial)
            string(SUBSTRING ${word} 1 -1 rest)
            string(TOUPPER ${initial} initial)
            string(APPEND register ${initial}${rest})
        endforeach()
        set(definition "")
        file(GLOB own ${root}/${name}/src/*.cpp)
        foreach(source ${own})
            file(STRINGS ${source} found REGEX "^void ${register}\\(FeatureRegistry&")
            string(APPEND definition "${found}")
        endforeach()
        if(definition STREQUAL "")
            message(FATAL_ERROR "${root}/${name}/src: no source defines\n"
                "void limn::${register}(FeatureRegistry&, VolumeComponentRegistry&)")
        endif()
        list(APPEND folders ${root}/${name})
        string(APPEND declarations
            "void ${register}(FeatureRegistry&, VolumeComponentRegistry&);\n")
        string(APPEND calls "    ${register}(features, components);\n")
    endforeach()
    file(CONFIGURE OUTPUT ${function}.cpp @ONLY CONTENT [[
namespace limn
{
class FeatureRegistry;
class VolumeComponentRegistry;
@declarations@
void @function@(FeatureRegistry& features, VolumeComponentRegistry& components);
void @function@(FeatureRegistry& features, VolumeComponentRegistry& components)
{
@calls@}
} // namespace limn
]])
    set(feature_folders ${folders} PARENT_SCOPE)
    set(feature_sources ${sources} ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp PARENT_SCOPE)
    set(feature_shaders ${shaders} PARENT_SCOPE)
    set(feature_header ${header} PARENT_SCOPE)
endfunction()
