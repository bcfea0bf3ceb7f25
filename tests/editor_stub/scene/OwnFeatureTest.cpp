#include "SceneFolder.h"

#include <gmock/gmock.h>
#include <limn/core/Inspector.h>
#include <limn/core/Material.h>

namespace limn::test
{

namespace
{

class HaloFeature final : public ScriptableRendererFeature
{
public:
    float m_Radius = 1.0f;
    int m_Rings = 1;

    void Create() override {}
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
    void Describe(Inspector& inspector) override
    {
        inspector.Field("m_Radius", m_Radius, {0, 5}, "Metres");
        inspector.Field("m_Rings", m_Rings, "How many"); // any number
    }
};

/// Finds its shader by name and sets a material of its settings.
class FindingFeature final : public ScriptableRendererFeature
{
public:
    std::shared_ptr<const Shader> found;
    std::shared_ptr<Material> m_Material;

    void Create() override
    {
        found = Shader::Find("Hidden/ScreenSpaceOutline");
        if (m_Material)
        {
            m_Material->SetFloat("_Width", 7);
        }
    }
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}
    void Describe(Inspector& inspector) override
    {
        inspector.Field("m_Material", m_Material, "Drawn with");
    }
};

} // namespace

TEST(OwnFeature, FindsShadersByNameAndSetsTheMaterialOfItsSettings)
{
    SceneFolder folder;
    folder.assets.features().Register<FindingFeature>("FindingFeature");
    const SceneAsset scene =
        folder.LoadWithCamera("materials: {flat: {shader: Universal Render Pipeline/Unlit}}\n"
                              "renderer: {features: [{type: FindingFeature, m_Material: flat}]}\n");
    ASSERT_EQ(1u, scene.renderer.features.size());
    const auto* feature = dynamic_cast<const FindingFeature*>(scene.renderer.features[0].get());
    ASSERT_NE(nullptr, feature);
    ASSERT_NE(nullptr, feature->found);
    EXPECT_EQ(feature->found, folder.assets.FindShader("Hidden/ScreenSpaceOutline"));
    ASSERT_NE(nullptr, feature->m_Material);
    EXPECT_EQ("flat", feature->m_Material->name());
    EXPECT_NE(nullptr, feature->m_Material->Find("_Width"));
}

TEST(OwnFeature, OfAProgramIsReadFromAScene)
{
    SceneFolder folder;
    folder.assets.features().Register<HaloFeature>("HaloFeature");
    const SceneAsset scene = folder.LoadWithCamera(
        "renderer: {features: [{type: HaloFeature, radius: 2.5, m_Rings: -70000}]}\n");
    ASSERT_EQ(1u, scene.renderer.features.size());
    const auto* halo = dynamic_cast<const HaloFeature*>(scene.renderer.features[0].get());
    ASSERT_NE(nullptr, halo);
    EXPECT_EQ(2.5f, halo->m_Radius);
    EXPECT_EQ(-70000, halo->m_Rings);
    EXPECT_THAT(folder.ProblemsOf("camera: {}\n"
                                  "renderer: {features: [{type: HaloFeature, m_Radius: 6}]}\n"),
                testing::ElementsAre("2:53: renderer.features[0].m_Radius: 6 is outside [0, 5]"));
}

TEST(OwnFeature, IsUnknownToOtherPrograms)
{
    SceneFolder folder;
    EXPECT_THAT(folder.ProblemsOf("camera: {}\nrenderer: {features: [{type: HaloFeature}]}\n"),
                testing::ElementsAre(testing::HasSubstr("unknown feature 'HaloFeature'")));
}

} // namespace limn::test
