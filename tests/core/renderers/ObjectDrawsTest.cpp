#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <random>

#include "renderers/DrawHarness.h"

namespace limn
{
namespace
{

/// How objects become instances.
class ObjectDraws : public testing::Test
{
protected:
    /// @param depth  the target has one
    std::vector<test::SeenDraw> Draw(SortingCriteria criteria, bool depth = true)
    {
        Camera camera;
        camera.orthographic = true;
        camera.orthographicSize = 1e4f;
        camera.nearClipPlane = -1e4f;
        camera.farClipPlane = 1e4f;
        ScriptableRenderContext context(m_Report);
        CommandBuffer cmd;
        cmd.SetRenderTarget(Target("color", GraphicsFormat::R8G8B8A8_UNorm),
                            depth ? Target("depth", GraphicsFormat::D32_SFloat_S8_UInt)
                                  : RTHandle());
        context.ExecuteCommandBuffer(cmd);
        DrawingSettings drawing;
        drawing.shaderTagIds = {ShaderTagId("UniversalForward")};
        drawing.sortingSettings.criteria = criteria;
        context.DrawRenderers(Cull(m_Scene, camera, 1.0f), drawing, FilteringSettings());
        m_Frame = context.TakeCommands();
        return test::DrawsOf(m_Frame);
    }
    static RTHandle Target(const char* name, GraphicsFormat format)
    {
        return RTHandle(std::make_shared<const RenderTexture>(
            name, RenderTextureDescriptor(4, 4, format), SamplerState(), true));
    }

    /// Objects at random distances, of `meshes` in turn.
    void Scatter(int count, const std::vector<std::shared_ptr<const Mesh>>& meshes,
                 const std::shared_ptr<const Material>& material)
    {
        std::mt19937 random(3);
        for (int i = 0; i < count; ++i)
        {
            GameObject& object = test::AddCube(
                m_Scene, "object", {0, 0, static_cast<float>(1 + random() % 1000)}, {material});
            object.renderer->mesh = meshes[static_cast<std::size_t>(i) % meshes.size()];
        }
    }

    /// z of each instance, in the order of drawing.
    std::vector<float> Places(const test::SeenDraw& draw) const
    {
        std::vector<float> places;
        for (std::uint32_t i = 0; i < draw.instanceCount; ++i)
        {
            places.push_back(m_Frame.PerDraw(draw, i).objectToWorld[14]);
        }
        return places;
    }

    const std::vector<std::shared_ptr<const Mesh>> m_Meshes{
        test::Cube(), CreatePrimitive(PrimitiveType::Quad), CreatePrimitive(PrimitiveType::Sphere)};
    Scene m_Scene;
    RenderReport m_Report;
    FrameCommands m_Frame;
};

std::shared_ptr<Material> MaterialWith(const std::string& state, bool looksAtItsPlace = true)
{
    const std::string program =
        looksAtItsPlace ? "HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
                          "float4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
                          "float4 F(float4 p : SV_POSITION) : SV_Target { return p; }\nENDHLSL\n"
                        : test::Program();
    return std::make_shared<Material>(
        test::ShaderOf("Shader \"Test/State\" { SubShader { Pass { Tags { \"LightMode\" = "
                       "\"UniversalForward\" }\n" +
                       state + "\n" + program + "} } }"));
}

TEST_F(ObjectDraws, AreOneForEachMeshWhereTheNearestWins)
{
    Scatter(300, m_Meshes, MaterialWith(""));
    const auto draws = Draw(SortingCriteria::CommonOpaque);
    ASSERT_EQ(draws.size(), 3u);
    for (const test::SeenDraw& draw : draws)
    {
        EXPECT_EQ(draw.instanceCount, 100u);
        const std::vector<float> places = Places(draw);
        for (std::size_t i = 1; i < places.size(); ++i)
        {
            // An eighth of an octave apart at most, and nearer ones first beyond that.
            EXPECT_LT(places[i - 1], places[i] * 1.0906f) << i;
        }
    }
}

TEST_F(ObjectDraws, AreOneForEachMeshWhereAllWriteTheSame)
{
    Scatter(300, m_Meshes, MaterialWith("ZTest Always ZWrite Off", false));
    EXPECT_EQ(Draw(SortingCriteria::CommonTransparent | SortingCriteria::CommonOpaque).size(), 3u);
    EXPECT_EQ(Draw(SortingCriteria::CommonOpaque, false).size(), 3u);
}

TEST_F(ObjectDraws, KeepTheirOrderWhereItCanBeSeen)
{
    const auto expectInOrder = [&](const std::string& state, SortingCriteria criteria, bool depth)
    {
        SCOPED_TRACE(state);
        m_Scene = Scene();
        Scatter(100, m_Meshes, MaterialWith(state));
        std::vector<float> places;
        for (const test::SeenDraw& draw : Draw(criteria, depth))
        {
            const std::vector<float> own = Places(draw);
            places.insert(places.end(), own.begin(), own.end());
        }
        ASSERT_EQ(places.size(), 100u);
        for (std::size_t i = 1; i < places.size(); ++i)
        {
            // Nearer ones first up to an eighth of an octave, or farther ones first.
            const bool isRight = criteria & SortingCriteria::BackToFront
                                     ? places[i - 1] >= places[i]
                                     : places[i - 1] < places[i] * 1.0906f;
            EXPECT_TRUE(isRight) << i;
        }
    };
    using enum SortingCriteria;
    expectInOrder("Blend One One ZWrite Off", CommonTransparent, true);
    expectInOrder("", CommonTransparent, true); // asked for by the criteria
    expectInOrder("Blend SrcAlpha OneMinusSrcAlpha", CommonOpaque, true);
    expectInOrder("", CommonOpaque, false); // nothing tells which is nearer
    expectInOrder("ZWrite Off", CommonOpaque, true);
    expectInOrder("ZTest Always", CommonOpaque, true);
    expectInOrder("Stencil { Ref 1 Pass Replace }", CommonOpaque, true);
    expectInOrder("", RenderQueue | QuantizedFrontToBack, true); // nobody wants states together
}

TEST_F(ObjectDraws, KeepAFurtherMaterialBehindTheFirst)
{
    // A cube has one sub-mesh: the second material draws over the first, at equal depth.
    const auto first = MaterialWith("");
    const auto second = MaterialWith("");
    test::AddCube(m_Scene, "the nearest, of the second only", {0, 0, 1}, {second});
    for (int i = 0; i < 4; ++i)
    {
        test::AddCube(m_Scene, "cube", {0, 0, static_cast<float>(10 + 100 * i)}, {first, second});
    }
    const auto draws = Draw(SortingCriteria::CommonOpaque);
    std::map<float, std::vector<std::shared_ptr<const DrawBindings>>> drawn;
    for (const test::SeenDraw& draw : draws)
    {
        for (const float place : Places(draw))
        {
            drawn[place].push_back(draw.bindings);
        }
    }
    ASSERT_EQ(drawn.size(), 5u);
    const auto& expected = drawn.rbegin()->second;
    EXPECT_EQ(expected.size(), 2u);
    EXPECT_EQ(expected.back(), drawn.begin()->second.front()) << "the second covers the first";
    drawn.erase(drawn.begin());
    for (const auto& [place, bindings] : drawn)
    {
        EXPECT_EQ(bindings, expected) << "at " << place;
    }
}

TEST_F(ObjectDraws, AreOneForEachWindingToo)
{
    Scatter(10, m_Meshes, MaterialWith(""));
    for (const auto& object : m_Scene.objects())
    {
        object->transform.localScale.x = object->transform.localPosition.z > 500.0f ? -1.0f : 1.0f;
    }
    for (const test::SeenDraw& draw : Draw(SortingCriteria::CommonOpaque))
    {
        for (const float place : Places(draw))
        {
            EXPECT_EQ(draw.state.frontFaceFlipped, place <= 500.0f);
        }
    }
}

TEST_F(ObjectDraws, ReachAsFarAsAllTheirObjects)
{
    const auto material = std::make_shared<Material>(test::ShaderOf(
        "Shader \"Test/Within\" { SubShader { Pass { Tags { \"LightMode\" = \"UniversalForward\" "
        "\"LimnWithinMesh\" = \"True\" }\n" +
        test::Program() + "} } }"));
    // Across a picture 4 high and wide: x from -1.5 to 0.5.
    for (int i = 0; i < 100; ++i)
    {
        test::AddCube(m_Scene, "cube", {-1.0f + 0.01f * static_cast<float>(i), 0, 0}, {material});
    }
    Camera camera;
    camera.orthographic = true;
    camera.orthographicSize = 2.0f;
    camera.nearClipPlane = -10.0f;
    camera.farClipPlane = 10.0f;
    for (const int count : {20, 100})
    {
        for (std::size_t i = 0; i < 100; ++i)
        {
            m_Scene.objects()[i]->activeSelf = static_cast<int>(i) < count;
        }
        ScriptableRenderContext context(m_Report);
        CommandBuffer cmd;
        cmd.SetGlobalMatrix(ShaderPropertyId("unity_MatrixVP"),
                            camera.gpuProjectionMatrix(1.0f) * camera.worldToCameraMatrix());
        context.ExecuteCommandBuffer(cmd);
        DrawingSettings drawing;
        drawing.shaderTagIds = {ShaderTagId("UniversalForward")};
        drawing.sortingSettings.criteria = SortingCriteria::CommonOpaque;
        context.DrawRenderers(Cull(m_Scene, camera, 1.0f), drawing, FilteringSettings());
        const auto draws = test::DrawsOf(context.TakeCommands());
        ASSERT_EQ(draws.size(), 1u);
        ASSERT_TRUE(draws[0].bounds.has_value());
        const double right = -1.0 + 0.01 * (count - 1) + 0.5;
        EXPECT_NEAR(draws[0].bounds->left, (-1.5 + 2.0) / 4.0, 1e-6);
        EXPECT_NEAR(draws[0].bounds->right, (right + 2.0) / 4.0, 1e-6);
        EXPECT_NEAR(draws[0].bounds->top, 1.5 / 4.0, 1e-6);
        EXPECT_NEAR(draws[0].bounds->bottom, 2.5 / 4.0, 1e-6);
    }
}

} // namespace
} // namespace limn
