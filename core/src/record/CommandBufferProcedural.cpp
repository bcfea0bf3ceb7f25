#include <limn/core/CommandBuffer.h>

#include "record/Arguments.h"

namespace limn
{

namespace
{

/// @param call  whose they are
void ExpectCount(const char* call, const char* what, int count)
{
    if (count < 0)
    {
        throw ContractError(std::string(call) + ": the " + what + " count " +
                            std::to_string(count) + " is negative");
    }
}

RecordedDraw MeshDraw(const char* call, const std::shared_ptr<const Mesh>& mesh, int submeshIndex,
                      const std::shared_ptr<const Material>& material, int shaderPass)
{
    if (!mesh)
    {
        throw ContractError(std::string(call) + " needs a mesh, but it is null");
    }
    ExpectMaterial(call, material);
    ExpectSubMesh(*mesh, submeshIndex);
    RecordedDraw draw;
    draw.mesh = mesh;
    draw.subMesh = submeshIndex;
    draw.material = material;
    draw.shaderPass = shaderPass;
    draw.isProcedural = true;
    return draw;
}

} // namespace

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
    draw.arguments = ArgumentsRange(k_Call, bufferWithArgs, argsOffset, 5);
    DrawPasses(std::move(draw), properties);
}

} // namespace limn
