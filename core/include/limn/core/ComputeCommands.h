#pragma once

#include <array>
#include <limn/core/ComputeShader.h>
#include <limn/core/RenderTargetIdentifier.h>

namespace limn
{

class Material;

// What a CommandBuffer records of kernels: it is looked at when the buffer is executed.

struct RecordedDispatch
{
    std::shared_ptr<const ComputeShader> shader;
    int kernel = 0;
    std::array<std::uint32_t, 3> groups{};
    BufferRange arguments; ///< with a buffer: it has the groups
};

struct SetComputeParamCommand
{
    std::shared_ptr<ComputeShader> shader;
    int kernel = ComputeShader::k_AllKernels;
    ShaderPropertyId id;
    ShaderPropertyValue value;
};

/// All that a material has a value for.
struct SetComputeParamsCommand
{
    std::shared_ptr<ComputeShader> shader;
    int kernel = 0;
    std::shared_ptr<const Material> material; ///< never null
};

struct SetComputeTextureCommand
{
    std::shared_ptr<ComputeShader> shader;
    int kernel = 0;
    ShaderPropertyId id;
    RenderTargetIdentifier texture;
};

struct SetComputeKeywordCommand
{
    std::shared_ptr<ComputeShader> shader;
    std::string keyword;
    bool isOn = false;
};

} // namespace limn
