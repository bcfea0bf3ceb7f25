#pragma once

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeTrace.h>

namespace limn
{

/// What one DrawRenderers call did with one material of an object.
struct ExplainedDraw
{
    std::string pass;
    std::string material;
    FilterVerdict verdict = FilterVerdict::Drawn;
};

/// What became of an object with a renderer.
struct ExplainedObject
{
    std::string name;
    std::vector<std::string> parents; ///< names of the objects it hangs below, nearest first
    std::string absence;              ///< why no pass sees it: "inactive"; "" if passes do
    std::vector<ExplainedDraw> draws;
};

/// What a frame of a scene draws and why, found out without a Vulkan device.
struct Explanation
{
    VolumeTrace volumes;
    RenderReport report;
    std::vector<std::string> textures; ///< "name 640x360 R8G8B8A8_SRGB", once each, as first used
    std::vector<std::string> variants; ///< "shader, pass 'name'", each that objects are drawn with
    std::vector<ExplainedObject> objects; ///< scene order
};

/// @throws AssetError for a shader with errors
Explanation Explain(SceneAsset asset, const AssetContext& assets);

} // namespace limn
