#include "record/ExpectDraw.h"

#include "support/RequireFinite.h"

namespace limn
{

void ExpectMaterial(const std::shared_ptr<const Material>& material)
{
    if (!material)
    {
        throw ContractError("a draw needs a material, but it is null");
    }
}

void ExpectDrawable(const std::shared_ptr<const Material>& material, int shaderPass,
                    const glm::mat4& matrix)
{
    ExpectMaterial(material);
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

} // namespace limn
