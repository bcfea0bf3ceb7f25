#include "features/materials/PanelWall.h"

namespace limn::test
{

using SpriteGpu = GpuTest;

TEST_F(SpriteGpu, ShowsItsPictureInItsColoursOverWhatIsBehind)
{
    MeshData quad = CreatePrimitive(PrimitiveType::Quad)->data();
    quad.colors.assign(quad.vertices.size(), {1.0f, 0.5f, 0.25f, 0.5f});
    const auto mesh = std::make_shared<const Mesh>("sprite", quad);
    const auto material =
        std::make_shared<Material>(FindBuiltinShader("Sprites/Default", Compiler()));
    Set(*material, "_MainTex", glm::ivec4(255, 255, 255, 204));
    Set(*material, "_Color", glm::vec4(0.5f, 1.0f, 1.0f, 1.0f));
    PanelWall wall;
    wall.background = Color(0, 1, 0, 1);
    wall.Add(material, glm::quat(1, 0, 0, 0), mesh);
    wall.Add(material, glm::quat(0, 0, 1, 0), mesh); // from behind
    const double alpha = 0.5 * 204 / 255;
    const glm::dvec3 expected =
        alpha * glm::dvec3(0.5, 0.5, 0.25) + (1 - alpha) * glm::dvec3(0, 1, 0);
    for (const glm::dvec4& color : wall.Draw())
    {
        for (int channel = 0; channel < 3; ++channel)
        {
            EXPECT_NEAR(color[channel], expected[channel], 1.0 / 1024.0); // of half floats
        }
    }
}

} // namespace limn::test
