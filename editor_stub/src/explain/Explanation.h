#pragma once

#include "explain/ExplainedFrame.h"

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeTrace.h>

namespace limn
{

/// What one filter of a pass or feature did with one material of an object.
struct ExplainedDraw
{
    std::string pass; ///< or the feature's name, where it does not draw by DrawRenderers
    std::string material;
    FilterVerdict verdict = FilterVerdict::Drawn;
    std::string obstacle;  ///< why the feature draws nothing, though its filter takes the object
    std::string feature{}; ///< "": a pass of the renderer's own

    bool isDrawn() const { return verdict == FilterVerdict::Drawn && obstacle.empty(); }
};

/// What became of an object with a renderer.
struct ExplainedObject
{
    std::string name;
    std::vector<std::string> parents; ///< names of the objects it hangs below, nearest first
    std::string absence;              ///< why no pass sees it: "inactive"; "" if passes do
    std::vector<ExplainedDraw> draws;
};

/// A volume that changes nothing for the camera, or a renderer feature that draws nothing.
struct ExplainedIdle
{
    std::string name;
    std::string why; ///< see WhyIdle; of a feature what it says of that, "" where it says nothing
};

/// Where the camera asks for volumes.
struct ExplainedTrigger
{
    glm::vec3 position{0.0f}; ///< world, metres
    bool isOwn = false;       ///< given by the scene; else it is where the camera is
    LayerMask volumeLayerMask;
};

/// A pass of a shader as it was drawn with.
struct ExplainedVariant
{
    std::string shader;
    int passIndex = 0;
    std::string passName;              ///< "" if it has none
    std::vector<std::string> keywords; ///< those that are on
    bool isFullScreen = false;         ///< drawn without a mesh

    bool operator==(const ExplainedVariant&) const = default;
};

/// What a frame of a scene draws and why, found out without a Vulkan device.
struct Explanation
{
    VolumeTrace volumes;
    std::vector<ExplainedIdle> idleVolumes; ///< scene order
    RenderReport report;
    ExplainedTrigger trigger;
    ExplainedFrame frame;                    ///< as the device runs it
    std::vector<ExplainedVariant> variants;  ///< drawn with, once each, in the order of first use
    int builtVariants = 0;                   ///< those that had to be compiled or fetched
    std::vector<ExplainedObject> objects;    ///< scene order
    std::vector<ExplainedIdle> idleFeatures; ///< the renderer's order
};

/// The objects of a scene, which stay where they are when the scene is moved.
std::vector<const GameObject*> ObjectsOf(const Scene& scene);

/// What became of each of the objects that has a renderer.
/// @param culled  by this camera
std::vector<ExplainedObject> ExplainObjects(const std::vector<const GameObject*>& objects,
                                            const CullingResults& culled,
                                            const RenderReport& report, const Camera& camera);

/// @throws AssetError for a shader with errors
Explanation Explain(SceneAsset asset, const AssetContext& assets);

/// What a frame draws and why on about a screen: what is odd, volume values, passes with counts by
/// verdict, what the device runs, what is left out, the textures that are drawn into.
std::string ShortText(const Explanation& explanation);

/// All that is known: besides ShortText each volume's part in each value, textures, variants, and
/// of each object what each pass does with it.
std::string LongText(const Explanation& explanation);

/// Only what became of the explanation's objects, which are `name` and what hangs below it.
/// @param isLong  of each of them; else one by one only if they are few
std::string ObjectText(const Explanation& explanation, const std::string& name, bool isLong);

} // namespace limn
