#pragma once

// What the skeletons include, outside of the namespaces that each of them is put in here.
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <limn/core/ComputeShader.h>
#include <limn/core/CurrentCamera.h>
#include <limn/core/Debug.h>
#include <limn/core/Mathf.h>
#include <limn/core/NullCheck.h>
#include <limn/core/QualitySettings.h>
#include <limn/core/Random.h>
#include <limn/core/RenderGraph.h>
#include <limn/core/Resources.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/features/Plugin.h>
#include <limn/limn.h>

namespace limn::test
{

/// Registers the feature of a C# file, and its volume components.
/// @param file  its name without ".cs"
/// @param as    the name that the feature gets
void RegisterPorted(std::string_view file, FeatureRegistry& features,
                    VolumeComponentRegistry& components, const char* as);

} // namespace limn::test

// One program is no plug-in: what each registers is a function of its namespace.
#undef LIMN_PLUGIN
#define LIMN_PLUGIN(features, components)                                                          \
    static void LimnRegisterPlugin([[maybe_unused]] limn::FeatureRegistry& features,               \
                                   [[maybe_unused]] limn::VolumeComponentRegistry& components)
