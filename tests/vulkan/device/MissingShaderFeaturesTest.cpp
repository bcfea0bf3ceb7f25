#include "Mentions.h"

#include <device/DeviceFeatures.h>
#include <gmock/gmock.h>

namespace limn::test
{

namespace
{

using testing::ElementsAre;
using vulkan::FeatureChain;
using vulkan::MissingShaderFeatures;
using vulkan::OptionalExtensions;

constexpr VkSubgroupFeatureFlags k_AllOperations =
    VK_SUBGROUP_FEATURE_BASIC_BIT | VK_SUBGROUP_FEATURE_VOTE_BIT | VK_SUBGROUP_FEATURE_BALLOT_BIT |
    VK_SUBGROUP_FEATURE_ARITHMETIC_BIT | VK_SUBGROUP_FEATURE_QUAD_BIT |
    VK_SUBGROUP_FEATURE_PARTITIONED_BIT_NV;

VkPhysicalDeviceLimits LargeLimits()
{
    VkPhysicalDeviceLimits limits{};
    limits.maxVertexOutputComponents = 128;
    limits.maxFragmentInputComponents = 128;
    limits.maxColorAttachments = 8;
    return limits;
}

/// Sets all that a shader can require.
void OfferAll(FeatureChain& chain)
{
    VkPhysicalDeviceFeatures& core = chain.core.features;
    core.geometryShader = core.tessellationShader = core.imageCubeArray = VK_TRUE;
    core.fragmentStoresAndAtomics = core.shaderInt16 = core.shaderInt64 = VK_TRUE;
    core.shaderStorageImageWriteWithoutFormat = VK_TRUE;
    chain.v12.scalarBlockLayout = VK_TRUE;
    chain.v12.shaderFloat16 = chain.v12.shaderOutputLayer = VK_TRUE;
    chain.v12.shaderBufferInt64Atomics = chain.v12.shaderSharedInt64Atomics = VK_TRUE;
}

/// What is missing, without "barycentrics", which limn never asks a device for.
std::vector<std::string> Missing(const FeatureChain& chain,
                                 const VkPhysicalDeviceLimits& limits = LargeLimits(),
                                 VkSubgroupFeatureFlags fragments = k_AllOperations,
                                 VkSubgroupFeatureFlags kernels = k_AllOperations)
{
    std::vector<std::string> missing = MissingShaderFeatures(chain, limits, fragments, kernels);
    EXPECT_EQ(1, std::erase(missing, "barycentrics"));
    return missing;
}

} // namespace

TEST(MissingShaderFeatures, AreNoneOfAFullDevice)
{
    FeatureChain chain{OptionalExtensions{}};
    OfferAll(chain);
    EXPECT_THAT(Missing(chain), ElementsAre());
}

TEST(MissingShaderFeatures, AreAllOfABareDevice)
{
    const FeatureChain chain{OptionalExtensions{}};
    VkPhysicalDeviceLimits least{}; // what Vulkan 1.3 guarantees
    least.maxVertexOutputComponents = 64;
    least.maxFragmentInputComponents = 64;
    least.maxColorAttachments = 4;
    EXPECT_THAT(Missing(chain, least, 0),
                ElementsAre("compute", "cubearray", "geometry", "int64bufferatomics",
                            "int64groupsharedatomics", "interpolators32", "mrt8", "native16bit",
                            "quadshuffle", "randomwrite", "scalarblocklayout",
                            "setrtarrayindexfromanyshader", "tessellation", "tesshw", "uav",
                            "waveballot", "wavebasic", "wavemath", "wavemultiprefix", "wavevote"));
}

TEST(MissingShaderFeatures, FollowEachFeatureOfTheDevice)
{
    using Core = VkPhysicalDeviceFeatures;
    const std::pair<VkBool32 Core::*, std::vector<std::string>> cases[] = {
        {&Core::shaderStorageImageWriteWithoutFormat, {"compute"}},
        {&Core::geometryShader, {"geometry"}},
        {&Core::tessellationShader, {"tessellation", "tesshw"}},
        {&Core::imageCubeArray, {"cubearray"}},
        {&Core::fragmentStoresAndAtomics, {"randomwrite", "uav"}},
        {&Core::shaderInt16, {"native16bit"}},
        {&Core::shaderInt64, {"int64bufferatomics", "int64groupsharedatomics"}}};
    for (const auto& [feature, names] : cases)
    {
        FeatureChain chain{OptionalExtensions{}};
        OfferAll(chain);
        chain.core.features.*feature = VK_FALSE;
        EXPECT_EQ(names, Missing(chain));
    }
    using V12 = VkPhysicalDeviceVulkan12Features;
    const std::pair<VkBool32 V12::*, std::vector<std::string>> cases12[] = {
        {&V12::scalarBlockLayout, {"compute", "scalarblocklayout"}},
        {&V12::shaderFloat16, {"native16bit"}},
        {&V12::shaderOutputLayer, {"setrtarrayindexfromanyshader"}},
        {&V12::shaderBufferInt64Atomics, {"int64bufferatomics"}},
        {&V12::shaderSharedInt64Atomics, {"int64groupsharedatomics"}}};
    for (const auto& [feature, names] : cases12)
    {
        FeatureChain chain{OptionalExtensions{}};
        OfferAll(chain);
        chain.v12.*feature = VK_FALSE;
        EXPECT_EQ(names, Missing(chain));
    }
}

TEST(MissingShaderFeatures, FollowLimitsAndSubgroups)
{
    FeatureChain chain{OptionalExtensions{}};
    OfferAll(chain);
    VkPhysicalDeviceLimits limits = LargeLimits();
    limits.maxFragmentInputComponents = 127;
    EXPECT_THAT(Missing(chain, limits), ElementsAre("interpolators32"));
    limits = LargeLimits();
    limits.maxColorAttachments = 7;
    EXPECT_THAT(Missing(chain, limits), ElementsAre("mrt8"));
    EXPECT_THAT(
        Missing(chain, LargeLimits(), VK_SUBGROUP_FEATURE_BASIC_BIT),
        ElementsAre("quadshuffle", "waveballot", "wavemath", "wavemultiprefix", "wavevote"));
    EXPECT_THAT(Missing(chain, LargeLimits(), k_AllOperations,
                        k_AllOperations & ~VkFlags{VK_SUBGROUP_FEATURE_VOTE_BIT}),
                ElementsAre("compute wavevote"));
}

TEST(MissingShaderFeatures, WhatADeviceOffersAndShadersMayRequireIsEnabled)
{
    FeatureChain offered{OptionalExtensions{}};
    OfferAll(offered);
    FeatureChain wanted{OptionalExtensions{}};
    vulkan::ChooseFeatures(offered, wanted);
    EXPECT_THAT(Missing(wanted), ElementsAre());
}

TEST(Lacks, NameEachFeatureExtensionAndLimitAndWhatItCosts)
{
    FeatureChain bare{OptionalExtensions{}};
    VkPhysicalDeviceLimits limits{};
    const auto sentences = vulkan::Lacks(bare, {}, limits);
    EXPECT_THAT(sentences,
                testing::Each(testing::MatchesRegex("(it has no [A-Za-z0-9_]+|.* is 0): .+")));
    EXPECT_THAT(sentences, testing::Contains(Mentions("no geometryShader", "geometry functions",
                                                      "SV_PrimitiveID")));
    bare.core.features.geometryShader = VK_TRUE;
    EXPECT_EQ(sentences.size() - 1, vulkan::Lacks(bare, {}, limits).size());
    limits.maxPerStageDescriptorSampledImages = 16;
    EXPECT_THAT(vulkan::Lacks(bare, {.conservative = true}, limits),
                testing::AllOf(testing::SizeIs(sentences.size() - 2),
                               testing::Contains(Mentions(
                                   "maxPerStageDescriptorSampledImages is 16", "16 textures"))));
}

} // namespace limn::test
