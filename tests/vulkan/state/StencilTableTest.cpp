#include "state/StateTable.h"

namespace limn::test
{
namespace
{

TEST(StateTable, TranslatesStencilNumbers)
{
    ExpectTable({{"Stencil { }", {{"stencilTest", 1}}},
                 {"Stencil { Ref 5 }", BothFaces({{"reference", 5}})},
                 {"Stencil { Ref 255 }", BothFaces({{"reference", 255}})},
                 {"Stencil { ReadMask 15 }", BothFaces({{"compareMask", 15}})},
                 {"Stencil { WriteMask 0 }", BothFaces({{"writeMask", 0}})}});
    for (const auto& [command, name] : std::map<std::string, std::string>{
             {"Ref", "reference"}, {"ReadMask", "compareMask"}, {"WriteMask", "writeMask"}})
    {
        EXPECT_EQ("", Mistakes(BothFaces({{name, 200}}),
                               StateOf(PassWith("Stencil { " + command + " [_P] }"), 200.0f)))
            << command;
    }
}

TEST(StateTable, TranslatesEveryStencilComparisonOnEveryFace)
{
    // In the order of Unity's numbers; nothing is reversed here.
    constexpr VkCompareOp compares[] = {VK_COMPARE_OP_ALWAYS,        VK_COMPARE_OP_NEVER,
                                        VK_COMPARE_OP_LESS,          VK_COMPARE_OP_EQUAL,
                                        VK_COMPARE_OP_LESS_OR_EQUAL, VK_COMPARE_OP_GREATER,
                                        VK_COMPARE_OP_NOT_EQUAL,     VK_COMPARE_OP_GREATER_OR_EQUAL,
                                        VK_COMPARE_OP_ALWAYS};
    constexpr const char* names[] = {"",        "Never",    "Less",   "Equal", "LEqual",
                                     "Greater", "NotEqual", "GEqual", "Always"};
    for (std::size_t i = 0; i < std::size(compares); ++i)
    {
        const double op = compares[i];
        const std::string name = names[i];
        const VulkanValues both = BothFaces({{"compareOp", op}});
        EXPECT_EQ("",
                  Mistakes(both, StateOf(PassWith("Stencil { Comp [_P] }"), static_cast<float>(i))))
            << i;
        if (!name.empty()) // Disabled has a number only
        {
            ExpectTable({{"Stencil { Comp " + name + " }", both},
                         {"Stencil { CompFront " + name + " }",
                          {{"stencilTest", 1}, {"front.compareOp", op}}},
                         {"Stencil { CompBack " + name + " }",
                          {{"stencilTest", 1}, {"back.compareOp", op}}}});
        }
    }
}

TEST(StateTable, TranslatesEveryStencilOperationOnEveryFace)
{
    constexpr VkStencilOp ops[] = {
        VK_STENCIL_OP_KEEP,
        VK_STENCIL_OP_ZERO,
        VK_STENCIL_OP_REPLACE,
        VK_STENCIL_OP_INCREMENT_AND_CLAMP,
        VK_STENCIL_OP_DECREMENT_AND_CLAMP,
        VK_STENCIL_OP_INVERT,
        VK_STENCIL_OP_INCREMENT_AND_WRAP,
        VK_STENCIL_OP_DECREMENT_AND_WRAP,
    };
    constexpr const char* names[] = {"Keep",    "Zero",   "Replace",  "IncrSat",
                                     "DecrSat", "Invert", "IncrWrap", "DecrWrap"};
    const std::map<std::string, std::string> commands = {
        {"Pass", "passOp"}, {"Fail", "failOp"}, {"ZFail", "depthFailOp"}};
    for (std::size_t i = 0; i < std::size(ops); ++i)
    {
        for (const auto& [command, field] : commands)
        {
            const double op = ops[i];
            const std::string name = names[i];
            ExpectTable({{"Stencil { " + command + " " + name + " }", BothFaces({{field, op}})},
                         {"Stencil { " + command + "Front " + name + " }",
                          {{"stencilTest", 1}, {"front." + field, op}}},
                         {"Stencil { " + command + "Back " + name + " }",
                          {{"stencilTest", 1}, {"back." + field, op}}}});
            EXPECT_EQ("", Mistakes(BothFaces({{field, op}}),
                                   StateOf(PassWith("Stencil { " + command + " [_P] }"),
                                           static_cast<float>(i))))
                << command << " " << i;
        }
    }
}

} // namespace
} // namespace limn::test
