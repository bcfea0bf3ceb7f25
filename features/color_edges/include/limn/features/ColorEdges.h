#pragma once

#include <limn/features/OutlineComponent.h>

namespace limn
{

/// The convolution that finds how much the brightness changes around a pixel.
enum class EdgeOperator
{
    Roberts, ///< 4 taps, the corners
    Sobel,   ///< 8 taps; those in the middle of a side count twice
    Prewitt  ///< 8 taps with equal weights
};

/// The volume parameters of the lines of ColorEdgesRendererFeature. The width is the distance
/// between the taps, and therefore the width of the line at a sharp step.
class ColorEdges final : public OutlineComponent
{
public:
    EnumParameter<EdgeOperator> m_Operator{this,
                                           "m_Operator",
                                           EdgeOperator::Sobel,
                                           {{"Roberts", EdgeOperator::Roberts},
                                            {"Sobel", EdgeOperator::Sobel},
                                            {"Prewitt", EdgeOperator::Prewitt}},
                                           {.tooltip = "The formula that computes the gradient."}};
    ClampedFloatParameter m_Threshold{
        this,
        "m_Threshold",
        0.1f,
        0.0f,
        1.0f,
        {.tooltip =
             "The smallest step of the brightness that draws a line; black is 0, white is 1."}};
    ClampedFloatParameter m_Softness{this,
                                     "m_Softness",
                                     0.0f,
                                     0.0f,
                                     1.0f,
                                     {.tooltip = "The distance above the threshold at which a line "
                                                 "has its full strength; 0 is at once."}};
};

} // namespace limn
