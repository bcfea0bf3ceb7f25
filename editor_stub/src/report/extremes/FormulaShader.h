#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <limn/editor_stub/AssetContext.h>
#include <span>
#include <string>
#include <vector>

namespace limn
{
class GraphicsDevice;
}

namespace limn::study
{

/// Two expressions in HLSL of the numbers a, b, c and d, and these.
struct ShaderExpression
{
    std::string first;
    std::string second;
    glm::vec4 values{0.0f}; ///< beyond 1e38: infinite; no constants for the compiler
};

/// What a device makes of them, to the bit of its floats.
std::vector<std::array<double, 2>> Evaluate(std::span<const ShaderExpression> expressions,
                                            AssetContext& assets, GraphicsDevice& device);

} // namespace limn::study
