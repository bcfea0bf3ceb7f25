#pragma once

#include <limn/core/ComputeShader.h>
#include <limn/core/FrameCommands.h>
#include <limn/core/Material.h>
#include <limn/core/RenderTargetIdentifier.h>
#include <limn/core/ShaderKeyword.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

struct CopyDrawCommand;
struct GameObject;
struct RecordedCommand;
struct RecordedDraw;
class RendererList;

/// A list of commands that ScriptableRenderContext::ExecuteCommandBuffer runs; recording alone does
/// nothing. Unity: UnityEngine.Rendering.CommandBuffer (2022.3).
class CommandBuffer
{
public:
    CommandBuffer();
    ~CommandBuffer();
    CommandBuffer(const CommandBuffer& other);
    CommandBuffer(CommandBuffer&& other) noexcept;
    CommandBuffer& operator=(const CommandBuffer& other);
    CommandBuffer& operator=(CommandBuffer&& other) noexcept;

    /// If not empty, the buffer's commands form a sample of this name, provided that the samples
    /// that the buffer begins also end in it.
    std::string name;

    /// @param color  a depth texture here, with `depth` empty, is the depth
    /// @param depth  empty: the depth that the colour has (RenderTexture::depthBuffer), if any; of
    ///               several colours, none. A colour here stands for the depth that it has.
    /// @throws ContractError if both are empty, there are more than 8 colours, a format is of the
    ///         wrong kind, or sizes or sample counts differ
    void SetRenderTarget(const RTHandle& color, const RTHandle& depth = {});
    void SetRenderTarget(std::span<const RTHandle> colors, const RTHandle& depth);
    /// Binds the colour together with the depth that belongs to it: for CameraTarget the camera's
    /// depth, for CurrentActive the depth that is bound. Executing throws ContractError if a name
    /// stands for no texture, and in the cases in which the other overloads throw.
    void SetRenderTarget(RenderTargetIdentifier color)
    {
        SetRenderTarget(std::move(color), BuiltinRenderTextureType::None);
    }
    void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth);
    void SetRenderTarget(std::span<const RenderTargetIdentifier> colors,
                         RenderTargetIdentifier depth);
    /// @throws ContractError for RenderBufferLoadAction::Clear: ClearRenderTarget takes the values
    ///     to clear to
    void SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction loadAction,
                         RenderBufferStoreAction storeAction);
    void SetRenderTarget(RenderTargetIdentifier color, RenderBufferLoadAction colorLoadAction,
                         RenderBufferStoreAction colorStoreAction, RenderTargetIdentifier depth,
                         RenderBufferLoadAction depthLoadAction,
                         RenderBufferStoreAction depthStoreAction);
    void SetRenderTarget(const RTHandle& rt, RenderBufferLoadAction loadAction,
                         RenderBufferStoreAction storeAction);
    void SetRenderTarget(const RTHandle& color, RenderBufferLoadAction colorLoadAction,
                         RenderBufferStoreAction colorStoreAction, const RTHandle& depth,
                         RenderBufferLoadAction depthLoadAction,
                         RenderBufferStoreAction depthStoreAction);
    /// Sets the texture that CameraTarget stands for in all commands that follow. A renderer that
    /// changes it must call this.
    void SetCameraColor(RTHandle color);

    /// Makes a texture that lives until ReleaseTemporaryRT or the camera's end, and is global under
    /// its name at once. Its contents are undefined: clear it, or draw over the whole of it. A
    /// texture of the same name that is not released yet is released. A colour format with
    /// depthBufferBits gives a colour texture that has a depth. It wraps by clamping.
    /// Width and height are in texels; a negative one is a part of the camera's: -1 all, -2 half.
    /// @throws ContractError  when executed: as RenderTexture does, or where no pipeline renders
    /// @source Unity: CommandBuffer.GetTemporaryRT (2022.3)
    void GetTemporaryRT(ShaderPropertyId nameID, const RenderTextureDescriptor& desc,
                        FilterMode filter = FilterMode::Point);
    void GetTemporaryRT(ShaderPropertyId nameID, int width, int height, int depthBuffer = 0,
                        FilterMode filter = FilterMode::Point,
                        RenderTextureFormat format = RenderTextureFormat::ARGB32,
                        RenderTextureReadWrite readWrite = RenderTextureReadWrite::Default,
                        int antiAliasing = 1);
    /// Releases a temporary texture; nothing is global under its name then. If the name stands for
    /// no temporary texture, a sentence in the report says so (Unity says nothing).
    /// @source Unity: CommandBuffer.ReleaseTemporaryRT (2022.3)
    void ReleaseTemporaryRT(ShaderPropertyId nameID);

    /// @param color  linear
    /// @param depth  1 = far on every device
    /// @throws ContractError if depth is outside 0...1 or the colour is not finite
    void ClearRenderTarget(ClearFlag flags, const Color& color, float depth = 1.0f,
                           int stencil = 0);
    /// Clears the bound target; the stencil is cleared with the depth. @throws ContractError as the
    /// other overload does
    /// @source Unity: CommandBuffer.ClearRenderTarget(bool, bool, Color, float) (2022.3)
    void ClearRenderTarget(bool clearDepth, bool clearColor, const Color& backgroundColor,
                           float depth = 1.0f)
    {
        ClearRenderTarget((clearDepth ? ClearFlag::DepthStencil : ClearFlag::None) |
                              (clearColor ? ClearFlag::Color : ClearFlag::None),
                          backgroundColor, depth);
    }
    /// Sets the viewport until the next SetRenderTarget, which sets it to the whole target.
    /// @throws ContractError if the size is not positive, or the end fits no int
    void SetViewport(const ViewportRect& rect);

    // These states hold for all draws of the camera that follow, also for those of other buffers
    // and into other targets, until they are set again. A camera begins with none of them set.

    /// Limits draws to these texels. Clears and CopyTexture are not limited.
    /// @throws ContractError if the size is negative, or the end fits no int
    /// @source Unity: CommandBuffer.EnableScissorRect (2022.3); what a clear does there depends on
    ///         the device
    void EnableScissorRect(const ViewportRect& scissor);
    void DisableScissorRect();
    /// Swaps front and back faces, as in a mirror.
    /// @source Unity: CommandBuffer.SetInvertCulling (2022.3)
    void SetInvertCulling(bool invertCulling);
    /// Sets a depth bias that is added to the Offset of the passes; positive = farther.
    /// @param bias       in the smallest steps of the depth texture
    /// @param slopeBias  in a triangle's greatest change of depth from texel to texel
    /// @throws ContractError if one is not finite
    /// @source Unity: CommandBuffer.SetGlobalDepthBias (2022.3)
    void SetGlobalDepthBias(float bias, float slopeBias);

    /// @throws ContractError if mesh or material is null, there is no such sub-mesh or pass, or the
    ///         matrix is not finite
    void DrawMesh(std::shared_ptr<const Mesh> mesh, const glm::mat4& matrix,
                  std::shared_ptr<const Material> material, int subMesh = 0, int shaderPass = 0,
                  const MaterialPropertyBlock& properties = {});
    /// Calls DrawMesh for each mesh with the matrix and sub-mesh at the same index.
    /// @throws ContractError as DrawMesh does, and if a list has not `count` elements
    /// @source Unity: CommandBuffer.DrawMultipleMeshes (Unity 6)
    void DrawMultipleMeshes(std::span<const glm::mat4> matrices,
                            std::span<const std::shared_ptr<const Mesh>> meshes,
                            std::span<const int> subsetIndices, int count,
                            const std::shared_ptr<const Material>& material, int shaderPass = -1,
                            const MaterialPropertyBlock& properties = {});
    /// Draws the mesh once for each matrix. The draws become instances of one draw wherever they
    /// can; the material needs no enableInstancing.
    /// @param shaderPass  -1 = all passes of the shader, one after the other
    /// @throws ContractError as DrawMesh does, and for more than 1023 matrices
    /// @source Unity: CommandBuffer.DrawMeshInstanced (2022.3)
    void DrawMeshInstanced(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                           const std::shared_ptr<const Material>& material, int shaderPass,
                           std::span<const glm::mat4> matrices,
                           const MaterialPropertyBlock& properties = {});
    /// Draws the mesh once for each of the first `count` matrices.
    /// @throws ContractError as the other overload does, and if there are fewer matrices
    void DrawMeshInstanced(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                           const std::shared_ptr<const Material>& material, int shaderPass,
                           std::span<const glm::mat4> matrices, int count,
                           const MaterialPropertyBlock& properties = {});
    /// Draws a sub-mesh of the object's renderer where the object is now, whatever culling,
    /// `enabled` and `activeSelf` say. Draws nothing if the renderer has no mesh.
    /// @param shaderPass  -1 = all passes of the shader, one after the other
    /// @throws ContractError as DrawMesh does, and if the object has no renderer
    /// @source Unity: CommandBuffer.DrawRenderer (2022.3)
    void DrawRenderer(const GameObject& object, const std::shared_ptr<const Material>& material,
                      int submeshIndex = 0, int shaderPass = -1,
                      const MaterialPropertyBlock& properties = {});
    /// Draws at this place what ScriptableRenderContext::DrawRenderers would draw.
    /// @throws ContractError for an empty list; when executed, as DrawRenderers does
    /// @source Unity: CommandBuffer.DrawRendererList (2022.3)
    void DrawRendererList(const RendererList& rendererList);
    /// Draws triangles without vertex buffers: the shader sees SV_VertexID only. Triangles that are
    /// counter-clockwise in clip space are front faces, as for the full-screen triangles of Unity's
    /// Blit.hlsl.
    void DrawProcedural(const glm::mat4& matrix, std::shared_ptr<const Material> material,
                        int shaderPass, int vertexCount,
                        const MaterialPropertyBlock& properties = {});
    /// @param instanceCount  the number of instances, whose SV_InstanceID is 0, 1 ...; 0 = nothing
    ///     is drawn
    /// @throws ContractError also for a negative count
    /// @source Unity: CommandBuffer.DrawProcedural (2022.3)
    void DrawProcedural(const glm::mat4& matrix, std::shared_ptr<const Material> material,
                        int shaderPass, MeshTopology topology, int vertexCount,
                        int instanceCount = 1, const MaterialPropertyBlock& properties = {});

    /// Draws the mesh `count` times in one draw, each time with the identity as its matrix: the
    /// shader tells the instances apart by SV_InstanceID or the function of `#pragma
    /// instancing_options procedural:F`.
    /// @param shaderPass  -1 = all passes of the shader, one after the other
    /// @throws ContractError as DrawMesh does, and for a negative count
    /// @source Unity: CommandBuffer.DrawMeshInstancedProcedural (2022.3)
    void DrawMeshInstancedProcedural(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                                     const std::shared_ptr<const Material>& material,
                                     int shaderPass, int count,
                                     const MaterialPropertyBlock& properties = {});
    /// Draws as DrawMeshInstancedProcedural does, with the counts that the buffer holds when it is
    /// drawn, as five uint: indices per instance, instances, first index, the number that is added
    /// to the indices, and 0. The device does not check them (Mesh::GetIndexCount, GetIndexStart
    /// and GetBaseVertex return those of a sub-mesh).
    /// @param bufferWithArgs  made with GraphicsBuffer::Target::IndirectArguments
    /// @param argsOffset      the place of the first count, in bytes: a multiple of 4
    /// @throws ContractError as DrawMesh does, and if the buffer is null, has other targets, or
    ///     ends before the counts do
    /// @source Unity: CommandBuffer.DrawMeshInstancedIndirect (2022.3)
    void DrawMeshInstancedIndirect(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                                   const std::shared_ptr<const Material>& material, int shaderPass,
                                   const std::shared_ptr<const GraphicsBuffer>& bufferWithArgs,
                                   int argsOffset = 0,
                                   const MaterialPropertyBlock& properties = {});
    /// Draws as DrawProcedural does, with the counts that the buffer holds when it is drawn, as
    /// four uint: vertices per instance, instances, first vertex, and 0. SV_VertexID counts from
    /// the first vertex.
    /// @throws ContractError as DrawProcedural does, for Quads, and for the buffer as
    ///         DrawMeshInstancedIndirect
    /// @source Unity: CommandBuffer.DrawProceduralIndirect (2022.3)
    void DrawProceduralIndirect(const glm::mat4& matrix,
                                const std::shared_ptr<const Material>& material, int shaderPass,
                                MeshTopology topology,
                                const std::shared_ptr<const GraphicsBuffer>& bufferWithArgs,
                                int argsOffset = 0, const MaterialPropertyBlock& properties = {});

    /// Draws a quad over the whole of `dest`, which stays the target, with `source` as _MainTex
    /// (and its size as _MainTex_TexelSize). The vertices are at 0...1 in x and y, from bottom left
    /// to top right. For these draws only, object space is world space, and an orthographic camera
    /// sees exactly that square. TEXCOORD0 is the same place in `source`. The depth and stencil
    /// that belong to `dest` are bound with it, as by SetRenderTarget; if it has none, tests
    /// against them pass, and the report says so.
    /// @param pass  -1 = all passes of the shader, one after the other
    /// @throws ContractError if a handle is empty or both are the same texture, the material is
    ///         null, or there is no such pass
    /// @source Unity: CommandBuffer.Blit, Graphics.Blit (2022.3)
    void Blit(const RTHandle& source, const RTHandle& dest,
              const std::shared_ptr<const Material>& material, int pass = -1);
    /// Blits what the identifiers stand for when the buffer is executed; invalid ones throw only
    /// then. A source that stands for no texture leaves _MainTex to the material. CurrentActive as
    /// `dest` keeps all that is bound.
    void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest,
              std::shared_ptr<const Material> material, int pass = -1);
    /// Draws the whole of `source` over the whole of `dest`, sampled with its own filter.
    void Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest);
    /// Records a copy for Blitter::BlitTexture without a material, BlitQuad and BlitColorAndDepth.
    void DrawCopy(CopyDrawCommand copy);
    /// Copies texel for texel; the bound target stays bound. The copy is a draw: `dest` must be a
    /// colour texture, and values that no sampler can tell apart may be written differently.
    /// @throws ContractError  when executed: unless both have the same size and colour format and
    ///     one sample per texel
    /// @source Unity: CommandBuffer.CopyTexture (2022.3), which copies bits and depth, too
    void CopyTexture(RenderTargetIdentifier source, RenderTargetIdentifier dest);

    /// Makes the mip levels of a render texture behind the first from what was drawn into it last.
    /// It does nothing for a texture with autoGenerateMips. If the frame has drawn nothing into the
    /// texture, a sentence in the report says so.
    /// @throws ContractError  when executed: unless it is a render texture with mip levels
    /// @source Unity: CommandBuffer.GenerateMips (2022.3)
    void GenerateMips(RenderTargetIdentifier rt);
    void GenerateMips(std::shared_ptr<const RenderTexture> rt)
    {
        GenerateMips(RenderTargetIdentifier(std::shared_ptr<const Texture>(std::move(rt))));
    }

    // Setting a global throws ContractError naming it if the value is not finite or is an array
    // without elements.
    void SetGlobalFloat(ShaderPropertyId id, float value) { SetGlobal(id, value); }
    void SetGlobalFloat(ShaderPropertyId id, detail::WholeNumber auto value)
    {
        SetGlobalFloat(id, static_cast<float>(value));
    }
    void SetGlobalInt(ShaderPropertyId id, int value) { SetGlobal(id, value); }
    void SetGlobalInteger(ShaderPropertyId id, int value) { SetGlobal(id, value); }
    void SetGlobalVector(ShaderPropertyId id, const glm::vec4& value) { SetGlobal(id, value); }
    void SetGlobalVector(ShaderPropertyId id, const detail::MadeVector4 auto& value)
    {
        SetGlobalVector(id, detail::ToVector4(value));
    }
    /// Does the same as SetGlobalVector, as in Unity: pass `linear()` of a colour that a person
    /// picked. Only colours of materials and property blocks are converted.
    void SetGlobalColor(ShaderPropertyId id, const Color& value) { SetGlobal(id, value.vector()); }
    void SetGlobalMatrix(ShaderPropertyId id, const glm::mat4& value) { SetGlobal(id, value); }
    // Arrays behave as those of MaterialPropertyBlock.
    void SetGlobalFloatArray(ShaderPropertyId id, PropertyArray<float> values)
    {
        SetGlobal(id, std::move(values));
    }
    void SetGlobalVectorArray(ShaderPropertyId id, PropertyArray<glm::vec4> values)
    {
        SetGlobal(id, std::move(values));
    }
    void SetGlobalMatrixArray(ShaderPropertyId id, PropertyArray<glm::mat4> values)
    {
        SetGlobal(id, std::move(values));
    }
    void SetGlobalTexture(ShaderPropertyId id, std::shared_ptr<const Texture> value)
    {
        SetGlobal(id, std::move(value));
    }
    /// Sets the texture that the identifier stands for when the buffer is executed. None = the
    /// shader's default.
    void SetGlobalTexture(ShaderPropertyId id, RenderTargetIdentifier value);
    void SetGlobalTexture(ShaderPropertyId id, const RTHandle& value)
    {
        if (value && !value.rt())
        {
            SetGlobalTexture(id, value.nameID());
            return;
        }
        SetGlobalTexture(id, std::shared_ptr<const Texture>(value.rt()));
    }

    // Buffers behave as those of MaterialPropertyBlock; null = none.
    void SetGlobalBuffer(ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> value)
    {
        SetGlobal(id, BufferRange{std::move(value), 0, 0});
    }
    void SetGlobalConstantBuffer(std::shared_ptr<const GraphicsBuffer> buffer, ShaderPropertyId id,
                                 int offset, int size)
    {
        SetGlobal(id, ConstantRange(std::move(buffer), offset, size));
    }

    /// Runs a kernel in this many groups; [numthreads] gives the threads of each. It waits for what
    /// it reads, and later commands wait for what it writes. If nothing reads what it writes, it is
    /// not run (see CompileFrame).
    /// @throws ContractError if the shader is null, there is no such kernel, or a count is not from
    ///         1 to 65535; when executed, for a texture or buffer that is not set or does not fit
    /// @throws AssetError  when executed: the kernel does not compile
    /// @source Unity: CommandBuffer.DispatchCompute (2022.3)
    void DispatchCompute(std::shared_ptr<const ComputeShader> computeShader, int kernelIndex,
                         int threadGroupsX, int threadGroupsY, int threadGroupsZ);
    /// Runs a kernel with the numbers of groups in x, y and z that the buffer holds when it is run,
    /// as three uint. The device does not check them.
    /// @param indirectBuffer  made with GraphicsBuffer::Target::IndirectArguments
    /// @param argsOffset      the place of the first number, in bytes: a multiple of 4
    /// @throws ContractError also if the buffer is null, has other targets, or ends before the
    ///     numbers do
    void DispatchCompute(std::shared_ptr<const ComputeShader> computeShader, int kernelIndex,
                         std::shared_ptr<const GraphicsBuffer> indirectBuffer,
                         std::uint32_t argsOffset);

    /// Calls GraphicsBuffer::SetData when the buffer is executed.
    /// @throws ContractError if the buffer is null; when executed, as SetData does, and if an
    ///     earlier command of the frame uses the buffer: all of those run after it
    /// @source Unity: CommandBuffer.SetBufferData (2022.3)
    template <std::ranges::contiguous_range Data>
    void SetBufferData(const std::shared_ptr<GraphicsBuffer>& buffer, const Data& data)
    {
        SetBufferBytes(buffer, GraphicsBuffer::PartOf(data));
    }
    /// @param managedBufferStartIndex, count  the elements of `data` to copy
    /// @param graphicsBufferStartIndex        their place in the buffer, in elements of `data`
    template <std::ranges::contiguous_range Data>
    void SetBufferData(const std::shared_ptr<GraphicsBuffer>& buffer, const Data& data,
                       int managedBufferStartIndex, int graphicsBufferStartIndex, int count)
    {
        SetBufferBytes(buffer, GraphicsBuffer::PartOf(data, managedBufferStartIndex,
                                                      graphicsBufferStartIndex, count));
    }
    /// Calls GraphicsBuffer::SetCounterValue when the buffer is executed, as SetBufferData does.
    void SetBufferCounterValue(const std::shared_ptr<GraphicsBuffer>& buffer,
                               std::uint32_t counterValue);

    /// Copies all elements on the device; a counter keeps its value.
    /// @throws ContractError if a buffer is null, both are the same or differ in their size in
    ///     bytes, the source is made without GraphicsBuffer::Target::CopySource, or `dest` without
    ///     CopyDestination; when executed, if the device runs no kernels or no camera is rendered
    /// @source Unity: CommandBuffer.CopyBuffer, Graphics.CopyBuffer (2022.3)
    void CopyBuffer(const std::shared_ptr<const GraphicsBuffer>& source,
                    const std::shared_ptr<const GraphicsBuffer>& dest);
    /// Copies the counter of `src` as a uint to a place in `dst`.
    /// @param dstOffsetBytes  a multiple of 4
    /// @throws ContractError if a buffer is null, `src` has no counter or the place is not in
    ///     `dst`; when executed, as CopyBuffer does
    /// @source Unity: CommandBuffer.CopyCounterValue (2022.3)
    void CopyCounterValue(const std::shared_ptr<const GraphicsBuffer>& src,
                          const std::shared_ptr<const GraphicsBuffer>& dst,
                          std::uint32_t dstOffsetBytes);

    // These call ComputeShader::SetFloat and its like when the buffer is executed: the values hold
    // for dispatches that follow, and from then on. @throws ContractError if the shader is null,
    // and as those functions do
    void SetComputeFloatParam(const std::shared_ptr<ComputeShader>& computeShader,
                              ShaderPropertyId id, float value)
    {
        SetParam(computeShader, id, value);
    }
    void SetComputeIntParam(const std::shared_ptr<ComputeShader>& computeShader,
                            ShaderPropertyId id, int value)
    {
        SetParam(computeShader, id, value);
    }
    void SetComputeVectorParam(const std::shared_ptr<ComputeShader>& computeShader,
                               ShaderPropertyId id, const glm::vec4& value)
    {
        SetParam(computeShader, id, value);
    }
    void SetComputeVectorParam(const std::shared_ptr<ComputeShader>& computeShader,
                               ShaderPropertyId id, const detail::MadeVector4 auto& value)
    {
        SetComputeVectorParam(computeShader, id, detail::ToVector4(value));
    }
    void SetComputeVectorArrayParam(const std::shared_ptr<ComputeShader>& computeShader,
                                    ShaderPropertyId id, std::vector<glm::vec4> values)
    {
        SetParam(computeShader, id, std::move(values));
    }
    void SetComputeMatrixParam(const std::shared_ptr<ComputeShader>& computeShader,
                               ShaderPropertyId id, const glm::mat4& value)
    {
        SetParam(computeShader, id, value);
    }
    void SetComputeMatrixArrayParam(const std::shared_ptr<ComputeShader>& computeShader,
                                    ShaderPropertyId id, std::vector<glm::mat4> values)
    {
        SetParam(computeShader, id, std::move(values));
    }
    void SetComputeFloatParams(const std::shared_ptr<ComputeShader>& computeShader,
                               ShaderPropertyId id, std::vector<float> values)
    {
        SetParam(computeShader, id, ConsecutiveParams{std::move(values)});
    }
    void SetComputeIntParams(const std::shared_ptr<ComputeShader>& computeShader,
                             ShaderPropertyId id, std::vector<int> values)
    {
        SetParam(computeShader, id, ConsecutiveParams{std::move(values)});
    }
    template <detail::FloatArgument First, detail::FloatArgument... More>
    void SetComputeFloatParams(const std::shared_ptr<ComputeShader>& computeShader,
                               ShaderPropertyId id, First first, More... more)
    {
        SetComputeFloatParams(
            computeShader, id,
            std::vector<float>{static_cast<float>(first), static_cast<float>(more)...});
    }
    template <std::same_as<int> First, std::same_as<int>... More>
    void SetComputeIntParams(const std::shared_ptr<ComputeShader>& computeShader,
                             ShaderPropertyId id, First first, More... more)
    {
        SetComputeIntParams(computeShader, id, std::vector<int>{first, more...});
    }
    /// @param rt  resolved when the buffer is executed
    void SetComputeTextureParam(const std::shared_ptr<ComputeShader>& computeShader,
                                int kernelIndex, ShaderPropertyId id, RenderTargetIdentifier rt);
    void SetComputeBufferParam(const std::shared_ptr<ComputeShader>& computeShader, int kernelIndex,
                               ShaderPropertyId id, std::shared_ptr<const GraphicsBuffer> buffer)
    {
        SetParam(computeShader, id, BufferRange{std::move(buffer), 0, 0}, kernelIndex);
    }
    void SetComputeConstantBufferParam(const std::shared_ptr<ComputeShader>& computeShader,
                                       ShaderPropertyId id,
                                       std::shared_ptr<const GraphicsBuffer> buffer, int offset,
                                       int size)
    {
        SetParam(computeShader, id, ConstantRange(std::move(buffer), offset, size));
    }
    /// Calls ComputeShader::SetFromMaterial with the values that the material has when the buffer
    /// is executed.
    /// @throws ContractError also if the material is null
    /// @source Unity: CommandBuffer.SetComputeParamsFromMaterial (2022.3)
    void SetComputeParamsFromMaterial(const std::shared_ptr<ComputeShader>& computeShader,
                                      int kernelIndex, std::shared_ptr<const Material> material);
    void SetKeyword(const std::shared_ptr<ComputeShader>& computeShader, std::string_view keyword,
                    bool value);
    void EnableKeyword(const std::shared_ptr<ComputeShader>& computeShader,
                       std::string_view keyword)
    {
        SetKeyword(computeShader, keyword, true);
    }
    void DisableKeyword(const std::shared_ptr<ComputeShader>& computeShader,
                        std::string_view keyword)
    {
        SetKeyword(computeShader, keyword, false);
    }

    /// Sets the matrices as RenderingUtils::SetViewAndProjectionMatrices documents.
    void SetViewProjectionMatrices(const glm::dmat4& view, const glm::mat4& gpuProjection,
                                   bool setInverseMatrices);
    /// Sets UNITY_MATRIX_V, UNITY_MATRIX_P and UNITY_MATRIX_VP for draws that follow; their
    /// inverses stay as they are.
    /// @param view  world to view space, as Camera::worldToCameraMatrix
    /// @param proj  view to clip space as Camera::projectionMatrix has it, which is OpenGL's
    /// @throws ContractError if one is not finite
    /// @source Unity: CommandBuffer.SetViewProjectionMatrices(Matrix4x4, Matrix4x4) (2022.3)
    void SetViewProjectionMatrices(const glm::dmat4& view, const glm::dmat4& proj)
    {
        SetViewMatrix(view);
        SetProjectionMatrix(proj);
    }
    void SetViewMatrix(const glm::dmat4& view);
    void SetProjectionMatrix(const glm::dmat4& proj);

    /// Switches a keyword for draws that follow, until the end of the camera. A keyword that is on
    /// there chooses variants as if every material had it on.
    void SetKeyword(const GlobalKeyword& keyword, bool value);
    void EnableKeyword(const GlobalKeyword& keyword) { SetKeyword(keyword, true); }
    void DisableKeyword(const GlobalKeyword& keyword) { SetKeyword(keyword, false); }
    /// Switches a keyword of one material, for draws that follow and from then on.
    /// @throws ContractError if the material is null
    /// @source Unity: CommandBuffer.SetKeyword(Material, in LocalKeyword, bool) (2022.3)
    void SetKeyword(const std::shared_ptr<Material>& material, const LocalKeyword& keyword,
                    bool value);
    void EnableKeyword(const std::shared_ptr<Material>& material, const LocalKeyword& keyword)
    {
        SetKeyword(material, keyword, true);
    }
    void DisableKeyword(const std::shared_ptr<Material>& material, const LocalKeyword& keyword)
    {
        SetKeyword(material, keyword, false);
    }
    void EnableShaderKeyword(std::string_view keyword) { SetKeyword(GlobalKeyword(keyword), true); }
    void DisableShaderKeyword(std::string_view keyword)
    {
        SetKeyword(GlobalKeyword(keyword), false);
    }

    void BeginSample(std::string_view sample) { BeginSample(SampleName(sample)); }
    void BeginSample(SampleName sample);
    void EndSample();
    /// @throws ContractError if the innermost sample that this buffer has open has another name
    void EndSample(std::string_view sample);

    /// Forgets all recorded commands and keeps the memory.
    void Clear();

    const std::vector<RecordedCommand>& commands() const { return m_Commands; }
    /// Returns the property values of a draw of this buffer, or null if it has none. The pointer is
    /// valid until the next change.
    const MaterialPropertyBlock* PropertiesOf(const RecordedDraw& draw) const;

private:
    friend class RenderTargetResolver;

    /// Draws onto the bound target.
    /// @param source  null = none
    /// @param dest    the first colour that is bound
    void DrawBlit(const std::shared_ptr<const Texture>& source, const RenderTexture& dest,
                  const std::shared_ptr<const Material>& material, int pass);
    void Record(RecordedCommand command);
    void SetBufferBytes(const std::shared_ptr<GraphicsBuffer>& buffer,
                        const GraphicsBuffer::Part& part);
    void SetGlobal(ShaderPropertyId id, ShaderPropertyValue value);
    void SetParam(const std::shared_ptr<ComputeShader>& shader, ShaderPropertyId id,
                  ShaderPropertyValue value, int kernel = ComputeShader::k_AllKernels);
    std::uint32_t Keep(const MaterialPropertyBlock& properties);
    void DrawPasses(RecordedDraw draw, const MaterialPropertyBlock& properties);

    std::vector<RecordedCommand> m_Commands;
    std::vector<MaterialPropertyBlock> m_Blocks; ///< those behind the first ones are spare
    std::uint32_t m_BlockCount = 0;
};

/// Gives out empty command buffers. Unity: UnityEngine.Rendering.CommandBufferPool.
namespace CommandBufferPool
{

/// Returns the buffer to the pool when its owner is destroyed.
struct Recycle
{
    void operator()(CommandBuffer* buffer) const noexcept;
};
using Pooled = std::unique_ptr<CommandBuffer, Recycle>;

Pooled Get();
Pooled Get(std::string_view name);
/// Gives `buffer` back before its scope ends; it is null afterwards.
inline void Release(Pooled& buffer)
{
    buffer.reset();
}

} // namespace CommandBufferPool

} // namespace limn
