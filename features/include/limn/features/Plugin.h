#pragma once

#include <cstddef>
#include <cstdint>
#include <limn/base/EmbeddedFile.h>
#include <limn/core/CommandBuffer.h>
#include <limn/core/Material.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/FeatureRegistry.h>
#include <limn/features/HeadersHash.h>
#include <limn/features/Version.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <span>

#if defined(_LIBCPP_VERSION)
#define LIMN_STANDARD_LIBRARY "libc++"
#elif defined(_GLIBCXX_DEBUG)
#define LIMN_STANDARD_LIBRARY "libstdc++ with _GLIBCXX_DEBUG"
#elif _GLIBCXX_USE_CXX11_ABI
#define LIMN_STANDARD_LIBRARY "libstdc++"
#else
#define LIMN_STANDARD_LIBRARY "libstdc++ of before C++11"
#endif

namespace limn
{

/// What the code of a feature takes for granted of limn, in one number: the text of all public
/// headers, so that classes have the same members and virtual functions, and the sizes of what the
/// two hand each other, which compilers and their settings change.
consteval std::uint64_t PluginLayout()
{
    std::uint64_t layout = LIMN_HEADERS_HASH;
    for (const std::size_t size : {sizeof(ScriptableRendererFeature), sizeof(ScriptableRenderPass),
                                   sizeof(ScriptableRenderer), sizeof(RenderingData),
                                   sizeof(CommandBuffer), sizeof(Material), sizeof(VolumeComponent),
                                   sizeof(FeatureRegistry), sizeof(VolumeComponentRegistry)})
    {
        layout = layout * 1000003 + size;
    }
    return layout;
}

/// What a shared module with features says of itself, under the name `limn_plugin`. LIMN_PLUGIN
/// defines it, limn_add_feature (CMake) builds the module. The version comes first for ever.
struct Plugin
{
    const char* version;         ///< of the limn it was compiled against
    const char* standardLibrary; ///< LIMN_STANDARD_LIBRARY
    std::uint64_t layout;        ///< PluginLayout()
    void (*registerFeatures)(FeatureRegistry&, VolumeComponentRegistry&);
    std::span<const EmbeddedFile> (*shaders)(); ///< and what they include; null = none
    const char* name;              ///< "Glow.so", by limn_add_feature; "" without shaders
    const char* (*shaderFolder)(); ///< where the shaders were embedded from; null = nowhere
};

/// Why a plug-in cannot be used by this limn, "" if it can. Reads nothing behind the version if
/// that is another.
std::string PluginProblem(const Plugin& plugin);

/// Registers a plug-in's features and volume components, and adds its shaders to ShippedShaders()
/// unless they are there from an earlier call. Messages call a shader "Glow.so/X.shader"; what it
/// includes is looked for among the files of its plug-in first. Before scenes are loaded, by one
/// thread at a time.
/// @param older  of the same plug-in, whose shaders make way; null = none
/// @throws ContractError if the name of a feature, a component or a shader is taken
/// @throws AssetError if a shader does not parse
void AddPlugin(const Plugin& plugin, FeatureRegistry& features, VolumeComponentRegistry& components,
               const Plugin* older = nullptr);

} // namespace limn

#ifdef LIMN_PLUGIN_SHADERS // by limn_add_feature: the function of limn_embed
namespace limn::embedded
{
std::span<const EmbeddedFile> LIMN_PLUGIN_SHADERS();
const char* LIMN_PLUGIN_SHADER_FOLDER();
} // namespace limn::embedded
#define LIMN_PLUGIN_SHADER_MEMBERS                                                                 \
    &limn::embedded::LIMN_PLUGIN_SHADERS, LIMN_PLUGIN_NAME,                                        \
        &limn::embedded::LIMN_PLUGIN_SHADER_FOLDER
#else
#define LIMN_PLUGIN_SHADER_MEMBERS nullptr, "", nullptr
#endif

extern "C"
{
    /// The one of the module that this is compiled into.
    extern const limn::Plugin limn_plugin;
}

/// The one registration function of a plug-in, outside of all namespaces, once a module:
///
///     LIMN_PLUGIN(features, components)
///     {
///         features.Register<GlowFeature>("GlowFeature");
///         components.Register<Glow>("Glow");
///     }
#define LIMN_PLUGIN(features, components)                                                          \
    static void LimnRegisterPlugin(limn::FeatureRegistry&, limn::VolumeComponentRegistry&);        \
    const limn::Plugin limn_plugin = {LIMN_VERSION_TEXT, LIMN_STANDARD_LIBRARY,                    \
                                      limn::PluginLayout(), &LimnRegisterPlugin,                   \
                                      LIMN_PLUGIN_SHADER_MEMBERS};                                 \
    static void LimnRegisterPlugin([[maybe_unused]] limn::FeatureRegistry& features,               \
                                   [[maybe_unused]] limn::VolumeComponentRegistry& components)
