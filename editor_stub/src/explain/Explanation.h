#pragma once

#include "explain/ExplainedFrame.h"

#include <limn/core/UniversalRenderPipeline.h>
#include <limn/editor_stub/SceneFile.h>
#include <limn/volume/VolumeTrace.h>

namespace limn
{

/// The verdict of one filter of a pass or feature on one material of an object.
struct ExplainedDraw
{
    std::string pass; ///< the pass, or the feature's name if it does not draw by DrawRenderers
    std::string material;
    FilterVerdict verdict = FilterVerdict::Drawn;
    std::string obstacle;  ///< why the feature draws nothing, though its filter takes the object
    std::string feature{}; ///< "" for a pass of the renderer's own

    bool isDrawn() const { return verdict == FilterVerdict::Drawn && obstacle.empty(); }
};

/// An object with a renderer, and what became of it.
struct ExplainedObject
{
    std::string name;
    std::vector<std::string> parents; ///< names of the objects above it, nearest first
    std::string absence;              ///< why no pass sees it: "inactive"; "" if passes see it
    std::vector<ExplainedDraw> draws;
    std::size_t place = 0; ///< the index among all objects of the scene
};

/// A volume that changes nothing for the camera, or a renderer feature that draws nothing.
struct ExplainedIdle
{
    std::string name;
    std::string why; ///< see WhyIdle; for a feature the reason that it gives, "" if it gives none
};

/// The point at which the camera asks for volumes.
struct ExplainedTrigger
{
    glm::vec3 position{0.0f}; ///< in world space, in metres
    bool isOwn = false;       ///< true if the scene gives it; else it is the camera's position
    LayerMask volumeLayerMask;
};

/// A pass of a shader in the variant that was drawn with.
struct ExplainedVariant
{
    std::string shader;
    int passIndex = 0;
    std::string passName;              ///< "" if it has none
    std::vector<std::string> keywords; ///< the keywords that are on
    bool isFullScreen = false;         ///< drawn without a mesh
};

/// The draws of a scene's frame and the reasons for them, found out without a Vulkan device.
struct Explanation
{
    VolumeTrace volumes;
    std::vector<ExplainedIdle> idleVolumes; ///< scene order
    RenderReport report;
    ExplainedTrigger trigger;
    ExplainedFrame frame; ///< as the device runs it
    /// The variants that were drawn with, once each, in the order of first use.
    std::vector<ExplainedVariant> variants;
    int builtVariants = 0; ///< the number of variants that had to be compiled or fetched
    std::vector<ExplainedObject> objects;    ///< scene order
    std::vector<ExplainedIdle> idleFeatures; ///< the renderer's order
};

/// Returns the objects of a scene. Their addresses stay the same when the scene is moved.
std::vector<const GameObject*> ObjectsOf(const Scene& scene);

/// Returns what became of each of the objects that have a renderer.
/// @param culled  the results of culling for this camera
std::vector<ExplainedObject> ExplainObjects(const std::vector<const GameObject*>& objects,
                                            const CullingResults& culled,
                                            const RenderReport& report, const Camera& camera);

/// @throws AssetError for a shader with errors
Explanation Explain(SceneAsset asset, const AssetContext& assets);

/// Returns what a frame draws and why, in about a screen of text: what is odd, volume values,
/// passes with counts by verdict, what the device runs, what is left out, and the textures that are
/// drawn into.
std::string ShortText(const Explanation& explanation);

/// Returns all that is known: besides ShortText, each volume's part in each value, textures,
/// variants, and what each pass does with each object.
std::string LongText(const Explanation& explanation);

/// Returns only what became of the explanation's objects, which are `name` and everything below it.
/// @param isLong  lists each of them; otherwise they are listed one by one only if they are few
std::string ObjectText(const Explanation& explanation, const std::string& name, bool isLong);

} // namespace limn
