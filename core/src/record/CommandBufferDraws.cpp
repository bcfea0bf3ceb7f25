#include <glm/ext/matrix_clip_space.hpp>

#include "record/Arguments.h"
#include "record/MatrixIds.h"
#include "record/RecordedCommands.h"

#include <limn/core/CommandBuffer.h>
#include <limn/core/RendererList.h>
#include <limn/core/Scene.h>
#include <limn/core/TargetOrientation.h>

namespace limn
{

namespace
{

/// 0...1 in x and y, seen from the front.
const std::shared_ptr<const Mesh>& BlitQuad()
{
    static const auto quad = []
    {
        MeshData data;
        // From the corner at which Blit.hlsl's triangle begins: most devices round coordinates
        // alike. Unity's is a quad too: vertex functions tell its corners apart by their
        // coordinates.
        data.vertices = {{0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 0}};
        data.uv = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        data.triangles = {0, 1, 2, 0, 2, 3};
        return std::make_shared<const Mesh>("Blit Quad", std::move(data));
    }();
    return quad;
}

void ExpectBlit(const std::shared_ptr<const Texture>& source, const RenderTexture& dest,
                const std::shared_ptr<const Material>& material, int pass)
{
    if (source.get() == &dest)
    {
        throw ContractError(
            "Blit: '" + source->name() +
            "' is both source and destination; copy it first, and draw from the copy");
    }
    ExpectMaterial("Blit", material);
    if (pass != k_AllPasses)
    {
        ExpectDrawable(material, pass, glm::mat4(1.0f));
    }
}

/// Sets the matrices of a blit's vertex function: those of Unity's GL.LoadOrtho, whatever the
/// camera is.
/// @param properties  receives them, since a draw's own properties win over global ones
void SetBlitMatrices(MaterialPropertyBlock& properties, const RenderTexture& dest)
{
    // Near and far are given the other way round, which is reversed Z.
    static const glm::mat4 upright = glm::orthoRH_ZO(0.0f, 1.0f, 0.0f, 1.0f, 100.0f, -1.0f);
    const glm::mat4 projection = IsProjectionFlipped(dest) ? WithFlippedY(upright) : upright;
    properties.SetMatrix(unity_MatrixV, glm::mat4(1.0f));
    properties.SetMatrix(glstate_matrix_projection, projection);
    properties.SetMatrix(unity_MatrixVP, projection);
    properties.SetVector(limn_Origin, glm::vec4(0.0f)); // positions are the world's
}

/// @param call  whose they are
void ExpectCount(const char* call, const char* what, int count)
{
    if (count < 0)
    {
        throw ContractError(std::string(call) + ": the " + what + " count " +
                            std::to_string(count) + " is negative");
    }
}

RecordedDraw MeshDraw(const char* call, std::shared_ptr<const Mesh> mesh, int submeshIndex,
                      std::shared_ptr<const Material> material, int shaderPass)
{
    if (!mesh)
    {
        throw ContractError(std::string(call) + " needs a mesh, but it is null");
    }
    ExpectMaterial(call, material);
    ExpectSubMesh(*mesh, submeshIndex);
    RecordedDraw draw;
    draw.mesh = std::move(mesh);
    draw.subMesh = submeshIndex;
    draw.material = std::move(material);
    draw.shaderPass = shaderPass;
    return draw;
}

} // namespace

void CommandBuffer::DrawMesh(std::shared_ptr<const Mesh> mesh, const glm::mat4& matrix,
                             std::shared_ptr<const Material> material, int subMesh, int shaderPass,
                             const MaterialPropertyBlock& properties)
{
    ExpectMaterial("DrawMesh", material);
    ExpectDrawable(material, shaderPass, matrix);
    RecordedDraw draw =
        MeshDraw("DrawMesh", std::move(mesh), subMesh, std::move(material), shaderPass);
    draw.matrix = glm::dmat4(matrix);
    draw.properties = Keep(properties);
    m_Commands.emplace_back(std::move(draw));
}

void CommandBuffer::DrawMultipleMeshes(std::span<const glm::mat4> matrices,
                                       std::span<const std::shared_ptr<const Mesh>> meshes,
                                       std::span<const int> subsetIndices, int count,
                                       const std::shared_ptr<const Material>& material,
                                       int shaderPass, const MaterialPropertyBlock& properties)
{
    const std::size_t available = std::min({matrices.size(), meshes.size(), subsetIndices.size()});
    if (count < 0 || static_cast<std::size_t>(count) > available)
    {
        throw ContractError("DrawMultipleMeshes: the count is " + std::to_string(count) +
                            ", but one of the lists has " + std::to_string(available));
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
        DrawMesh(meshes[i], matrices[i], material, subsetIndices[i], shaderPass, properties);
    }
}

void CommandBuffer::DrawMeshInstanced(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                                      const std::shared_ptr<const Material>& material,
                                      int shaderPass, std::span<const glm::mat4> matrices,
                                      int count, const MaterialPropertyBlock& properties)
{
    if (count < 0 || static_cast<std::size_t>(count) > matrices.size())
    {
        throw ContractError("DrawMeshInstanced: the count is " + std::to_string(count) +
                            ", but there are " + std::to_string(matrices.size()) + " matrices");
    }
    DrawMeshInstanced(mesh, submeshIndex, material, shaderPass,
                      matrices.first(static_cast<std::size_t>(count)), properties);
}

void CommandBuffer::DrawMeshInstanced(const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                                      const std::shared_ptr<const Material>& material,
                                      int shaderPass, std::span<const glm::mat4> matrices,
                                      const MaterialPropertyBlock& properties)
{
    constexpr std::size_t k_Most = 1023; // Unity's
    if (matrices.size() > k_Most)
    {
        throw ContractError("DrawMeshInstanced: it was given " + std::to_string(matrices.size()) +
                            " matrices; a call takes at most " + std::to_string(k_Most));
    }
    ExpectMaterial("DrawMeshInstanced", material);
    const bool isEach = shaderPass == k_AllPasses;
    const int end = isEach ? material->passCount() : shaderPass + 1;
    for (int pass = isEach ? 0 : shaderPass; pass < end; ++pass)
    {
        for (const glm::mat4& matrix : matrices)
        {
            DrawMesh(mesh, matrix, material, submeshIndex, pass, properties);
        }
    }
}

void CommandBuffer::DrawRenderer(const GameObject& object,
                                 const std::shared_ptr<const Material>& material, int submeshIndex,
                                 int shaderPass, const MaterialPropertyBlock& properties)
{
    if (!object.renderer)
    {
        throw ContractError("DrawRenderer: the object '" + object.name + "' has no renderer");
    }
    if (!object.renderer->mesh)
    {
        return;
    }
    RecordedDraw draw =
        MeshDraw("DrawRenderer", object.renderer->mesh, submeshIndex, material, shaderPass);
    draw.matrix = object.transform.worldMatrix();
    draw.renderingLayers = object.renderer->renderingLayerMask;
    const auto& own = object.renderer->PropertiesOf(static_cast<std::size_t>(submeshIndex));
    if (!own)
    {
        DrawPasses(std::move(draw), properties);
        return;
    }
    MaterialPropertyBlock both = *own;
    both.SetAll(properties);
    DrawPasses(std::move(draw), both);
}

void CommandBuffer::Blit(const RTHandle& source, const RTHandle& dest,
                         const std::shared_ptr<const Material>& material, int pass)
{
    if (!source || !dest)
    {
        throw ContractError(std::string("Blit: the ") + (source ? "destination" : "source") +
                            " is an empty handle");
    }
    if (!source.rt() || !dest.rt())
    {
        Blit(source.nameID(), dest.nameID(), material, pass);
        return;
    }
    ExpectBlit(source.rt(), *dest.rt(), material, pass);
    SetRenderTarget(dest);
    DrawBlit(source.rt(), *dest.rt(), material, pass);
}

void CommandBuffer::DrawBlit(const std::shared_ptr<const Texture>& source,
                             const RenderTexture& dest,
                             const std::shared_ptr<const Material>& material, int pass)
{
    static const ShaderPropertyId _MainTex{"_MainTex"};
    ExpectBlit(source, dest, material, pass);
    RecordedDraw draw;
    draw.mesh = BlitQuad();
    draw.material = material;
    draw.shaderPass = pass;
    draw.isBlit = true;
    static thread_local MaterialPropertyBlock properties; // for its memory, as in Unity
    if (source)
    {
        properties.SetTexture(_MainTex, source);
    }
    SetBlitMatrices(properties, dest);
    DrawPasses(std::move(draw), properties);
    properties.Clear();
}

/// Draws with the pass of the material that the draw names, or with each of them.
void CommandBuffer::DrawPasses(RecordedDraw draw, const MaterialPropertyBlock& properties)
{
    const bool isEach = draw.shaderPass == k_AllPasses;
    const int first = isEach ? 0 : draw.shaderPass;
    const int end = isEach ? draw.material->passCount() : first + 1;
    for (draw.shaderPass = first; draw.shaderPass < end; ++draw.shaderPass)
    {
        ExpectDrawable(draw.material, draw.shaderPass, glm::mat4(draw.matrix));
        draw.properties = Keep(properties);
        m_Commands.emplace_back(draw);
    }
}

void CommandBuffer::DrawRendererList(const RendererList& rendererList)
{
    if (!rendererList.isValid())
    {
        throw ContractError("DrawRendererList: the list is empty; CreateRendererList makes one");
    }
    m_Commands.push_back(DrawRendererListCommand{rendererList.params()});
}

void CommandBuffer::Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest,
                         std::shared_ptr<const Material> material, int pass)
{
    ExpectMaterial("Blit", material);
    if (pass != k_AllPasses)
    {
        ExpectDrawable(material, pass, glm::mat4(1.0f));
    }
    m_Commands.emplace_back(
        IdentifiedBlitCommand{std::move(source), std::move(dest), std::move(material), pass});
}

void CommandBuffer::Blit(RenderTargetIdentifier source, RenderTargetIdentifier dest)
{
    m_Commands.emplace_back(IdentifiedBlitCommand{std::move(source), std::move(dest), nullptr, 0});
}

void CommandBuffer::DrawProcedural(const glm::mat4& matrix,
                                   std::shared_ptr<const Material> material, int shaderPass,
                                   int vertexCount, const MaterialPropertyBlock& properties)
{
    DrawProcedural(matrix, std::move(material), shaderPass, MeshTopology::Triangles, vertexCount, 1,
                   properties);
}

void CommandBuffer::DrawProcedural(const glm::mat4& matrix,
                                   std::shared_ptr<const Material> material, int shaderPass,
                                   MeshTopology topology, int vertexCount, int instanceCount,
                                   const MaterialPropertyBlock& properties)
{
    constexpr const char* k_Call = "DrawProcedural";
    ExpectMaterial(k_Call, material);
    ExpectDrawable(material, shaderPass, matrix);
    ExpectCount(k_Call, "vertex", vertexCount);
    ExpectCount(k_Call, "instance", instanceCount);
    if (instanceCount == 0 || (topology == MeshTopology::Quads && vertexCount < 4))
    {
        return;
    }
    RecordedDraw draw;
    draw.vertexCount = static_cast<std::uint32_t>(vertexCount);
    draw.matrix = glm::dmat4(matrix);
    draw.material = std::move(material);
    draw.shaderPass = shaderPass;
    draw.properties = Keep(properties);
    draw.instanceCount = static_cast<std::uint32_t>(instanceCount);
    draw.topology = topology;
    m_Commands.emplace_back(std::move(draw));
}

void CommandBuffer::DrawProceduralIndirect(
    const glm::mat4& matrix, const std::shared_ptr<const Material>& material, int shaderPass,
    MeshTopology topology, const std::shared_ptr<const GraphicsBuffer>& bufferWithArgs,
    int argsOffset, const MaterialPropertyBlock& properties)
{
    constexpr const char* k_Call = "DrawProceduralIndirect";
    ExpectMaterial(k_Call, material);
    ExpectDrawable(material, shaderPass, matrix);
    if (topology == MeshTopology::Quads)
    {
        throw ContractError(std::string(k_Call) +
                            ": limn draws Quads by indices, but the buffer's counts are those of a "
                            "draw without indices; draw Triangles, six vertices per quad");
    }
    RecordedDraw draw;
    draw.matrix = glm::dmat4(matrix);
    draw.material = material;
    draw.shaderPass = shaderPass;
    draw.properties = Keep(properties);
    draw.topology = topology;
    draw.isProcedural = true;
    draw.arguments = ArgumentsRange(k_Call, bufferWithArgs, argsOffset, 4);
    m_Commands.emplace_back(std::move(draw));
}

void CommandBuffer::DrawMeshInstancedProcedural(const std::shared_ptr<const Mesh>& mesh,
                                                int submeshIndex,
                                                const std::shared_ptr<const Material>& material,
                                                int shaderPass, int count,
                                                const MaterialPropertyBlock& properties)
{
    constexpr const char* k_Call = "DrawMeshInstancedProcedural";
    ExpectCount(k_Call, "instance", count);
    RecordedDraw draw = MeshDraw(k_Call, mesh, submeshIndex, material, shaderPass);
    draw.isProcedural = true;
    draw.instanceCount = static_cast<std::uint32_t>(count);
    if (count > 0)
    {
        DrawPasses(std::move(draw), properties);
    }
}

void CommandBuffer::DrawMeshInstancedIndirect(
    const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
    const std::shared_ptr<const Material>& material, int shaderPass,
    const std::shared_ptr<const GraphicsBuffer>& bufferWithArgs, int argsOffset,
    const MaterialPropertyBlock& properties)
{
    constexpr const char* k_Call = "DrawMeshInstancedIndirect";
    RecordedDraw draw = MeshDraw(k_Call, mesh, submeshIndex, material, shaderPass);
    draw.isProcedural = true;
    draw.arguments = ArgumentsRange(k_Call, bufferWithArgs, argsOffset, 5);
    DrawPasses(std::move(draw), properties);
}

} // namespace limn
