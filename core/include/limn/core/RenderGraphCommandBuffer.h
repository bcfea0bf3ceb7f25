#pragma once

#include <limn/core/CoreUtils.h>
#include <limn/core/RenderGraphResources.h>

namespace limn
{

class BaseCommandBuffer;

namespace CoreUtils
{

void DrawFullScreen(BaseCommandBuffer& cmd, std::shared_ptr<const Material> material,
                    const MaterialPropertyBlock& properties = {}, int shaderPassId = 0);

} // namespace CoreUtils

// Blitter's calls for RasterCommandBuffer and UnsafeCommandBuffer: what they draw, CommandBuffer's
// say. The graph pass declares the source as it does for any other draw.
// Unity: UnityEngine.Rendering.Blitter (core 17).
namespace Blitter
{

void BlitTexture(BaseCommandBuffer& cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
/// The source is global as _BlitTexture from then on, which the report notes unless the pass does
/// AllowGlobalStateModification.
void BlitTexture(BaseCommandBuffer& cmd, RenderTargetIdentifier source, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
void BlitTexture(BaseCommandBuffer& cmd, const glm::vec4& scaleBias,
                 std::shared_ptr<const Material> material, int passIndex);
void BlitTexture(BaseCommandBuffer& cmd, const RTHandle& source, const glm::vec4& scaleBias,
                 float mipLevel, bool bilinear);
inline void BlitTexture2D(BaseCommandBuffer& cmd, const RTHandle& source,
                          const glm::vec4& scaleBias, float mipLevel, bool bilinear)
{
    BlitTexture(cmd, source, scaleBias, mipLevel, bilinear);
}

void BlitQuad(BaseCommandBuffer& cmd, const std::shared_ptr<const Texture>& source,
              const glm::vec4& scaleBiasTex, const glm::vec4& scaleBiasRT, int mipLevelTex,
              bool bilinear);
inline void BlitQuad(BaseCommandBuffer& cmd, const RTHandle& source, const glm::vec4& scaleBiasTex,
                     const glm::vec4& scaleBiasRT, int mipLevelTex, bool bilinear)
{
    BlitQuad(cmd, source.rt(), scaleBiasTex, scaleBiasRT, mipLevelTex, bilinear);
}

void BlitColorAndDepth(BaseCommandBuffer& cmd, const std::shared_ptr<const Texture>& sourceColor,
                       const std::shared_ptr<const RenderTexture>& sourceDepth,
                       const glm::vec4& scaleBias, float mipLevel, bool blitDepth);
inline void BlitColorAndDepth(BaseCommandBuffer& cmd, const RTHandle& sourceColor,
                              const RTHandle& sourceDepth, const glm::vec4& scaleBias,
                              float mipLevel, bool blitDepth)
{
    BlitColorAndDepth(cmd, sourceColor.rt(), sourceDepth.rt(), scaleBias, mipLevel, blitDepth);
}

} // namespace Blitter

class RenderGraphRun;
class UnsafeCommandBuffer;

namespace CommandBufferHelpers
{

/// For what only a CommandBuffer can do, until the render function ends.
/// Unity: UnityEngine.Rendering.CommandBufferHelpers (core 17).
CommandBuffer& GetNativeCommandBuffer(UnsafeCommandBuffer& cmd);

} // namespace CommandBufferHelpers

namespace detail
{

CommandBuffer& NativeOf(BaseCommandBuffer& cmd); ///< for Blitter and CoreUtils

} // namespace detail

/// What all render functions may record. Calls are CommandBuffer's, which says more of them.
/// Unity: UnityEngine.Rendering.BaseCommandBuffer (core 17).
class BaseCommandBuffer
{
public:
    BaseCommandBuffer(const BaseCommandBuffer&) = delete;
    BaseCommandBuffer& operator=(const BaseCommandBuffer&) = delete;

    void ClearRenderTarget(ClearFlag flags, const Color& color, float depth = 1.0f, int stencil = 0)
    {
        m_Native.ClearRenderTarget(flags, color, depth, stencil);
    }
    void ClearRenderTarget(bool clearDepth, bool clearColor, const Color& backgroundColor,
                           float depth = 1.0f)
    {
        m_Native.ClearRenderTarget(clearDepth, clearColor, backgroundColor, depth);
    }
    void SetViewport(const ViewportRect& pixelRect) { m_Native.SetViewport(pixelRect); }
    // These end with the pass.
    void EnableScissorRect(const ViewportRect& scissor) { m_Native.EnableScissorRect(scissor); }
    void DisableScissorRect() { m_Native.DisableScissorRect(); }
    void SetInvertCulling(bool invertCulling) { m_Native.SetInvertCulling(invertCulling); }
    void SetGlobalDepthBias(float bias, float slopeBias)
    {
        m_Native.SetGlobalDepthBias(bias, slopeBias);
    }

    void DrawMesh(std::shared_ptr<const Mesh> mesh, const glm::mat4& matrix,
                  std::shared_ptr<const Material> material, int subMesh = 0, int shaderPass = 0,
                  const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawMesh(std::move(mesh), matrix, std::move(material), subMesh, shaderPass,
                          properties);
    }
    void DrawMultipleMeshes(std::span<const glm::mat4> matrices,
                            std::span<const std::shared_ptr<const Mesh>> meshes,
                            std::span<const int> subsetIndices, int count,
                            const std::shared_ptr<const Material>& material, int shaderPass = -1,
                            const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawMultipleMeshes(matrices, meshes, subsetIndices, count, material, shaderPass,
                                    properties);
    }
    void DrawMeshInstanced(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                           const std::shared_ptr<const Material>& material, int shaderPass,
                           std::span<const glm::mat4> matrices,
                           const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawMeshInstanced(mesh, submeshIndex, material, shaderPass, matrices, properties);
    }
    void DrawMeshInstanced(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                           const std::shared_ptr<const Material>& material, int shaderPass,
                           std::span<const glm::mat4> matrices, int count,
                           const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawMeshInstanced(mesh, submeshIndex, material, shaderPass, matrices, count,
                                   properties);
    }
    void DrawRenderer(const GameObject& object, const std::shared_ptr<const Material>& material,
                      int submeshIndex = 0, int shaderPass = -1,
                      const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawRenderer(object, material, submeshIndex, shaderPass, properties);
    }
    void DrawProcedural(const glm::mat4& matrix, std::shared_ptr<const Material> material,
                        int shaderPass, int vertexCount,
                        const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawProcedural(matrix, std::move(material), shaderPass, vertexCount, properties);
    }
    void DrawProcedural(const glm::mat4& matrix, std::shared_ptr<const Material> material,
                        int shaderPass, MeshTopology topology, int vertexCount,
                        int instanceCount = 1, const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawProcedural(matrix, std::move(material), shaderPass, topology, vertexCount,
                                instanceCount, properties);
    }
    void DrawMeshInstancedProcedural(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                                     const std::shared_ptr<const Material>& material,
                                     int shaderPass, int count,
                                     const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawMeshInstancedProcedural(mesh, submeshIndex, material, shaderPass, count,
                                             properties);
    }
    void DrawMeshInstancedIndirect(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                                   const std::shared_ptr<const Material>& material, int shaderPass,
                                   const std::shared_ptr<const GraphicsBuffer>& bufferWithArgs,
                                   int argsOffset = 0, const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawMeshInstancedIndirect(mesh, submeshIndex, material, shaderPass, bufferWithArgs,
                                           argsOffset, properties);
    }
    void DrawProceduralIndirect(const glm::mat4& matrix,
                                const std::shared_ptr<const Material>& material, int shaderPass,
                                MeshTopology topology,
                                const std::shared_ptr<const GraphicsBuffer>& bufferWithArgs,
                                int argsOffset = 0, const MaterialPropertyBlock& properties = {})
    {
        m_Native.DrawProceduralIndirect(matrix, material, shaderPass, topology, bufferWithArgs,
                                        argsOffset, properties);
    }
    /// @throws ContractError if the pass did not UseRendererList of it
    void DrawRendererList(const RendererListHandle& rendererList);

    // Globals: @throws ContractError unless the pass does AllowGlobalStateModification, when it has
    // recorded.
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
    /// @throws ContractError for a texture of the graph that the pass does not declare, too
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
    void EnableKeyword(const GlobalKeyword& keyword) { SetKeyword(keyword, true); }
    void DisableKeyword(const GlobalKeyword& keyword) { SetKeyword(keyword, false); }
    void SetKeyword(const GlobalKeyword& keyword, bool value)
    {
        Keywords(keyword).SetKeyword(keyword, value);
    }
    void SetKeyword(const std::shared_ptr<Material>& material, const LocalKeyword& keyword,
                    bool value)
    {
        m_Native.SetKeyword(material, keyword, value);
    }
    void EnableKeyword(const std::shared_ptr<Material>& material, const LocalKeyword& keyword)
    {
        SetKeyword(material, keyword, true);
    }
    void DisableKeyword(const std::shared_ptr<Material>& material, const LocalKeyword& keyword)
    {
        SetKeyword(material, keyword, false);
    }
    void EnableShaderKeyword(std::string_view name) { SetKeyword(GlobalKeyword(name), true); }
    void DisableShaderKeyword(std::string_view name) { SetKeyword(GlobalKeyword(name), false); }

    void BeginSample(std::string_view name) { m_Native.BeginSample(name); }
    void EndSample() { m_Native.EndSample(); }
    void EndSample(std::string_view name) { m_Native.EndSample(name); }

protected:
    BaseCommandBuffer(CommandBuffer& native, RenderGraphRun& run) : m_Native(native), m_Run(run) {}
    ~BaseCommandBuffer() = default;
    CommandBuffer& native() { return m_Native; }

private:
    friend CommandBuffer& detail::NativeOf(BaseCommandBuffer& cmd);
    CommandBuffer& Globals(ShaderPropertyId id);
    CommandBuffer& Keywords(const GlobalKeyword& keyword);

    CommandBuffer& m_Native;
    RenderGraphRun& m_Run;
};

/// Of raster passes, whose targets are those that the builder was told: there is no call to set
/// others. Unity: UnityEngine.Rendering.RasterCommandBuffer (core 17).
class RasterCommandBuffer : public BaseCommandBuffer
{
    friend class RenderGraphRun;
    using BaseCommandBuffer::BaseCommandBuffer;
};

/// What render functions may record of kernels. Calls are CommandBuffer's, which says more of them.
class KernelCommands
{
public:
    using Shader = std::shared_ptr<ComputeShader>;

    void DispatchCompute(const std::shared_ptr<const ComputeShader>& computeShader, int kernelIndex,
                         int threadGroupsX, int threadGroupsY, int threadGroupsZ)
    {
        m_Cmd.DispatchCompute(computeShader, kernelIndex, threadGroupsX, threadGroupsY,
                              threadGroupsZ);
    }
    void DispatchCompute(const std::shared_ptr<const ComputeShader>& computeShader, int kernelIndex,
                         std::shared_ptr<const GraphicsBuffer> indirectBuffer,
                         std::uint32_t argsOffset)
    {
        m_Cmd.DispatchCompute(computeShader, kernelIndex, std::move(indirectBuffer), argsOffset);
    }
    template <std::ranges::contiguous_range Data>
    void SetBufferData(const std::shared_ptr<GraphicsBuffer>& buffer, const Data& data)
    {
        m_Cmd.SetBufferData(buffer, data);
    }
    template <std::ranges::contiguous_range Data>
    void SetBufferData(const std::shared_ptr<GraphicsBuffer>& buffer, const Data& data,
                       int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
    {
        m_Cmd.SetBufferData(buffer, data, managedBufferStartIndex, graphicsBufferStartIndex, count);
    }
    void SetBufferCounterValue(const std::shared_ptr<GraphicsBuffer>& buffer,
                               std::uint32_t counterValue)
    {
        m_Cmd.SetBufferCounterValue(buffer, counterValue);
    }
    void SetComputeFloatParam(const Shader& computeShader, ShaderPropertyId id, float value)
    {
        m_Cmd.SetComputeFloatParam(computeShader, id, value);
    }
    void SetComputeIntParam(const Shader& computeShader, ShaderPropertyId id, int value)
    {
        m_Cmd.SetComputeIntParam(computeShader, id, value);
    }
    void SetComputeVectorParam(const Shader& computeShader, ShaderPropertyId id,
                               const glm::vec4& value)
    {
        m_Cmd.SetComputeVectorParam(computeShader, id, value);
    }
    void SetComputeVectorParam(const Shader& computeShader, ShaderPropertyId id,
                               const detail::MadeVector4 auto& value)
    {
        m_Cmd.SetComputeVectorParam(computeShader, id, value);
    }
    void SetComputeVectorArrayParam(const Shader& computeShader, ShaderPropertyId id,
                                    std::vector<glm::vec4> values)
    {
        m_Cmd.SetComputeVectorArrayParam(computeShader, id, std::move(values));
    }
    void SetComputeMatrixParam(const Shader& computeShader, ShaderPropertyId id,
                               const glm::mat4& value)
    {
        m_Cmd.SetComputeMatrixParam(computeShader, id, value);
    }
    void SetComputeMatrixArrayParam(const Shader& computeShader, ShaderPropertyId id,
                                    std::vector<glm::mat4> values)
    {
        m_Cmd.SetComputeMatrixArrayParam(computeShader, id, std::move(values));
    }
    void SetComputeFloatParams(const Shader& computeShader, ShaderPropertyId id,
                               std::vector<float> values)
    {
        m_Cmd.SetComputeFloatParams(computeShader, id, std::move(values));
    }
    void SetComputeIntParams(const Shader& computeShader, ShaderPropertyId id,
                             std::vector<int> values)
    {
        m_Cmd.SetComputeIntParams(computeShader, id, std::move(values));
    }
    template <detail::FloatArgument First, detail::FloatArgument... More>
    void SetComputeFloatParams(const Shader& computeShader, ShaderPropertyId id, First first,
                               More... more)
    {
        m_Cmd.SetComputeFloatParams(computeShader, id, first, more...);
    }
    template <std::same_as<int> First, std::same_as<int>... More>
    void SetComputeIntParams(const Shader& computeShader, ShaderPropertyId id, First first,
                             More... more)
    {
        m_Cmd.SetComputeIntParams(computeShader, id, first, more...);
    }
    void SetComputeParamsFromMaterial(const Shader& computeShader, int kernelIndex,
                                      std::shared_ptr<const Material> material)
    {
        m_Cmd.SetComputeParamsFromMaterial(computeShader, kernelIndex, std::move(material));
    }
    void CopyCounterValue(const std::shared_ptr<const GraphicsBuffer>& src,
                          const std::shared_ptr<const GraphicsBuffer>& dst,
                          std::uint32_t dstOffsetBytes)
    {
        m_Cmd.CopyCounterValue(src, dst, dstOffsetBytes);
    }
    void SetComputeTextureParam(const Shader& computeShader, int kernelIndex, ShaderPropertyId id,
                                const RTHandle& rt)
    {
        m_Cmd.SetComputeTextureParam(computeShader, kernelIndex, id, rt);
    }
    void SetComputeBufferParam(const Shader& computeShader, int kernelIndex, ShaderPropertyId id,
                               std::shared_ptr<const GraphicsBuffer> buffer)
    {
        m_Cmd.SetComputeBufferParam(computeShader, kernelIndex, id, std::move(buffer));
    }
    void SetComputeConstantBufferParam(const Shader& computeShader, ShaderPropertyId id,
                                       std::shared_ptr<const GraphicsBuffer> buffer, int offset,
                                       int size)
    {
        m_Cmd.SetComputeConstantBufferParam(computeShader, id, std::move(buffer), offset, size);
    }
    void SetKeyword(const Shader& computeShader, std::string_view keyword, bool value)
    {
        m_Cmd.SetKeyword(computeShader, keyword, value);
    }
    void EnableKeyword(const Shader& computeShader, std::string_view keyword)
    {
        m_Cmd.SetKeyword(computeShader, keyword, true);
    }
    void DisableKeyword(const Shader& computeShader, std::string_view keyword)
    {
        m_Cmd.SetKeyword(computeShader, keyword, false);
    }

protected:
    explicit KernelCommands(CommandBuffer& cmd) : m_Cmd(cmd) {}
    ~KernelCommands() = default;

private:
    CommandBuffer& m_Cmd;
};

/// Of compute passes: there is no call to draw or clear.
/// Unity: UnityEngine.Rendering.ComputeCommandBuffer (core 17).
class ComputeCommandBuffer : private BaseCommandBuffer, public KernelCommands
{
public:
    using BaseCommandBuffer::BeginSample;
    using BaseCommandBuffer::DisableKeyword;
    using BaseCommandBuffer::EnableKeyword;
    using BaseCommandBuffer::EndSample;
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
    using KernelCommands::DisableKeyword;
    using KernelCommands::EnableKeyword;
    using KernelCommands::SetKeyword;

private:
    friend class RenderGraphRun;
    ComputeCommandBuffer(CommandBuffer& native, RenderGraphRun& run)
        : BaseCommandBuffer(native, run), KernelCommands(native)
    {
    }
};

/// Of unsafe passes. Unity: UnityEngine.Rendering.UnsafeCommandBuffer (core 17).
class UnsafeCommandBuffer : public BaseCommandBuffer, public KernelCommands
{
public:
    using BaseCommandBuffer::DisableKeyword;
    using BaseCommandBuffer::EnableKeyword;
    using BaseCommandBuffer::SetKeyword;
    using KernelCommands::DisableKeyword;
    using KernelCommands::EnableKeyword;
    using KernelCommands::SetKeyword;
    void SetRenderTarget(const RTHandle& color, const RTHandle& depth = {})
    {
        native().SetRenderTarget(color, depth);
    }
    void SetRenderTarget(std::span<const RTHandle> colors, const RTHandle& depth)
    {
        native().SetRenderTarget(colors, depth);
    }
    void CopyTexture(const RTHandle& source, const RTHandle& dest)
    {
        native().CopyTexture(RenderTargetIdentifier(source), RenderTargetIdentifier(dest));
    }
    void CopyBuffer(const std::shared_ptr<const GraphicsBuffer>& source,
                    const std::shared_ptr<const GraphicsBuffer>& dest)
    {
        native().CopyBuffer(source, dest);
    }
    void GenerateMips(const RTHandle& rt) { native().GenerateMips(RenderTargetIdentifier(rt)); }

private:
    friend class RenderGraphRun;
    friend CommandBuffer& CommandBufferHelpers::GetNativeCommandBuffer(UnsafeCommandBuffer& cmd);
    UnsafeCommandBuffer(CommandBuffer& native, RenderGraphRun& run)
        : BaseCommandBuffer(native, run), KernelCommands(native)
    {
    }
};

/// What a raster pass's render function gets.
/// Unity: UnityEngine.Rendering.RenderGraphModule.RasterGraphContext (core 17).
struct RasterGraphContext
{
    RasterCommandBuffer& cmd;
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.ComputeGraphContext (core 17).
struct ComputeGraphContext
{
    ComputeCommandBuffer& cmd;
};

/// Unity: UnityEngine.Rendering.RenderGraphModule.UnsafeGraphContext (core 17).
struct UnsafeGraphContext
{
    UnsafeCommandBuffer& cmd;
};

} // namespace limn
