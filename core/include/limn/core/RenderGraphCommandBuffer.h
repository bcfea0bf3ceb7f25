#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/RenderGraphResources.h>

namespace limn
{

class RenderGraphRun;
class UnsafeCommandBuffer;

namespace CommandBufferHelpers
{

/// Returns the command buffer for what only a CommandBuffer can do; it is valid until the render
/// function ends. Unity: UnityEngine.Rendering.CommandBufferHelpers (core 17).
CommandBuffer& GetNativeCommandBuffer(UnsafeCommandBuffer& cmd);

} // namespace CommandBufferHelpers

/// The calls that all render functions may record; CommandBuffer documents each of them.
/// Unity: UnityEngine.Rendering.BaseCommandBuffer (core 17).
class BaseCommandBuffer : protected CommandBuffer
{
public:
    BaseCommandBuffer(const BaseCommandBuffer&) = delete;
    BaseCommandBuffer& operator=(const BaseCommandBuffer&) = delete;

    using CommandBuffer::BeginSample;
    using CommandBuffer::ClearRenderTarget;
    using CommandBuffer::DrawMesh;
    using CommandBuffer::DrawMeshInstanced;
    using CommandBuffer::DrawMeshInstancedIndirect;
    using CommandBuffer::DrawMeshInstancedProcedural;
    using CommandBuffer::DrawMultipleMeshes;
    using CommandBuffer::DrawProcedural;
    using CommandBuffer::DrawProceduralIndirect;
    using CommandBuffer::DrawRenderer;
    using CommandBuffer::EndSample;
    using CommandBuffer::SetViewport;
    // These states end with the pass.
    using CommandBuffer::DisableScissorRect;
    using CommandBuffer::EnableScissorRect;
    using CommandBuffer::SetGlobalDepthBias;
    using CommandBuffer::SetInvertCulling;

    /// @throws ContractError if the pass did not call UseRendererList for the list
    void DrawRendererList(const RendererListHandle& rendererList);

    // These set globals. @throws ContractError after the pass has recorded, unless it has
    // AllowGlobalStateModification
    void SetGlobalFloat(ShaderPropertyId id, float value) { Globals(id).SetGlobalFloat(id, value); }
    void SetGlobalFloat(ShaderPropertyId id, detail::WholeNumber auto value)
    {
        SetGlobalFloat(id, static_cast<float>(value));
    }
    void SetGlobalInt(ShaderPropertyId id, int value) { Globals(id).SetGlobalInt(id, value); }
    void SetGlobalInteger(ShaderPropertyId id, int value) { SetGlobalInt(id, value); }
    void SetGlobalVector(ShaderPropertyId id, const glm::vec4& value)
    {
        Globals(id).SetGlobalVector(id, value);
    }
    void SetGlobalVector(ShaderPropertyId id, const detail::MadeVector4 auto& value)
    {
        SetGlobalVector(id, detail::ToVector4(value));
    }
    void SetGlobalColor(ShaderPropertyId id, const Color& value)
    {
        Globals(id).SetGlobalColor(id, value);
    }
    void SetGlobalMatrix(ShaderPropertyId id, const glm::mat4& value)
    {
        Globals(id).SetGlobalMatrix(id, value);
    }
    void SetGlobalFloatArray(ShaderPropertyId id, std::vector<float> values)
    {
        Globals(id).SetGlobalFloatArray(id, std::move(values));
    }
    void SetGlobalVectorArray(ShaderPropertyId id, std::vector<glm::vec4> values)
    {
        Globals(id).SetGlobalVectorArray(id, std::move(values));
    }
    void SetGlobalMatrixArray(ShaderPropertyId id, std::vector<glm::mat4> values)
    {
        Globals(id).SetGlobalMatrixArray(id, std::move(values));
    }
    /// @throws ContractError also for a texture of the graph that the pass does not declare
    void SetGlobalTexture(ShaderPropertyId id, const RTHandle& value);
    void SetGlobalBuffer(ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> value)
    {
        Globals(id).SetGlobalBuffer(id, std::move(value));
    }
    void SetGlobalConstantBuffer(std::shared_ptr<const GraphicsBuffer> buffer, ShaderPropertyId id,
                                 int offset, int size)
    {
        Globals(id).SetGlobalConstantBuffer(std::move(buffer), id, offset, size);
    }
    void SetViewProjectionMatrices(const glm::dmat4& view, const glm::mat4& gpuProjection,
                                   bool setInverseMatrices);
    void SetViewProjectionMatrices(const glm::dmat4& view, const glm::dmat4& proj)
    {
        SetViewMatrix(view);
        SetProjectionMatrix(proj);
    }
    void SetViewMatrix(const glm::dmat4& view);
    void SetProjectionMatrix(const glm::dmat4& proj);
    using CommandBuffer::DisableKeyword;
    using CommandBuffer::EnableKeyword;
    using CommandBuffer::SetKeyword;
    void EnableKeyword(const GlobalKeyword& keyword) { SetKeyword(keyword, true); }
    void DisableKeyword(const GlobalKeyword& keyword) { SetKeyword(keyword, false); }
    void SetKeyword(const GlobalKeyword& keyword, bool value);
    void EnableShaderKeyword(std::string_view keyword) { SetKeyword(GlobalKeyword(keyword), true); }
    void DisableShaderKeyword(std::string_view keyword)
    {
        SetKeyword(GlobalKeyword(keyword), false);
    }

protected:
    // The graph's handles are RTHandles.
    void SetComputeTextureParam(const std::shared_ptr<ComputeShader>& computeShader,
                                int kernelIndex, ShaderPropertyId id, const RTHandle& rt)
    {
        CommandBuffer::SetComputeTextureParam(computeShader, kernelIndex, id,
                                              RenderTargetIdentifier(rt));
    }
    void CopyTexture(const RTHandle& source, const RTHandle& dest)
    {
        CommandBuffer::CopyTexture(RenderTargetIdentifier(source), RenderTargetIdentifier(dest));
    }
    void GenerateMips(const RTHandle& rt)
    {
        CommandBuffer::GenerateMips(RenderTargetIdentifier(rt));
    }

    BaseCommandBuffer(CommandBuffer&& empty, RenderGraphRun& run)
        : CommandBuffer(std::move(empty)), m_Run(run)
    {
    }
    ~BaseCommandBuffer() = default;

private:
    friend class AnyCommandBuffer;
    friend class ProfilingScope;
    CommandBuffer& Globals(ShaderPropertyId id);

    RenderGraphRun& m_Run;
};

/// The command buffer of raster passes. Their targets are those that the builder was given, so
/// there is no call to set others. Unity: UnityEngine.Rendering.RasterCommandBuffer (core 17).
class RasterCommandBuffer : public BaseCommandBuffer
{
    friend class RenderGraphRun;
    using BaseCommandBuffer::BaseCommandBuffer;
};

/// The command buffer of compute passes, which has no call to draw or clear.
/// Unity: UnityEngine.Rendering.ComputeCommandBuffer (core 17).
class ComputeCommandBuffer : private BaseCommandBuffer
{
public:
    using BaseCommandBuffer::BeginSample;
    using BaseCommandBuffer::DisableKeyword;
    using BaseCommandBuffer::EnableKeyword;
    using BaseCommandBuffer::EndSample;
    using BaseCommandBuffer::SetComputeTextureParam;
    using BaseCommandBuffer::SetGlobalBuffer;
    using BaseCommandBuffer::SetGlobalColor;
    using BaseCommandBuffer::SetGlobalConstantBuffer;
    using BaseCommandBuffer::SetGlobalFloat;
    using BaseCommandBuffer::SetGlobalFloatArray;
    using BaseCommandBuffer::SetGlobalInt;
    using BaseCommandBuffer::SetGlobalInteger;
    using BaseCommandBuffer::SetGlobalMatrix;
    using BaseCommandBuffer::SetGlobalMatrixArray;
    using BaseCommandBuffer::SetGlobalTexture;
    using BaseCommandBuffer::SetGlobalVector;
    using BaseCommandBuffer::SetGlobalVectorArray;
    using BaseCommandBuffer::SetKeyword;
    using CommandBuffer::CopyCounterValue;
    using CommandBuffer::DispatchCompute;
    using CommandBuffer::SetBufferCounterValue;
    using CommandBuffer::SetBufferData;
    using CommandBuffer::SetComputeBufferParam;
    using CommandBuffer::SetComputeConstantBufferParam;
    using CommandBuffer::SetComputeFloatParam;
    using CommandBuffer::SetComputeFloatParams;
    using CommandBuffer::SetComputeIntParam;
    using CommandBuffer::SetComputeIntParams;
    using CommandBuffer::SetComputeMatrixArrayParam;
    using CommandBuffer::SetComputeMatrixParam;
    using CommandBuffer::SetComputeParamsFromMaterial;
    using CommandBuffer::SetComputeVectorArrayParam;
    using CommandBuffer::SetComputeVectorParam;

private:
    friend class ProfilingScope;
    friend class RenderGraphRun;
    using BaseCommandBuffer::BaseCommandBuffer;
};

/// The command buffer of unsafe passes. Unity: UnityEngine.Rendering.UnsafeCommandBuffer (core 17).
class UnsafeCommandBuffer : public BaseCommandBuffer
{
public:
    using BaseCommandBuffer::CopyTexture;
    using BaseCommandBuffer::GenerateMips;
    using BaseCommandBuffer::SetComputeTextureParam;
    using CommandBuffer::CopyBuffer;
    using CommandBuffer::CopyCounterValue;
    using CommandBuffer::DispatchCompute;
    using CommandBuffer::SetBufferCounterValue;
    using CommandBuffer::SetBufferData;
    using CommandBuffer::SetComputeBufferParam;
    using CommandBuffer::SetComputeConstantBufferParam;
    using CommandBuffer::SetComputeFloatParam;
    using CommandBuffer::SetComputeFloatParams;
    using CommandBuffer::SetComputeIntParam;
    using CommandBuffer::SetComputeIntParams;
    using CommandBuffer::SetComputeMatrixArrayParam;
    using CommandBuffer::SetComputeMatrixParam;
    using CommandBuffer::SetComputeParamsFromMaterial;
    using CommandBuffer::SetComputeVectorArrayParam;
    using CommandBuffer::SetComputeVectorParam;
    using CommandBuffer::SetRenderTarget;

private:
    friend class RenderGraphRun;
    using BaseCommandBuffer::BaseCommandBuffer;
};

/// The argument of a raster pass's render function.
/// Unity: UnityEngine.Rendering.RenderGraphModule.RasterGraphContext (core 17).
struct RasterGraphContext
{
    RasterCommandBuffer& cmd;
};

/// The argument of a compute pass's render function.
/// Unity: UnityEngine.Rendering.RenderGraphModule.ComputeGraphContext (core 17).
struct ComputeGraphContext
{
    ComputeCommandBuffer& cmd;
};

/// The argument of an unsafe pass's render function.
/// Unity: UnityEngine.Rendering.RenderGraphModule.UnsafeGraphContext (core 17).
struct UnsafeGraphContext
{
    UnsafeCommandBuffer& cmd;
};

} // namespace limn
