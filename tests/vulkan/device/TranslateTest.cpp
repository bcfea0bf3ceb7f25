#include "core/ThrownMessage.h"
#include <cctype>
#include <device/Translate.h>
#include <frame/PassTargets.h>
#include <limits>
#include <vulkan/vulkan.hpp>

namespace limn::test
{

using namespace limn::vulkan;

TEST(Translate, TurnsDepthComparesForReversedDepth)
{
    EXPECT_EQ(VK_COMPARE_OP_GREATER, ToReversedDepthCompare(CompareFunction::Less));
    EXPECT_EQ(VK_COMPARE_OP_GREATER_OR_EQUAL, ToReversedDepthCompare(CompareFunction::LessEqual));
    EXPECT_EQ(VK_COMPARE_OP_LESS, ToReversedDepthCompare(CompareFunction::Greater));
    EXPECT_EQ(VK_COMPARE_OP_LESS_OR_EQUAL, ToReversedDepthCompare(CompareFunction::GreaterEqual));
    EXPECT_EQ(VK_COMPARE_OP_EQUAL, ToReversedDepthCompare(CompareFunction::Equal));
    EXPECT_EQ(VK_COMPARE_OP_NOT_EQUAL, ToReversedDepthCompare(CompareFunction::NotEqual));
    EXPECT_EQ(VK_COMPARE_OP_NEVER, ToReversedDepthCompare(CompareFunction::Never));
    EXPECT_EQ(VK_COMPARE_OP_ALWAYS, ToReversedDepthCompare(CompareFunction::Always));
    EXPECT_EQ(VK_COMPARE_OP_ALWAYS, ToReversedDepthCompare(CompareFunction::Disabled));
}

TEST(Translate, KeepsStencilComparesAsTheyAre)
{
    EXPECT_EQ(VK_COMPARE_OP_LESS, ToStencilCompare(CompareFunction::Less));
    EXPECT_EQ(VK_COMPARE_OP_GREATER_OR_EQUAL, ToStencilCompare(CompareFunction::GreaterEqual));
}

TEST(Translate, KeepsTheOrderOfMaskBitsApart)
{
    // Unity's red is its highest bit, Vulkan's the lowest.
    EXPECT_EQ(VkColorComponentFlags{VK_COLOR_COMPONENT_R_BIT}, ToVkColorMask(8));
    EXPECT_EQ(VkColorComponentFlags{VK_COLOR_COMPONENT_G_BIT}, ToVkColorMask(4));
    EXPECT_EQ(VkColorComponentFlags{VK_COLOR_COMPONENT_B_BIT}, ToVkColorMask(2));
    EXPECT_EQ(VkColorComponentFlags{VK_COLOR_COMPONENT_A_BIT}, ToVkColorMask(1));
    EXPECT_EQ(VkColorComponentFlags{0xF}, ToVkColorMask(15));
}

/// Returns the letters and digits of a format's name in lower case, which Unity and Vulkan's C++
/// names have in common.
std::string Plain(const std::string& name)
{
    std::string plain;
    for (const char c : name)
    {
        plain += c == '_' ? "" : std::string(1, static_cast<char>(std::tolower(c)));
    }
    return plain;
}

TEST(Translate, GivesEachFormatTheVulkanFormatOfItsName)
{
    int known = 0;
    for (int i = 1; i <= static_cast<int>(GraphicsFormat::D16_UNorm_S8_UInt); ++i)
    {
        const auto format = static_cast<GraphicsFormat>(i);
        try
        {
            const auto vulkan = static_cast<vk::Format>(ToVkFormat(format));
            EXPECT_EQ(Plain(vk::to_string(vulkan)), Plain(limn::ToString(format)));
            ++known;
        }
        catch (const ContractError&)
        {
            continue; // no texture is made of it
        }
    }
    EXPECT_EQ(52 + 25 + 2, known);
}

TEST(Translate, KnowsEveryBlendFactor)
{
    const VkBlendFactor expected[] = {
        VK_BLEND_FACTOR_ZERO,
        VK_BLEND_FACTOR_ONE,
        VK_BLEND_FACTOR_DST_COLOR,
        VK_BLEND_FACTOR_SRC_COLOR,
        VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR,
        VK_BLEND_FACTOR_SRC_ALPHA,
        VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR,
        VK_BLEND_FACTOR_DST_ALPHA,
        VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA,
        VK_BLEND_FACTOR_SRC_ALPHA_SATURATE,
        VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
    };
    for (int i = 0; i < 11; ++i)
    {
        EXPECT_EQ(expected[i], ToVkBlendFactor(static_cast<BlendMode>(i))) << "Unity's " << i;
    }
}

TEST(Translate, RefusesANumberThatIsNoBlendMode)
{
    EXPECT_EQ("BlendMode has no value 11",
              ThrownMessage<ContractError>([] { ToVkBlendFactor(static_cast<BlendMode>(11)); }));
}

TEST(Translate, WaitsForEverythingBeforeUndefinedContents)
{
    const UsageScope scope = ToUsageScope(TextureUsage::Undefined);
    EXPECT_EQ(VK_IMAGE_LAYOUT_UNDEFINED, scope.layout);
    EXPECT_EQ(VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, scope.stages);
}

TEST(Translate, WaitsInEveryStageThatMaySample)
{
    const VkPipelineStageFlags2 stages = ToUsageScope(TextureUsage::ShaderRead).stages;
    // The first of the two stands for all stages before it, geometry where there is one.
    EXPECT_EQ(VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT |
                  VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              stages);
}

TEST(Translate, PutsTheViewportsTopAtClipSpaceUp)
{
    const VkViewport viewport = ToVkViewport({10, 20, 30, 40});
    EXPECT_EQ(10.0f, viewport.x);
    EXPECT_EQ(60.0f, viewport.y);
    EXPECT_EQ(30.0f, viewport.width);
    EXPECT_EQ(-40.0f, viewport.height);
    EXPECT_EQ(0.0f, viewport.minDepth);
    EXPECT_EQ(1.0f, viewport.maxDepth);
}

TEST(Translate, ClipsAViewportToThePass)
{
    const VkRect2D rect = ClipTo({{0, 0}, {100, 50}}, {-10, 40, 30, 40});
    EXPECT_EQ(0, rect.offset.x);
    EXPECT_EQ(40, rect.offset.y);
    EXPECT_EQ(20u, rect.extent.width);
    EXPECT_EQ(10u, rect.extent.height);
}

TEST(Translate, TakesAViewportThatEndsBeyondTheLargestInt)
{
    constexpr int k_Most = std::numeric_limits<int>::max();
    const VkRect2D rect = ClipTo({{0, 0}, {100, 50}}, {10, 20, k_Most, k_Most});
    EXPECT_EQ(10, rect.offset.x);
    EXPECT_EQ(20, rect.offset.y);
    EXPECT_EQ(90u, rect.extent.width);
    EXPECT_EQ(30u, rect.extent.height);
    EXPECT_EQ(2147483648.0f, ToVkViewport({10, 20, k_Most, k_Most}).y); // the next float to the sum
}

TEST(Translate, CountsTicksByTheirValidBits)
{
    EXPECT_EQ(5u, ElapsedTicks(10, 15, 64));
    EXPECT_EQ(5u, ElapsedTicks(10, 15, 36));
    // A counter of 36 bits that began again at 0 in between.
    EXPECT_EQ(7u, ElapsedTicks((std::uint64_t{1} << 36) - 3, 4, 36));
    // What stands above the valid bits means nothing.
    EXPECT_EQ(5u, ElapsedTicks(0xABC000000000000A, 0x123000000000000F, 36));
    EXPECT_EQ(1u, ElapsedTicks(~std::uint64_t{0}, 0, 64));
    EXPECT_EQ(1u, ElapsedTicks(1, 0, 1));
}

} // namespace limn::test
