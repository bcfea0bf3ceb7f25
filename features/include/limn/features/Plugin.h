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

/// Returns a hash of what the code of a feature assumes about limn. It covers the text of all
/// public headers, so that classes have the same members and virtual functions, and the sizes of
/// the classes that the two exchange, which depend on compilers and their settings.
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

/// The description of a shared module with features, which the module exports as `limn_plugin`.
/// LIMN_PLUGIN defines it; limn_add_feature (CMake) builds the module. The version must always stay
/// the first member.
struct Plugin
{
    const char* version;         ///< the version of limn it was compiled against
    const char* standardLibrary; ///< LIMN_STANDARD_LIBRARY
    std::uint64_t layout;        ///< PluginLayout()
    void (*registerFeatures)(FeatureRegistry&, VolumeComponentRegistry&);
    /// The shaders and the files they include; null = none.
    std::span<const EmbeddedFile> (*shaders)();
    const char* name;              ///< "Glow.so", set by limn_add_feature; "" without shaders
    const char* (*shaderFolder)(); ///< the folder of the embedded shaders; null = none
};

/// Returns why this limn cannot use a plug-in, or "" if it can. Reads nothing behind the version if
/// the version is another.
std::string PluginProblem(const Plugin& plugin);

/// Registers a plug-in's features and volume components, and adds its shaders to ShippedShaders()
/// unless they are there from an earlier call. Messages call a shader "Glow.so/X.shader"; its
/// includes are searched among the files of its plug-in first. Must be called before scenes are
/// loaded, by one thread at a time.
/// @param older  an older version of the same plug-in, whose shaders are replaced; null = none
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
    /// The description of the module that this header is compiled into.
    extern const limn::Plugin limn_plugin;
}

/// Defines the registration function of a plug-in. Must be used once per module, outside of all
/// namespaces:
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
