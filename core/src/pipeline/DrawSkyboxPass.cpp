#include "pipeline/DrawSkyboxPass.h"

#include "environment/CubeLight.h"

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <limn/core/CoreUtils.h>

namespace limn
{

namespace
{

constexpr int k_Cells = 8; ///< along an edge of the ball's cube: shaders may work by vertex

/// The faces of the cube around the camera in the order of a sky's passes: front, back, right ...
constexpr std::size_t k_SkySides[k_CubeFaces] = {4, 5, 0, 1, 2, 3};

/// Appends cells x cells squares.
void AddSide(MeshData& data, const CubeFace& side, int cells)
{
    const auto first = static_cast<std::uint32_t>(data.vertices.size());
    const auto row = static_cast<std::uint32_t>(cells + 1);
    for (int y = 0; y <= cells; ++y)
    {
        for (int x = 0; x <= cells; ++x)
        {
            const glm::vec2 uv = glm::vec2(x, y) / static_cast<float>(cells);
            data.uv.push_back(uv);
            data.vertices.push_back(side.forward + (2.0f * uv.x - 1.0f) * side.right +
                                    (2.0f * uv.y - 1.0f) * side.up);
        }
    }
    const auto begin = static_cast<std::uint32_t>(data.triangles.size());
    for (std::uint32_t corner = first; corner + row < data.vertices.size(); ++corner)
    {
        if ((corner - first) % row != row - 1)
        {
            data.triangles.insert(data.triangles.end(), {corner, corner + row, corner + row + 1,
                                                         corner, corner + row + 1, corner + 1});
        }
    }
    data.subMeshes.push_back({begin, static_cast<std::uint32_t>(data.triangles.size()) - begin});
}

std::shared_ptr<const Mesh> MakeCube()
{
    MeshData data;
    for (const std::size_t side : k_SkySides)
    {
        AddSide(data, k_FacesOfCube[side], 1);
    }
    return std::make_shared<const Mesh>("Skybox", std::move(data));
}

std::shared_ptr<const Mesh> MakeBall()
{
    MeshData data;
    for (const std::size_t side : k_SkySides)
    {
        AddSide(data, k_FacesOfCube[side], k_Cells);
    }
    for (glm::vec3& vertex : data.vertices)
    {
        vertex = glm::normalize(vertex);
    }
    data.uv.clear(); // Unity's would have the direction there once more
    data.subMeshes.clear();
    return std::make_shared<const Mesh>("Skysphere", std::move(data));
}

/// So large that the rounding of the camera's position is nothing beside it.
float SizeOf(const Camera& camera)
{
    constexpr float k_Least = 1000.0f;
    return std::max(camera.farClipPlane, k_Least);
}

} // namespace

DrawSkyboxPass::DrawSkyboxPass()
{
    profilingSampler = ProfilingSampler("Draw Skybox");
    renderPassEvent = RenderPassEvent::BeforeRenderingSkybox;
}

bool DrawSkyboxPass::HasSky(const RenderingData& renderingData)
{
    return renderingData.cameraData.renderType == CameraRenderType::Base &&
           renderingData.cameraData.camera->clearFlags == CameraClearFlags::Skybox &&
           renderingData.scene != nullptr && renderingData.scene->skybox != nullptr;
}

void DrawSkyboxPass::Execute(ScriptableRenderContext& context, RenderingData& renderingData)
{
    static const std::shared_ptr<const Mesh> cube = MakeCube();
    static const std::shared_ptr<const Mesh> ball = MakeBall();
    const CameraData& data = renderingData.cameraData;
    const std::shared_ptr<const Material>& sky = renderingData.scene->skybox;
    const glm::vec3 position = data.camera->transform.position();
    glm::dmat4 view{glm::dmat3(data.viewMatrix)};
    view[3] = glm::dvec4(-(glm::dmat3(view) * glm::dvec3(position)), 1.0);
    const glm::mat4 around =
        glm::scale(glm::translate(glm::mat4(1.0f), position), glm::vec3(SizeOf(*data.camera)));

    const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
    RenderingUtils::SetViewAndProjectionMatrices(*cmd, view, SkyProjection(data), false);
    const bool hasSides = sky->passCount() == k_CubeFaces;
    for (int pass = 0; pass < (hasSides ? k_CubeFaces : 1); ++pass)
    {
        cmd->DrawMesh(hasSides ? cube : ball, around, sky, hasSides ? pass : 0, pass);
    }
    RenderingUtils::SetViewAndProjectionMatrices(*cmd, data.viewMatrix, data.gpuProjectionMatrix,
                                                 false);
    context.ExecuteCommandBuffer(*cmd);
}

glm::mat4 SkyProjection(const CameraData& cameraData)
{
    glm::mat4 projection = cameraData.gpuProjectionMatrix;
    const Camera& camera = *cameraData.camera;
    if (camera.orthographic)
    {
        // The picture at the far plane stays as it is; w becomes the share of that distance, and
        // what was constant there is so many of it.
        const float distance = std::max(camera.farClipPlane, 1.0f);
        projection[3] -= distance * projection[2];
        projection[2] = -projection[3] / distance;
        projection[3] = glm::vec4(0.0f);
    }
    for (int column = 0; column < 4; ++column)
    {
        projection[column][2] = cameraData.usesReversedZBuffer ? 0.0f : projection[column][3];
    }
    return projection;
}

} // namespace limn
