#include "Mentions.h"
#include "core/ThrownMessage.h"
#include <device/DeviceFeatures.h>
#include <gmock/gmock.h>
#include <limn/core/DrawError.h>

namespace limn::test
{

using vulkan::FeatureChain;
using vulkan::MissingCapabilities;
using vulkan::MissingCapability;
using vulkan::OptionalExtensions;
using vulkan::RequireCapabilities;
using vulkan::SubgroupOperations;

namespace
{

// The numbers are those of the SPIR-V specification, 3.31.
constexpr std::uint32_t k_Shader = 1;
constexpr std::uint32_t k_Geometry = 2;
constexpr std::uint32_t k_Float16 = 9;
constexpr std::uint32_t k_Quad = 68;

std::vector<std::uint32_t> Module(const std::vector<std::uint32_t>& capabilities)
{
    std::vector<std::uint32_t> words = {0x07230203, 0x00010300, 0, 1, 0};
    for (const std::uint32_t capability : capabilities)
    {
        words.push_back(2u << 16 | 17u); // OpCapability
        words.push_back(capability);
    }
    return words;
}

bool Takes(const std::vector<MissingCapability>& missing, std::uint32_t capability)
{
    return std::ranges::find(missing, capability, &MissingCapability::capability) == missing.end();
}

} // namespace

TEST(SpirvNeeds, FollowTheFeaturesThatAreEnabled)
{
    FeatureChain chain{OptionalExtensions{}};
    EXPECT_FALSE(Takes(MissingCapabilities(chain, 0), k_Geometry));
    EXPECT_FALSE(Takes(MissingCapabilities(chain, 0), k_Quad));
    EXPECT_TRUE(Takes(MissingCapabilities(chain, 0), k_Shader));
    chain.core.features.geometryShader = VK_TRUE;
    const auto some = MissingCapabilities(chain, VK_SUBGROUP_FEATURE_QUAD_BIT);
    EXPECT_TRUE(Takes(some, k_Geometry));
    EXPECT_TRUE(Takes(some, k_Quad));
    EXPECT_FALSE(Takes(some, k_Float16));
}

TEST(SpirvNeeds, OfWaveOperationsAreThoseOfTheStageThatUsesThem)
{
    VkPhysicalDeviceSubgroupProperties device{};
    device.supportedStages = VK_SHADER_STAGE_COMPUTE_BIT | VK_SHADER_STAGE_VERTEX_BIT;
    device.supportedOperations = VK_SUBGROUP_FEATURE_BASIC_BIT | VK_SUBGROUP_FEATURE_QUAD_BIT;
    EXPECT_EQ(SubgroupOperations(device, VK_SHADER_STAGE_COMPUTE_BIT), device.supportedOperations);
    EXPECT_EQ(SubgroupOperations(device, VK_SHADER_STAGE_FRAGMENT_BIT), 0u);
    EXPECT_EQ(SubgroupOperations(device, VK_SHADER_STAGE_VERTEX_BIT),
              VkFlags{VK_SUBGROUP_FEATURE_BASIC_BIT})
        << "without quads, which its stage need not have";
    device.quadOperationsInAllStages = VK_TRUE;
    EXPECT_EQ(SubgroupOperations(device, VK_SHADER_STAGE_VERTEX_BIT), device.supportedOperations);
}

TEST(SpirvNeeds, AreNamedBeforeTheDriverIsGivenTheModule)
{
    FeatureChain chain{OptionalExtensions{}};
    const auto missing = MissingCapabilities(chain, 0);
    EXPECT_NO_THROW(RequireCapabilities(Module({k_Shader}), missing));
    EXPECT_NO_THROW(RequireCapabilities(Module({k_Geometry}), {}));
    EXPECT_THAT(ThrownMessage<DrawError>(
                    [&] {
                        RequireCapabilities(Module({k_Shader, k_Float16}), missing);
                    }),
                Mentions("shaderFloat16", "device lacks", "missingShaderFeatures()"));
}

} // namespace limn::test
