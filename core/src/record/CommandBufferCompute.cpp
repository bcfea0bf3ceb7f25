#include <limn/core/CommandBuffer.h>

#include "material/PropertyValues.h"
#include "record/Arguments.h"
#include "record/RecordedCommands.h"

namespace limn
{

namespace
{

using ComputeShaderPtr = std::shared_ptr<ComputeShader>;

constexpr int k_MostGroups = 65535; // Direct3D's

void ExpectShader(const std::shared_ptr<const ComputeShader>& shader)
{
    if (!shader)
    {
        throw ContractError("a kernel needs a compute shader, but it is null");
    }
}

void ExpectKernel(const std::shared_ptr<const ComputeShader>& shader, int kernel)
{
    ExpectShader(shader);
    shader->kernelName(kernel); // throws
}

void ExpectBuffer(const std::shared_ptr<const GraphicsBuffer>& buffer, const char* call)
{
    if (!buffer)
    {
        throw ContractError(std::string(call) + ": the buffer is null");
    }
}

} // namespace

void CommandBuffer::SetBufferBytes(const std::shared_ptr<GraphicsBuffer>& buffer,
                                   const GraphicsBuffer::Part& part)
{
    ExpectBuffer(buffer, "SetBufferData");
    m_Commands.emplace_back(
        SetBufferDataCommand{buffer, {part.bytes.begin(), part.bytes.end()}, part.offset});
}

void CommandBuffer::SetBufferCounterValue(const std::shared_ptr<GraphicsBuffer>& buffer,
                                          std::uint32_t counterValue)
{
    ExpectBuffer(buffer, "SetBufferCounterValue");
    m_Commands.emplace_back(SetBufferCounterCommand{buffer, counterValue});
}

void CommandBuffer::CopyBuffer(const std::shared_ptr<const GraphicsBuffer>& source,
                               const std::shared_ptr<const GraphicsBuffer>& dest)
{
    constexpr const char* k_Call = "CopyBuffer";
    ExpectBuffer(source, k_Call);
    ExpectBuffer(dest, k_Call);
    const std::string subject =
        std::string(k_Call) + " from '" + source->name() + "' to '" + dest->name() + "': ";
    if (source == dest)
    {
        throw ContractError(subject +
                            "source and destination are the same buffer; copy between two");
    }
    if (source->size() != dest->size())
    {
        throw ContractError(subject + "they have " + std::to_string(source->size()) +
                            " bytes and " + std::to_string(dest->size()) +
                            "; both must have the same number");
    }
    if (!source->Has(GraphicsBuffer::Target::CopySource) ||
        !dest->Has(GraphicsBuffer::Target::CopyDestination))
    {
        throw ContractError(subject +
                            "the first must be made with GraphicsBuffer::Target::CopySource, the "
                            "second with CopyDestination");
    }
    m_Commands.emplace_back(CopyBufferCommand{
        source, dest, 0, 0, static_cast<std::uint32_t>((source->size() + 3) / 4)});
}

void CommandBuffer::CopyCounterValue(const std::shared_ptr<const GraphicsBuffer>& src,
                                     const std::shared_ptr<const GraphicsBuffer>& dst,
                                     std::uint32_t dstOffsetBytes)
{
    constexpr const char* k_Call = "CopyCounterValue";
    ExpectBuffer(src, k_Call);
    ExpectBuffer(dst, k_Call);
    if (!src->hasCounter())
    {
        throw ContractError(std::string(k_Call) + ": '" + src->name() +
                            "' has no counter; only the targets Append and Counter have one");
    }
    if (dstOffsetBytes % 4 != 0 || dst->size() < 4 || dstOffsetBytes > dst->size() - 4)
    {
        throw ContractError(std::string(k_Call) + " to byte " + std::to_string(dstOffsetBytes) +
                            " of '" + dst->name() + "', which has " + std::to_string(dst->size()) +
                            " bytes; the counter takes four bytes at a multiple of 4");
    }
    m_Commands.emplace_back(CopyBufferCommand{
        src, dst, static_cast<std::uint32_t>(src->counterOffset() / 4), dstOffsetBytes / 4, 1});
}

void CommandBuffer::DispatchCompute(std::shared_ptr<const ComputeShader> computeShader,
                                    int kernelIndex, int threadGroupsX, int threadGroupsY,
                                    int threadGroupsZ)
{
    ExpectShader(computeShader);
    const std::string& kernel = computeShader->kernelName(kernelIndex);
    const int counts[] = {threadGroupsX, threadGroupsY, threadGroupsZ};
    RecordedDispatch dispatch;
    for (std::size_t i = 0; i < 3; ++i)
    {
        if (counts[i] < 1 || counts[i] > k_MostGroups)
        {
            throw ContractError("DispatchCompute of '" + computeShader->name() + "', kernel '" +
                                kernel + "': it was given " + std::to_string(counts[0]) + "x" +
                                std::to_string(counts[1]) + "x" + std::to_string(counts[2]) +
                                " groups; each count must be from 1 to " +
                                std::to_string(k_MostGroups));
        }
        dispatch.groups[i] = static_cast<std::uint32_t>(counts[i]);
    }
    dispatch.shader = std::move(computeShader);
    dispatch.kernel = kernelIndex;
    m_Commands.emplace_back(std::move(dispatch));
}

void CommandBuffer::DispatchCompute(std::shared_ptr<const ComputeShader> computeShader,
                                    int kernelIndex,
                                    std::shared_ptr<const GraphicsBuffer> indirectBuffer,
                                    std::uint32_t argsOffset)
{
    ExpectKernel(computeShader, kernelIndex);
    RecordedDispatch dispatch;
    dispatch.arguments =
        ArgumentsRange("DispatchCompute", std::move(indirectBuffer), argsOffset, 3);
    dispatch.shader = std::move(computeShader);
    dispatch.kernel = kernelIndex;
    m_Commands.emplace_back(std::move(dispatch));
}

void CommandBuffer::SetParam(const ComputeShaderPtr& shader, ShaderPropertyId id,
                             ShaderPropertyValue value, int kernel)
{
    kernel == ComputeShader::k_AllKernels ? ExpectShader(shader) : ExpectKernel(shader, kernel);
    RequireFinite(value, id, "compute shader '" + shader->name() + "': ");
    m_Commands.emplace_back(SetComputeParamCommand{shader, kernel, id, std::move(value)});
}

void CommandBuffer::SetComputeTextureParam(const ComputeShaderPtr& computeShader, int kernelIndex,
                                           ShaderPropertyId id, RenderTargetIdentifier rt)
{
    ExpectKernel(computeShader, kernelIndex);
    m_Commands.emplace_back(
        SetComputeTextureCommand{computeShader, kernelIndex, id, std::move(rt)});
}

void CommandBuffer::SetComputeParamsFromMaterial(const ComputeShaderPtr& computeShader,
                                                 int kernelIndex,
                                                 std::shared_ptr<const Material> material)
{
    ExpectKernel(computeShader, kernelIndex);
    if (!material)
    {
        throw ContractError("SetComputeParamsFromMaterial of '" + computeShader->name() +
                            "': the material is null");
    }
    m_Commands.emplace_back(
        SetComputeParamsCommand{computeShader, kernelIndex, std::move(material)});
}

void CommandBuffer::SetKeyword(const ComputeShaderPtr& computeShader, std::string_view keyword,
                               bool value)
{
    ExpectShader(computeShader);
    m_Commands.emplace_back(SetComputeKeywordCommand{computeShader, std::string(keyword), value});
}

} // namespace limn
