#include "record/Arguments.h"

#include "material/PropertyValues.h"

namespace limn
{

void ExpectMaterial(const char* call, const std::shared_ptr<const Material>& material)
{
    if (!material)
    {
        throw ContractError(std::string(call) + " needs a material, but it is null");
    }
}

void ExpectDrawable(const std::shared_ptr<const Material>& material, int shaderPass,
                    const glm::mat4& matrix)
{
    if (shaderPass < 0 || shaderPass >= material->passCount())
    {
        throw ContractError("material '" + material->name() + "': shader '" +
                            material->shader()->name() + "' has no pass " +
                            std::to_string(shaderPass) + "; it has " +
                            std::to_string(material->passCount()));
    }
    if (!isFinite(matrix))
    {
        throw ContractError("material '" + material->name() +
                            "': the matrix of the draw is not finite");
    }
}

void ExpectSubMesh(const Mesh& mesh, int subMesh)
{
    if (subMesh < 0 || subMesh >= mesh.subMeshCount())
    {
        throw ContractError("mesh '" + mesh.name() + "' has no sub-mesh " +
                            std::to_string(subMesh) + "; it has " +
                            std::to_string(mesh.subMeshCount()));
    }
}

BufferRange ArgumentsRange(const char* call, std::shared_ptr<const GraphicsBuffer> buffer,
                           std::int64_t offset, std::uint32_t count)
{
    const std::string subject(call);
    if (!buffer)
    {
        throw ContractError(subject + " needs a buffer with its arguments, but it is null");
    }
    if (!buffer->Has(GraphicsBuffer::Target::IndirectArguments))
    {
        throw ContractError(subject + ": buffer '" + buffer->name() +
                            "' is not made with GraphicsBuffer::Target::IndirectArguments");
    }
    const std::uint32_t size = count * static_cast<std::uint32_t>(sizeof(std::uint32_t));
    if (offset < 0 || offset % 4 != 0 || static_cast<std::uint64_t>(offset) + size > buffer->size())
    {
        throw ContractError(subject + ": the arguments are " + std::to_string(size) +
                            " bytes from byte " + std::to_string(offset) + " of buffer '" +
                            buffer->name() + "', which has " + std::to_string(buffer->size()) +
                            " bytes; they must begin at a multiple of 4 and end within the buffer");
    }
    return {std::move(buffer), static_cast<std::uint32_t>(offset), size};
}

} // namespace limn
