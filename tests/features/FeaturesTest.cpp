#include <gtest/gtest.h>
#include <limn/features/Features.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>

namespace limn::test
{

TEST(Features, EveryListedTypeCanBeMade)
{
    ASSERT_FALSE(FeatureTypeNames().empty());
    for (const std::string_view name : FeatureTypeNames())
    {
        EXPECT_NE(nullptr, CreateFeature(name)) << name;
    }
    const auto feature = CreateFeature("ScreenSpaceOutlineRenderFeature");
    EXPECT_NE(nullptr, dynamic_cast<ScreenSpaceOutlineRenderFeature*>(feature.get()));
}

TEST(Features, AnUnknownTypeGivesNull)
{
    EXPECT_EQ(nullptr, CreateFeature("screenspaceoutlinerenderfeature"));
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
    ASSERT_EQ(7u, ShippedShaderNames().size());
    for (const std::string_view name : ShippedShaderNames())
    {
        const auto shader = FindShippedShader(name, compiler);
        ASSERT_NE(nullptr, shader) << name;
        EXPECT_EQ(name, shader->name());
    }
    EXPECT_EQ(nullptr, FindShippedShader("Nope", compiler));
}

TEST(Features, AShaderIsFoundByItsFilesStem)
{
    EXPECT_EQ("Hidden/ScreenSpaceOutline", ShippedShaderOfFile("ScreenSpaceOutline"));
    EXPECT_EQ("", ShippedShaderOfFile("Nope"));
}

} // namespace limn::test
