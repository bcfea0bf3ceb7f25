#pragma once

#include <limn/features/OutlineComponent.h>
#include <limn/volume/ValueParameters.h>

namespace limn
{

/// The way to decide what is an edge of depth or normals.
enum class DepthNormalsTechnique
{
    Hardened, ///< by metres and degrees
    Article   ///< the article's arithmetic
};

/// The volume parameters of the lines of DepthNormalsOutlineRendererFeature. The width is that of a
/// line along a crease; the article calls it OutlineThickness.
class DepthNormalsOutline final : public OutlineComponent
{
public:
    EnumParameter<DepthNormalsTechnique> m_Technique{this,
                                                     "m_Technique",
                                                     DepthNormalsTechnique::Hardened,
                                                     {{"Hardened", DepthNormalsTechnique::Hardened},
                                                      {"Article", DepthNormalsTechnique::Article}},
                                                     {.tooltip = "What counts as an edge."}};
    MinFloatParameter m_DepthThreshold{
        this,
        "m_DepthThreshold",
        0.1f,
        0.0f,
        {.tooltip = "Hardened: how far a surface has to leave its plane for a line.",
         .unit = "metres"}};
    /// Normals with 8 bits per component have errors of up to 0.4 degrees each.
    ClampedFloatParameter m_AngleThreshold{
        this,
        "m_AngleThreshold",
        30.0f,
        2.0f,
        180.0f,
        {.tooltip = "Hardened: how far a surface has to turn for a line.", .unit = "degrees"}};
    ClampedFloatParameter m_Softness{this,
                                     "m_Softness",
                                     0.0f,
                                     0.0f,
                                     1.0f,
                                     {.tooltip = "Hardened: how far above its threshold, as a "
                                                 "share of it, an edge has a full line."}};
    ClampedFloatParameter m_DepthSensitivity{
        this, "m_DepthSensitivity",
        0.2f, 0.0f,
        1.0f, {.tooltip = "Article: how small a change of depth draws a line; 0 = none does."}};
    ClampedFloatParameter m_NormalsSensitivity{
        this,
        "m_NormalsSensitivity",
        1.0f,
        0.0f,
        1.0f,
        {.tooltip = "Article: how small a change of the normals draws a line; 0 = none does."}};
};

} // namespace limn
