#pragma once

#include <string>

namespace limn
{

/// A way to draw outlines of a given width.
enum class OutlineTechnique
{
    Auto,      ///< whichever is right for the objects, and then cheapest
    Strokes,   ///< StrokeOutlinePass
    Separable, ///< WideOutlineRenderPass, two passes that look as far as the width
    JumpFlood  ///< WideOutlineRenderPass, a pass for each doubling of the width
};

const char* ToString(OutlineTechnique technique);

/// What choosing a technique goes by.
struct OutlineWork
{
    double width = 0.0; ///< pixels
    int edgeCount = 0;  ///< silhouette edges that are drawn
    /// Pixels of their strokes, those that lie on others counted again.
    double strokeArea = 0.0;
    double regionArea = 0.0;    ///< pixels that the outline can touch, of all groups
    bool isAlphaTested = false; ///< a material cuts holes that the mesh does not have
};

struct OutlineChoice
{
    OutlineTechnique technique = OutlineTechnique::Strokes; ///< not Auto
    std::string why;                                        ///< for people
};

/// Strokes where the silhouette is the mesh's and they do not cost several times of what a distance
/// transform costs, which is less exact; of the two transforms the cheaper one.
OutlineChoice ChooseOutlineTechnique(const OutlineWork& work);

} // namespace limn
