#pragma once

#include <limn/core/Shader.h>
#include <limn/volume/VolumeComponentRegistry.h>
#include <span>
#include <string>

namespace limn
{

/// Returns a scene file in which a sphere is outlined, for a person to go on from.
/// @param profile  the name of the profile's file beside the scene
std::string NewScene(const std::string& profile);

/// Returns a profile with every parameter of some components, each with its default, what it may
/// be and what it is for; what switches an outline on is on.
/// @param components  registered names
std::string NewProfile(std::span<const std::string> components,
                       const VolumeComponentRegistry& registry);

/// Returns a material of the shader with each of its properties at its default; textures are
/// comments, as there is no file for them yet.
std::string NewMaterial(const Shader& shader);

} // namespace limn
