#pragma once

#include <limn/features/OutlineComponent.h>
#include <limn/volume/ValueParameters.h>

namespace limn
{

/// The convolution that finds how much the brightness changes around a pixel.
enum class EdgeOperator
{
    Roberts, ///< 4 taps, the corners
    Sobel,   ///< 8 taps, those in the middle of a side twice as heavy
    Prewitt  ///< 8 taps, all alike
};

/// What the lines of ColorEdgesRendererFeature look like, as volumes set it. The width is how far
/// the taps lie apart, and with that how wide the line at a sharp step is.
class ColorEdges final : public OutlineComponent
{
public:
    EnumParameter<EdgeOperator> m_Operator{this,
                                           "m_Operator",
                                           EdgeOperator::Sobel,
                                           {{"Roberts", EdgeOperator::Roberts},
                                            {"Sobel", EdgeOperator::Sobel},
                                            {"Prewitt", EdgeOperator::Prewitt}},
                                           {.tooltip = "How the gradient is computed."}};
    ClampedFloatParameter m_Threshold{
        this,
        "m_Threshold",
        0.1f,
        0.0f,
        1.0f,
        {.tooltip = "Steps of the brightness up to this one draw no line; black is 0, white 1."}};
    ClampedFloatParameter m_Softness{
        this,
        "m_Softness",
        0.0f,
        0.0f,
        1.0f,
        {.tooltip = "How far above the threshold a line gets its full strength; 0 = at once."}};
};

} // namespace limn
