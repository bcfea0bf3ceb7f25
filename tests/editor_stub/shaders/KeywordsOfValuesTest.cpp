#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/core/Image.h>
#include <limn/core/Material.h>

namespace limn::test
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;

/// A scene with a cube of one material, and the picture "map.png".
class KeywordsOfValues : public testing::Test
{
protected:
    KeywordsOfValues()
    {
        WritePng(m_Folder / "map.png",
                 {1, 1, GraphicsFormat::R8G8B8A8_SRGB, std::vector<std::byte>(4)});
    }
    std::vector<std::string> Of(const std::string& shader, const std::string& values)
    {
        m_Asset.emplace(m_Folder.LoadWithCamera(
            "materials: {m: {shader: Universal Render Pipeline/" + shader + values +
            "}}\nobjects: [{name: A, mesh: cube, material: m}]\n"));
        return material().shaderKeywords();
    }
    const Material& material()
    {
        return *m_Asset->scene.Find("A")->renderer->sharedMaterials.front();
    }

    SceneFolder m_Folder;
    std::optional<SceneAsset> m_Asset;
};

TEST_F(KeywordsOfValues, AreThoseThatUnitysInspectorSets)
{
    EXPECT_THAT(Of("Lit", ""), IsEmpty());
    EXPECT_THAT(
        Of("Lit", ", _BumpMap: map.png, _OcclusionMap: map.png, _MetallicGlossMap: map.png"),
        ElementsAre("_METALLICSPECGLOSSMAP", "_NORMALMAP", "_OCCLUSIONMAP"));
    EXPECT_THAT(Of("Lit", ", _BumpMap: bump"), IsEmpty()) << "the default is no map";
    EXPECT_THAT(Of("Lit", ", _WorkflowMode: 0, _MetallicGlossMap: map.png"),
                ElementsAre("_SPECULAR_SETUP"));
    EXPECT_THAT(Of("Lit", ", _WorkflowMode: 0, _SpecGlossMap: map.png"),
                ElementsAre("_METALLICSPECGLOSSMAP", "_SPECULAR_SETUP"));
    EXPECT_THAT(Of("Lit", ", _Surface: 1, _AlphaClip: 1, _ReceiveShadows: 0, "
                          "_EmissionColor: [0, 0.5, 0, 1]"),
                ElementsAre("_ALPHATEST_ON", "_EMISSION", "_RECEIVE_SHADOWS_OFF",
                            "_SURFACE_TYPE_TRANSPARENT"));
    EXPECT_THAT(Of("Lit", ", _DetailAlbedoMap: map.png"), ElementsAre("_DETAIL_MULX2"));
    EXPECT_THAT(Of("Lit", ", _DetailNormalMap: map.png, _DetailAlbedoMapScale: 0.5"),
                ElementsAre("_DETAIL_SCALED"));
}

TEST_F(KeywordsOfValues, OfSimpleLitChooseItsHighlights)
{
    EXPECT_THAT(Of("Simple Lit", ", _Smoothness: 0.75"), ElementsAre("_SPECULAR_COLOR"));
    EXPECT_EQ(material().GetColor(ShaderPropertyId("_SpecColor")).a, 0.75f);
    EXPECT_THAT(Of("Simple Lit", ", _SpecGlossMap: map.png"), ElementsAre("_SPECGLOSSMAP"));
    EXPECT_THAT(Of("Simple Lit", ", _SpecularHighlights: 0"), IsEmpty());
}

} // namespace
} // namespace limn::test
