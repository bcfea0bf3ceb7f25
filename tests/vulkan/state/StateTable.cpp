#include "state/StateTable.h"

#include <device/Translate.h>
#include <frame/DynamicState.h>
#include <programs/ProgramPool.h>
#include <resolve/DrawResolver.h>

namespace limn::test
{

using namespace vulkan;

namespace
{

void AddStencilFace(VulkanValues& values, const std::string& face, const VkStencilOpState& state)
{
    values[face + ".failOp"] = state.failOp;
    values[face + ".passOp"] = state.passOp;
    values[face + ".depthFailOp"] = state.depthFailOp;
    values[face + ".compareOp"] = state.compareOp;
    values[face + ".compareMask"] = state.compareMask;
    values[face + ".writeMask"] = state.writeMask;
    values[face + ".reference"] = state.reference;
}

void AddTarget(VulkanValues& values, const std::string& target,
               const VkPipelineColorBlendAttachmentState& state)
{
    values[target + ".blendEnable"] = state.blendEnable;
    values[target + ".srcColor"] = state.srcColorBlendFactor;
    values[target + ".dstColor"] = state.dstColorBlendFactor;
    values[target + ".colorOp"] = state.colorBlendOp;
    values[target + ".srcAlpha"] = state.srcAlphaBlendFactor;
    values[target + ".dstAlpha"] = state.dstAlphaBlendFactor;
    values[target + ".alphaOp"] = state.alphaBlendOp;
    values[target + ".writeMask"] = state.colorWriteMask;
}

VulkanValues ToValues(const PipelineState& state, const TargetFormats& formats)
{
    DeviceCapabilities capabilities;
    capabilities.features.depthClamp = VK_TRUE;
    capabilities.features.logicOp = VK_TRUE;
    capabilities.conservative = true;
    capabilities.advancedBlendTargets = 8;
    const PipelineKey key = MakePipelineKey(state, formats, capabilities);
    const FixedState fixed = ToFixedState(state, formats);
    VulkanValues values = {{"cullMode", fixed.cullMode},
                           {"frontFace", fixed.frontFace},
                           {"depthTest", fixed.depthTest},
                           {"depthWrite", fixed.depthWrite},
                           {"depthCompare", fixed.depthCompare},
                           {"depthBias", fixed.depthBias},
                           {"depthBiasConstant", fixed.depthBiasConstant},
                           {"depthBiasSlope", fixed.depthBiasSlope},
                           {"depthClamp", key.depthClamp},
                           {"alphaToCoverage", key.alphaToMask},
                           {"conservative", key.conservative},
                           {"logicOp", key.logicOp ? static_cast<int>(*key.logicOp) : -1},
                           {"stencilTest", fixed.stencilTest}};
    AddStencilFace(values, "front", fixed.stencilFront);
    AddStencilFace(values, "back", fixed.stencilBack);
    for (std::size_t i = 0; i < state.targets.size(); ++i)
    {
        AddTarget(values, std::to_string(i), ToBlendAttachment(state.targets.at(i), i, 8));
    }
    return values;
}

/// What a pass without a command does.
VulkanValues Defaults()
{
    VulkanValues values = {{"cullMode", VK_CULL_MODE_BACK_BIT},
                           {"frontFace", VK_FRONT_FACE_CLOCKWISE},
                           {"depthTest", 1},
                           {"depthWrite", 1},
                           {"depthCompare", VK_COMPARE_OP_GREATER_OR_EQUAL},
                           {"depthBias", 0},
                           {"depthBiasConstant", 0},
                           {"depthBiasSlope", 0},
                           {"depthClamp", 0},
                           {"alphaToCoverage", 0},
                           {"conservative", VK_CONSERVATIVE_RASTERIZATION_MODE_DISABLED_EXT},
                           {"logicOp", -1}, // none
                           {"stencilTest", 0}};
    for (const char* face : {"front", "back"})
    {
        AddStencilFace(values, face,
                       {VK_STENCIL_OP_KEEP, VK_STENCIL_OP_KEEP, VK_STENCIL_OP_KEEP,
                        VK_COMPARE_OP_ALWAYS, 255, 255, 0});
    }
    for (int i = 0; i < 8; ++i)
    {
        AddTarget(values, std::to_string(i),
                  {VK_FALSE, VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ZERO, VK_BLEND_OP_ADD,
                   VK_BLEND_FACTOR_ONE, VK_BLEND_FACTOR_ZERO, VK_BLEND_OP_ADD, 0xF});
    }
    return values;
}

} // namespace

TargetFormats AllTargets()
{
    TargetFormats formats;
    formats.colors.resize(8);
    std::ranges::fill(formats.colors, VK_FORMAT_R8G8B8A8_UNORM);
    formats.depth = VK_FORMAT_D32_SFLOAT_S8_UINT;
    formats.stencil = VK_FORMAT_D32_SFLOAT_S8_UINT;
    return formats;
}

VulkanValues EveryTarget(const VulkanValues& differences)
{
    VulkanValues values;
    for (const auto& [name, value] : differences)
    {
        for (int i = 0; i < 8; ++i)
        {
            values[std::to_string(i) + "." + name] = value;
        }
    }
    return values;
}

VulkanValues BothFaces(const VulkanValues& differences)
{
    VulkanValues values = {{"stencilTest", 1}};
    for (const auto& [name, value] : differences)
    {
        values["front." + name] = value;
        values["back." + name] = value;
    }
    return values;
}

std::string Mistakes(const VulkanValues& differences, const VulkanValues& actual)
{
    VulkanValues expected = Defaults();
    for (const auto& [name, value] : differences)
    {
        expected[name] = value;
    }
    std::string text;
    for (const auto& [name, value] : actual)
    {
        if (value != expected[name])
        {
            text += name + ": " + std::to_string(value) + " instead of " +
                    std::to_string(expected[name]) + "\n";
        }
    }
    return expected.size() == actual.size() ? text : text + "the names differ\n";
}

std::string PassWith(const std::string& commands)
{
    return "SubShader { Pass { " + commands + " } }";
}

VulkanValues StateOf(const std::string& subShaders, float property, int pass,
                     const TargetFormats& formats)
{
    const Material material(
        ShaderOf("Shader \"T\" { Properties { _P (\"\", Float) = 0 } " + subShaders + " }"), "M");
    Material changed = material;
    changed.SetFloat(ShaderPropertyId("_P"), property);
    return ToValues(ResolveState(changed.shader()->passState(pass), changed, {}), formats);
}

void ExpectTable(const std::vector<StateRow>& rows)
{
    for (const StateRow& row : rows)
    {
        EXPECT_EQ("", Mistakes(row.differences, StateOf(PassWith(row.commands)))) << row.commands;
    }
}

void ExpectNumbers(const std::string& command, const std::vector<VulkanValues>& expected)
{
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        EXPECT_EQ("", Mistakes(expected[i], StateOf(PassWith(command), static_cast<float>(i))))
            << command << " with " << i;
    }
}

} // namespace limn::test
