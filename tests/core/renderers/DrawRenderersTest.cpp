#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "Mentions.h"
#include "ThrownMessage.h"
#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

const ShaderTagId k_Forward("UniversalForward");
const ShaderTagId k_Unlit("SRPDefaultUnlit");

/// What DrawRenderers appends to the frame.
class DrawRenderersCalls : public testing::Test
{
protected:
    DrawRenderersCalls() { m_Drawing.shaderTagIds = {k_Forward}; }

    /// Draws everything in the scene, seen or not.
    std::vector<test::SeenDraw> Draw(const FilteringSettings& filtering = FilteringSettings())
    {
        Camera camera;
        camera.orthographic = true;
        camera.orthographicSize = 1e6f;
        camera.nearClipPlane = -1e6f;
        camera.farClipPlane = 1e6f;
        ScriptableRenderContext context(m_Report);
        context.SetPassName("Outline");
        context.DrawRenderers(Cull(m_Scene, camera, 1.0f), m_Drawing, filtering);
        m_Frame = context.TakeCommands();
        return test::DrawsOf(m_Frame);
    }

    const std::shared_ptr<Material> m_Plain =
        std::make_shared<Material>(test::ShaderWithProgram(""), "Plain");
    Scene m_Scene;
    DrawingSettings m_Drawing;
    RenderReport m_Report;
    FrameCommands m_Frame;
};

TEST_F(DrawRenderersCalls, MergeObjectsThatDifferInTheirTransformOnly)
{
    test::AddCube(m_Scene, "a", {1, 0, 0}, {m_Plain});
    test::AddCube(m_Scene, "b", {2, 0, 0}, {m_Plain});
    test::AddCube(m_Scene, "c", {3, 0, 0}, {m_Plain}).renderer->renderingLayerMask =
        RenderingLayerMask(0x11);
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].mesh, test::Cube());
    EXPECT_EQ(draws[0].firstInstance, 0u);
    EXPECT_EQ(draws[0].instanceCount, 3u);
    for (int i = 0; i < 3; ++i)
    {
        const PerDrawData data = m_Frame.PerDraw(draws[0], static_cast<std::uint32_t>(i));
        EXPECT_EQ(data.objectToWorld[12], static_cast<float>(i + 1));
        EXPECT_EQ(data.worldToObject[12], static_cast<float>(-i - 1));
        EXPECT_EQ(data.worldTransformParams[3], 1.0f);
        EXPECT_EQ(data.renderingLayer[0], i == 2 ? 0x11u : 1u);
    }
}

TEST_F(DrawRenderersCalls, KeepDifferentMaterialsApart)
{
    const auto other = std::make_shared<Material>(m_Plain->shader(), "Other");
    test::AddCube(m_Scene, "a", {0, 0, 0}, {m_Plain});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {other});
    test::AddCube(m_Scene, "c", {0, 0, 0}, {other});
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[0].instanceCount, 1u);
    EXPECT_EQ(draws[1].instanceCount, 2u);
    EXPECT_EQ(draws[1].firstInstance, 1u);
}

TEST_F(DrawRenderersCalls, KeepDifferentMeshesApart)
{
    test::AddCube(m_Scene, "a", {0, 0, 0}, {m_Plain});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {m_Plain}).renderer->mesh =
        CreatePrimitive(PrimitiveType::Quad);
    EXPECT_EQ(Draw().size(), 2u);
}

TEST_F(DrawRenderersCalls, KeepMirroredObjectsApart)
{
    test::AddCube(m_Scene, "a", {0, 0, 0}, {m_Plain});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {m_Plain}).transform.localScale = {-1, 1, 1};
    test::AddCube(m_Scene, "c", {0, 0, 0}, {m_Plain}).transform.localScale = {-1, -1, 1};
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 3u);
    EXPECT_TRUE(draws[0].state.frontFaceFlipped); // by the projection into a texture
    EXPECT_FALSE(draws[1].state.frontFaceFlipped);
    EXPECT_TRUE(draws[2].state.frontFaceFlipped);
    EXPECT_EQ(m_Frame.PerDraw(draws[1]).worldTransformParams[3], -1.0f);
}

/// A material whose geometry function hands triangles on, moved by `offset`.
std::shared_ptr<const Material> WithGeometry(const std::string& offset)
{
    return std::make_shared<Material>(test::ShaderOf(
        "Shader \"Test/Geometry\" { SubShader { Pass {"
        " Tags { \"LightMode\" = \"UniversalForward\" }\nHLSLPROGRAM\n"
        "#pragma vertex Vert\n#pragma geometry Geom\n#pragma fragment Frag\n"
        "StructuredBuffer<float4> limn_PerDraw;\n"
        "struct Corner { float4 position : SV_POSITION; };\n"
        "Corner Vert(float4 p : POSITION) { Corner c; c.position = p + limn_PerDraw[1]; return c; "
        "}\n"
        "[maxvertexcount(1)] void Geom(triangle Corner v[3], inout PointStream<Corner> stream)\n"
        "{ Corner c; c.position = v[0].position + " +
        offset +
        "; stream.Append(c); }\n"
        "float4 Frag() : SV_Target { return 1; }\nENDHLSL } } }"));
}

TEST_F(DrawRenderersCalls, KeepObjectsApartWhoseGeometryFunctionsReadPerDrawData)
{
    const auto reading = WithGeometry("limn_PerDraw[0]");
    test::AddCube(m_Scene, "a", {0, 0, 0}, {reading});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {reading});
    EXPECT_EQ(Draw().size(), 2u);
}

TEST_F(DrawRenderersCalls, MergeObjectsOfAGeometryFunctionThatReadsNoPerDrawData)
{
    const auto plain = WithGeometry("1");
    test::AddCube(m_Scene, "a", {0, 0, 0}, {plain});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {plain});
    EXPECT_EQ(Draw().size(), 1u);
}

TEST_F(DrawRenderersCalls, KeepObjectsApartWhoseVertexFunctionTakesTheInstanceId)
{
    const auto material = std::make_shared<Material>(
        test::ShaderOf("Shader \"Test/Instance\" { SubShader { Pass {"
                       " Tags { \"LightMode\" = \"UniversalForward\" }\nHLSLPROGRAM\n"
                       "#pragma vertex Vert\n#pragma fragment Frag\n"
                       "float4 Vert(float4 p : POSITION, uint id : SV_InstanceID) : SV_POSITION\n"
                       "{ return p + id; }\n"
                       "float4 Frag() : SV_Target { return 1; }\nENDHLSL } } }"));
    test::AddCube(m_Scene, "a", {0, 0, 0}, {material});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {material});
    EXPECT_EQ(Draw().size(), 2u);
}

TEST_F(DrawRenderersCalls, KeepObjectsApartWhoseFragmentsReadPerDrawData)
{
    const auto reading = std::make_shared<Material>(
        test::ShaderWithProgram("", "StructuredBuffer<float4> limn_PerDraw;", "limn_PerDraw[0]"));
    test::AddCube(m_Scene, "a", {0, 0, 0}, {reading});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {reading});
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[1].firstInstance, 1u);
    EXPECT_EQ(draws[0].bindings->perDrawBinding,
              draws[0].program->layout.storageBuffers.at(0).binding);
}

TEST_F(DrawRenderersCalls, ShareOneSetOfBindingsAmongEqualDraws)
{
    test::AddCube(m_Scene, "a", {0, 0, 0}, {m_Plain});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {m_Plain}).renderer->mesh =
        CreatePrimitive(PrimitiveType::Quad);
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[0].bindings, draws[1].bindings);
}

TEST_F(DrawRenderersCalls, DrawEveryTagsFirstPassOfAnObjectInTurn)
{
    const auto shader = test::ShaderOf(
        "Shader \"Test/Hull\" { SubShader {\n"
        "Pass { Name \"Fill\" Tags { \"LightMode\" = \"UniversalForward\" } Cull Back " +
        test::Program() + "}\nPass { Name \"Hull\" Cull Front " + test::Program() +
        "}\nPass { Name \"Second\" Cull Off " + test::Program() + "} } }");
    const auto material = std::make_shared<Material>(shader);
    test::AddCube(m_Scene, "a", {0, 0, 0}, {material});
    m_Drawing.shaderTagIds = {k_Unlit, k_Forward, ShaderTagId("Missing")};
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(draws[0].state.cull, CullMode::Front);
    EXPECT_EQ(draws[1].state.cull, CullMode::Back);
    EXPECT_EQ(m_Report.draws.at(0).counts[0], 1);
}

TEST_F(DrawRenderersCalls, DrawWithTheOverrideMaterialWhatHasAMatchingPass)
{
    const auto unmatched = std::make_shared<Material>(test::ShaderWithModes({"Other"}));
    test::AddCube(m_Scene, "a", {0, 0, 0}, {m_Plain});
    test::AddCube(m_Scene, "b", {0, 0, 0}, {unmatched});
    m_Drawing.overrideMaterial =
        std::make_shared<Material>(test::ShaderWithProgram("", "", "1", "Cull Off"), "Mask");
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].state.cull, CullMode::Off);
    EXPECT_EQ(m_Report.draws.at(0).counts, (FilterCounts{1, 0, 0, 0, 1}));
}

TEST_F(DrawRenderersCalls, FilterByTheObjectsOwnQueueDespiteAnOverride)
{
    m_Plain->SetRenderQueue(3000);
    test::AddCube(m_Scene, "a", {0, 0, 0}, {m_Plain});
    m_Drawing.overrideMaterial = std::make_shared<Material>(test::ShaderWithProgram(""));
    EXPECT_EQ(Draw(FilteringSettings(RenderQueueRange::opaque)).size(), 0u);
    EXPECT_EQ(Draw(FilteringSettings(RenderQueueRange::transparent)).size(), 1u);
}

TEST_F(DrawRenderersCalls, RefuseAnOverridePassThatDoesNotExist)
{
    test::AddCube(m_Scene, "a", {0, 0, 0}, {m_Plain});
    m_Drawing.overrideMaterial = m_Plain;
    m_Drawing.overrideMaterialPassIndex = 7;
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { Draw(); }),
                test::Mentions("'Test/Program'", "no pass 7", "has 1"));
}

TEST_F(DrawRenderersCalls, DrawInTheOrderOfTheSorting)
{
    const auto other = std::make_shared<Material>(m_Plain->shader(), "Other");
    test::AddCube(m_Scene, "near", {0, 0, 1}, {m_Plain});
    test::AddCube(m_Scene, "far", {0, 0, 9}, {other});
    m_Drawing.sortingSettings.criteria = SortingCriteria::BackToFront;
    const auto draws = Draw();
    ASSERT_EQ(draws.size(), 2u);
    EXPECT_EQ(m_Frame.PerDraw(draws[0]).objectToWorld[14], 9.0f);
    EXPECT_EQ(m_Frame.PerDraw(draws[1]).objectToWorld[14], 1.0f);
}

TEST_F(DrawRenderersCalls, CountEachObjectUnderTheFirstRuleThatLeavesItOut)
{
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto number = [&](int high)
    {
        return static_cast<int>(random() % (unsigned(high) + 1));
    };
    const auto unmatched = std::make_shared<Material>(test::ShaderWithModes({"Other"}));
    const auto transparent = std::make_shared<Material>(m_Plain->shader());
    transparent->SetRenderQueue(3000);
    const std::vector<std::shared_ptr<const Material>> materials{m_Plain, unmatched, transparent};
    for (int i = 0; i < 200; ++i)
    {
        GameObject& object = test::AddCube(m_Scene, "cube", {0, 0, 0},
                                           {materials[static_cast<std::size_t>(number(2))]});
        object.layer = number(31);
        object.renderer->renderingLayerMask = RenderingLayerMask(random() & 3u);
    }
    const FilteringSettings filtering(RenderQueueRange::opaque, LayerMask(0x5555FFFFu),
                                      RenderingLayerMask(1));
    // The rules in Unity's order: queue, layer, rendering layer, pass.
    FilterCounts expected{};
    for (const auto& object : m_Scene.objects())
    {
        const auto& material = object->renderer->sharedMaterials[0];
        const bool isInLayer = object->layer < 16 || object->layer % 2 == 0; // 0x5555FFFF
        const bool isInRenderingLayer =
            object->renderer->renderingLayerMask.Intersects(RenderingLayerMask(1));
        const FilterVerdict verdict = material == transparent ? FilterVerdict::QueueOutOfRange
                                      : !isInLayer            ? FilterVerdict::LayerMaskMiss
                                      : !isInRenderingLayer ? FilterVerdict::RenderingLayerMaskMiss
                                      : material == unmatched ? FilterVerdict::NoMatchingPass
                                                              : FilterVerdict::Drawn;
        ++expected[static_cast<std::size_t>(verdict)];
    }
    Draw(filtering);
    ASSERT_EQ(m_Report.draws.size(), 1u);
    EXPECT_EQ(m_Report.draws[0].pass, "Outline");
    EXPECT_EQ(m_Report.draws[0].filtering, filtering);
    EXPECT_EQ(m_Report.draws[0].counts, expected);
    EXPECT_EQ(m_Frame.instances.size(), static_cast<std::size_t>(expected[0]));
}

/// The per-draw data of one cube of this scale.
PerDrawData DataOf(const glm::vec3& scale)
{
    Transform transform;
    transform.localScale = scale;
    RenderReport report;
    ScriptableRenderContext context(report);
    CommandBuffer cmd;
    cmd.DrawMesh(test::Cube(), transform.localToWorldMatrix(),
                 std::make_shared<Material>(test::ShaderWithProgram("")));
    context.ExecuteCommandBuffer(cmd);
    return context.TakeCommands().perDraw.at(0);
}

TEST(PerDrawData, StaysFiniteForScalesThatHaveNoInverse)
{
    for (const glm::vec3& scale : {glm::vec3(0, 1, 1), glm::vec3(0.0f), glm::vec3(1, 0, -1)})
    {
        for (const float value : DataOf(scale).worldToObject)
        {
            EXPECT_TRUE(std::isfinite(value));
        }
    }
}

TEST(PerDrawData, HoldsTheInverseOfVerySmallAndVeryLargeScales)
{
    for (const double scale : {1e-20, 1e-10, 1.0, 1e10, 1e20})
    {
        const PerDrawData data = DataOf(glm::vec3(static_cast<float>(scale)));
        EXPECT_NEAR(static_cast<double>(data.worldToObject[0]) * scale, 1.0, 1e-6);
        EXPECT_NEAR(static_cast<double>(data.worldToObject[5]) * scale, 1.0, 1e-6);
        EXPECT_EQ(data.worldToObject[15], 1.0f);
        EXPECT_EQ(data.worldTransformParams[3], 1.0f);
    }
}

TEST(PerDrawData, TellsThatATinyTransformMirrors)
{
    EXPECT_EQ(DataOf({-1e-20f, 1e-20f, 1e-20f}).worldTransformParams[3], -1.0f);
    EXPECT_EQ(DataOf({-1e12f, 1e12f, 1e12f}).worldTransformParams[3], -1.0f);
}

} // namespace
} // namespace limn
