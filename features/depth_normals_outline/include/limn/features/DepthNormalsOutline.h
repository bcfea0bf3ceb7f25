#pragma once

#include <limn/features/OutlineComponent.h>

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
    EnumParameter<DepthNormalsTechnique> m_Technique{
        this,
        "m_Technique",
        DepthNormalsTechnique::Hardened,
        {{"Hardened", DepthNormalsTechnique::Hardened},
         {"Article", DepthNormalsTechnique::Article}},
        {.tooltip = "The rule by which something counts as an edge."}};
    MinFloatParameter m_DepthThreshold{
        this,
        "m_DepthThreshold",
        0.1f,
        0.0f,
        {.tooltip = "Hardened: a line is drawn where a surface leaves its plane by more than this.",
         .unit = "metres"}};
    /// Normals with 8 bits per component have errors of up to 0.4 degrees each.
    ClampedFloatParameter m_AngleThreshold{
        this,
        "m_AngleThreshold",
        30.0f,
        2.0f,
        180.0f,
        {.tooltip = "Hardened: a line is drawn where a surface turns by more than this.",
         .unit = "degrees"}};
    ClampedFloatParameter m_Softness{this,
                                     "m_Softness",
                                     0.0f,
                                     0.0f,
                                     1.0f,
                                     {.tooltip = "Hardened: the distance above its threshold, as a "
                                                 "share of it, at which an edge has a full line."}};
    ClampedFloatParameter m_DepthSensitivity{
        this, "m_DepthSensitivity",
        0.2f, 0.0f,
        1.0f, {.tooltip = "Article: the sensitivity to changes of depth; 0 draws no line."}};
    ClampedFloatParameter m_NormalsSensitivity{
        this, "m_NormalsSensitivity",
        1.0f, 0.0f,
        1.0f, {.tooltip = "Article: the sensitivity to changes of the normals; 0 draws no line."}};
};

} // namespace limn
