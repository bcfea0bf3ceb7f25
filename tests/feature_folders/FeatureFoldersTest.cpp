#include <gtest/gtest.h>
#include <limn/features/AllFeatures.h> // of the folders of this test
#include <limn/features/FeatureRegistry.h>
#include <limn/shaderlab/ShaderDatabase.h>
#include <limn/volume/VolumeComponentRegistry.h>

namespace limn
{

void RegisterFoldersOfTest(FeatureRegistry& features, VolumeComponentRegistry& components);

namespace embedded
{
std::span<const EmbeddedFile> ShadersOfTest();
}

namespace test
{

TEST(FeatureFolders, RegisterWhatTheyHoldWithoutAnEditElsewhere)
{
    FeatureRegistry features;
    VolumeComponentRegistry components;
    RegisterFoldersOfTest(features, components);
    EXPECT_EQ((std::vector<std::string_view>{"GlowFeature"}), features.names());
    EXPECT_NE(nullptr, dynamic_cast<GlowFeature*>(features.Create("GlowFeature").get()));
    EXPECT_NE(nullptr, dynamic_cast<Glow*>(components.Create("Glow").get()));
    ASSERT_EQ(1u, features.techniques().size());
    EXPECT_EQ("GlowFeature", features.techniques().front().feature);
}

TEST(FeatureFolders, BringTheirShadersUnderTheNamesInTheFiles)
{
    ShaderDatabase shaders;
    shaders.Add(embedded::ShadersOfTest());
    EXPECT_EQ((std::vector<std::string_view>{"Test/Glow", "Test/Plain"}), shaders.names());
}

} // namespace test

} // namespace limn
