#pragma once

#include <limn/core/Scene.h>

namespace limn
{

class GraphicsDevice;
class ShaderCompiler;

/// Computes the light of the sky. Unity: UnityEngine.DynamicGI (2022.3).
class DynamicGI
{
public:
    /// Returns whether a scene has a sky that lights it or is mirrored.
    static bool NeedsEnvironment(const RenderSettings& settings)
    {
        return settings.skybox && (settings.ambientMode == AmbientMode::Skybox ||
                                   settings.defaultReflectionMode == DefaultReflectionMode::Skybox);
    }

    /// Draws the skybox as the main light lights it, and computes what the scene asks for:
    /// ambientProbe for AmbientMode::Skybox, skyReflection for DefaultReflectionMode::Skybox. Call
    /// it again when the sky or the light has changed. It does nothing if the scene asks for
    /// neither, or on a device that draws nothing. The disc of the sun of "Skybox/Procedural" is
    /// left out, since the main light is that light already. Texels that are not a number count as
    /// black, with a warning in the log.
    /// @param device  draws; the call waits for six small frames of it
    /// @param time    in seconds, the _Time of the sky's shader
    /// @throws AssetError (the sky's shader), VulkanError, ContractError if
    ///     defaultReflectionResolution is no power of two from 1 to 2048
    /// @source Unity: DynamicGI.UpdateEnvironment, which knows device and scene by itself
    static void UpdateEnvironment(GraphicsDevice& device,
                                  const std::shared_ptr<ShaderCompiler>& compiler, Scene& scene,
                                  double time = 0.0);
};

} // namespace limn
