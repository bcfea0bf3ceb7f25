#include <gmock/gmock.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/features/Features.h>
#include <limn/features/RenderObjects.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>

namespace limn::test
{

TEST(Features, OfEveryFolderAreRegistered)
{
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFeatures(features, components);
    EXPECT_THAT(
        features.names(),
        testing::IsSupersetOf({"ColorEdgesRendererFeature", "DepthNormalsOutlineRendererFeature",
                               "FullScreenPassRendererFeature", "RenderObjects",
                               "ScreenSpaceOutlineRenderFeature"}));
    const auto feature = features.Create("ScreenSpaceOutlineRenderFeature");
    EXPECT_NE(nullptr, dynamic_cast<ScreenSpaceOutlineRenderFeature*>(feature.get()));
    EXPECT_NE(features.Create("RenderObjects"), features.Create("RenderObjects"));
}

TEST(Features, VolumeComponentsAreKnownByTheirTypesName)
{
    VolumeComponentRegistry registry;
    RegisterVolumeComponents(registry);
    const auto component = registry.Create("ScreenSpaceOutline");
    EXPECT_NE(nullptr, dynamic_cast<ScreenSpaceOutline*>(component.get()));
}

TEST(Features, EveryShippedShaderIsFoundByItsName)
{
    const auto compiler = std::make_shared<ShaderCompiler>();
    EXPECT_THAT(ShippedShaders().names(),
                testing::IsSupersetOf({"Hidden/Limn/ColorEdges", "Hidden/Limn/DepthNormalsOutline",
                                       "Hidden/ScreenSpaceOutline", "Hidden/Universal/CoreBlit",
                                       "Limn/TranslucentOutline", "Limn/TranslucentOutlineHull",
                                       "Limn/TranslucentSolid", "Limn/Half Lambert",
                                       "Universal Render Pipeline/Lit",
                                       "Universal Render Pipeline/Unlit"}));
    for (const std::string_view name : ShippedShaders().names())
    {
        EXPECT_EQ(name, FindShippedShader(name, compiler)->name());
    }
    EXPECT_THROW(FindShippedShader("Nope", compiler), ContractError);
}

TEST(Features, ShippedShadersAreReadOnce)
{
    const ShaderLabDocument* document = ShippedShaders().Find("Universal Render Pipeline/Lit");
    EXPECT_EQ(document, ShippedShaders().Find("Universal Render Pipeline/Lit"));
    EXPECT_EQ(document, BuiltinShaders().Find("Universal Render Pipeline/Lit"));
}

TEST(FeatureRegistry, GivesNullForAnUnknownName)
{
    FeatureRegistry features;
    features.Register<RenderObjects>("RenderObjects");
    EXPECT_EQ(nullptr, features.Create("renderobjects"));
    EXPECT_EQ(nullptr, features.Create(""));
}

TEST(FeatureRegistry, RefusesAnEmptyNameAndOneThatIsTaken)
{
    FeatureRegistry features;
    features.Register<RenderObjects>("Objects");
    EXPECT_THROW(features.Register<RenderObjects>(""), ContractError);
    EXPECT_THROW(features.Register<ScreenSpaceOutlineRenderFeature>("Objects"), ContractError);
    features.Register<RenderObjects>("MoreObjects"); // one type, two names
    EXPECT_EQ((std::vector<std::string_view>{"Objects", "MoreObjects"}), features.names());
}

} // namespace limn::test
