#pragma once

#include <limn/core/Shader.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <span>
#include <string>

namespace limn
{

/// Returns a scene file in which a sphere is outlined, for a person to continue.
/// @param profile  the name of the profile's file beside the scene
std::string NewScene(const std::string& profile);

/// Returns a profile with every parameter of some components, each with its default, its possible
/// values and its purpose. Parameters that switch an outline on are on.
/// @param components  the components' registered names
std::string NewProfile(std::span<const std::string> components,
                       const VolumeComponentRegistry& registry);

/// Returns a material of the shader with each of its properties at its default. Textures are
/// comments, since there are no files for them yet.
std::string NewMaterial(const Shader& shader);

} // namespace limn
