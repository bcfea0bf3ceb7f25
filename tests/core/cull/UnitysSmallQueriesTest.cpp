#include "pipeline/RendererHarness.h"
#include "record/RecordedCommands.h"
#include "renderers/DrawHarness.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/RendererList.h>
#include <limn/core/UniversalRenderPipeline.h>

// Members that answer what a feature asks of a setting, mesh, material or shader.
namespace limn::test
{
namespace
{

TEST(DrawingSettingsNames, AreGivenBackAsTheyWereSet)
{
    DrawingSettings settings;
    settings.SetShaderPassName(0, ShaderTagId("First"));
    settings.SetShaderPassName(2, ShaderTagId("Third"));
    EXPECT_EQ(settings.GetShaderPassName(0), "First");
    EXPECT_EQ(settings.GetShaderPassName(1), "") << "none was set";
    EXPECT_EQ(settings.GetShaderPassName(2), "Third");
    EXPECT_EQ(settings.GetShaderPassName(15), "");
    EXPECT_THROW(settings.GetShaderPassName(16), ContractError);
    EXPECT_THROW(settings.GetShaderPassName(-1), ContractError);
}

TEST(CubeMesh, HasEightCornersAndFacesThatLookOutside)
{
    const std::shared_ptr<const Mesh> mesh = CoreUtils::CreateCubeMesh({-1, 2, 3}, {1, 6, 9});
    EXPECT_EQ(mesh->data().vertices.size(), 8u);
    EXPECT_EQ(mesh->bounds().center, glm::vec3(0, 4, 6));
    EXPECT_EQ(mesh->bounds().extents, glm::vec3(1, 2, 3));
    const auto& indices = mesh->data().triangles;
    ASSERT_EQ(indices.size(), 36u);
    float area = 0.0f;
    for (std::size_t i = 0; i < indices.size(); i += 3)
    {
        const auto& at = mesh->data().vertices;
        const glm::vec3 a = at[indices[i]];
        // Left-handed and clockwise: the product points at whom the triangle faces.
        const glm::vec3 normal = glm::cross(at[indices[i + 1]] - a, at[indices[i + 2]] - a);
        EXPECT_GT(glm::dot(normal, a - glm::vec3(0, 4, 6)), 0.0f) << "triangle " << i / 3;
        area += 0.5f * glm::length(normal);
    }
    EXPECT_FLOAT_EQ(area, 2.0f * (2 * 4 + 2 * 6 + 4 * 6));
}

TEST(MeshQueries, SayWhatAllMeshesAreMadeOf)
{
    const auto mesh = CreatePrimitive(PrimitiveType::Quad);
    EXPECT_EQ(mesh->GetTopology(0), MeshTopology::Triangles);
    EXPECT_EQ(mesh->indexFormat(), IndexFormat::UInt32);
    EXPECT_THROW(mesh->GetTopology(1), std::out_of_range);
}

TEST(MaterialBuffers, AreThereOnceTheyWereSet)
{
    Material material(ShaderWithProgram(""));
    const auto points = std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Structured, 4, 16);
    const auto constants =
        std::make_shared<GraphicsBuffer>(GraphicsBuffer::Target::Constant, 4, 16);
    EXPECT_FALSE(material.HasBuffer("_Points"));
    EXPECT_EQ(material.GetBuffer("_Points"), nullptr);
    material.SetBuffer("_Points", points);
    material.SetConstantBuffer("_Constants", constants, 0, 64);
    material.SetMatrix("_Matrix", glm::mat4(1.0f));
    EXPECT_TRUE(material.HasBuffer("_Points"));
    EXPECT_FALSE(material.HasConstantBuffer("_Points"));
    EXPECT_EQ(material.GetBuffer("_Points"), points);
    EXPECT_EQ(material.GetConstantBuffer("_Points"), nullptr);
    EXPECT_TRUE(material.HasConstantBuffer("_Constants"));
    EXPECT_EQ(material.GetConstantBuffer("_Constants"), constants);
    EXPECT_TRUE(material.HasMatrix("_Matrix"));
    EXPECT_FALSE(material.HasMatrix("_Points"));
}

TEST(ShaderQueries, FindPropertiesByName)
{
    const auto shader = ShaderOf("Shader \"Test\" { Properties { _A(\"A\", Float) = 1\n"
                                 "_B(\"B\", Color) = (1, 1, 1, 1) } SubShader { Pass { } } }");
    EXPECT_EQ(shader->FindPropertyIndex("_A"), 0);
    EXPECT_EQ(shader->FindPropertyIndex("_B"), 1);
    EXPECT_EQ(shader->FindPropertyIndex("_C"), -1);
    EXPECT_TRUE(shader->isSupported());
}

TEST(SortModes, OfACameraSayWhatSortsItsObjects)
{
    struct Pass final : ScriptableRenderPass
    {
    } pass;
    Camera camera;
    RenderingData data;
    data.cameraData.camera = &camera;
    const auto metric = [&]
    {
        return pass
            .CreateDrawingSettings(ShaderTagId("A"), data, SortingCriteria::CommonTransparent)
            .sortingSettings.distanceMetric;
    };
    EXPECT_EQ(metric(), DistanceMetric::Perspective);
    camera.transparencySortMode = TransparencySortMode::Orthographic;
    EXPECT_EQ(metric(), DistanceMetric::Orthographic);
    camera.orthographic = true;
    camera.transparencySortMode = TransparencySortMode::Default;
    EXPECT_EQ(metric(), DistanceMetric::Orthographic);
    camera.transparencySortMode = TransparencySortMode::Perspective;
    EXPECT_EQ(metric(), DistanceMetric::Perspective);
    camera.transparencySortMode = TransparencySortMode::CustomAxis;
    camera.transparencySortAxis = {0, 1, 0};
    EXPECT_EQ(metric(), DistanceMetric::CustomAxis);
    EXPECT_EQ(pass.CreateDrawingSettings(ShaderTagId("A"), data, SortingCriteria::CommonTransparent)
                  .sortingSettings.customAxis,
              glm::vec3(0, 1, 0));
    EXPECT_EQ(static_cast<int>(TransparencySortMode::CustomAxis), 3);
    EXPECT_EQ(static_cast<int>(DistanceMetric::CustomAxis), 2);
}

TEST(SortModes, NoDistanceSortLeavesTheDistanceOutOfTheDefaults)
{
    std::vector<CameraData> seen;
    RecordingDevice device;
    UniversalRenderPipeline pipeline(device);
    UniversalRenderer renderer(Compiler());
    renderer.AddFeature(std::make_unique<CamerasReader>(seen));
    Scene scene;
    Camera camera;
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = 8;
    request.height = 8;
    for (const OpaqueSortMode mode :
         {OpaqueSortMode::Default, OpaqueSortMode::FrontToBack, OpaqueSortMode::NoDistanceSort})
    {
        camera.opaqueSortMode = mode;
        pipeline.RenderSingleCamera(renderer, request);
    }
    ASSERT_EQ(seen.size(), 3u);
    EXPECT_EQ(seen[0].defaultOpaqueSortFlags, SortingCriteria::CommonOpaque);
    EXPECT_EQ(seen[1].defaultOpaqueSortFlags, SortingCriteria::CommonOpaque);
    // SortingLayer 1, RenderQueue 2, OptimizeStateChanges 16 and CanvasOrder 32.
    EXPECT_EQ(static_cast<int>(seen[2].defaultOpaqueSortFlags), 51);
}

TEST(MultipleMeshes, AreDrawnEachWithItsMatrix)
{
    const auto quad = CreatePrimitive(PrimitiveType::Quad);
    const auto cube = CreatePrimitive(PrimitiveType::Cube);
    const std::vector<std::shared_ptr<const Mesh>> meshes{quad, cube};
    const std::vector<glm::mat4> matrices{glm::mat4(1.0f),
                                          glm::translate(glm::mat4(1.0f), {1, 2, 3})};
    const std::vector<int> subMeshes{0, 0};
    const auto material = std::make_shared<const Material>(ShaderWithProgram(""));
    CommandBuffer cmd;
    cmd.DrawMultipleMeshes(matrices, meshes, subMeshes, 2, material, 0);
    CommandBuffer single;
    single.DrawMesh(quad, matrices[0], material);
    single.DrawMesh(cube, matrices[1], material);
    ASSERT_EQ(cmd.commands().size(), single.commands().size());
    for (std::size_t i = 0; i < 2; ++i)
    {
        const auto& draw = std::get<RecordedDraw>(cmd.commands()[i]);
        const auto& expected = std::get<RecordedDraw>(single.commands()[i]);
        EXPECT_EQ(draw.mesh, expected.mesh);
        EXPECT_EQ(draw.matrix, expected.matrix);
    }
    EXPECT_THROW(cmd.DrawMultipleMeshes(matrices, meshes, subMeshes, 3, material, 0),
                 ContractError);
}

} // namespace
} // namespace limn::test
