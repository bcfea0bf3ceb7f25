#pragma once

#include <spirv-tools/libspirv.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace limn::test
{

/// What the validator of Khronos says for Vulkan 1.3 with scalarBlockLayout, "" = valid.
inline std::string ValidationMessages(const std::vector<std::uint32_t>& spirv)
{
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    std::string messages;
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&,
                                 const char* message) { messages.append(message).append("\n"); });
    spvtools::ValidatorOptions options;
    options.SetScalarBlockLayout(true);
    return tools.Validate(spirv.data(), spirv.size(), options) ? "" : "invalid: " + messages;
}

/// SPIR-V as text with names in the place of numbers.
inline std::string Disassemble(const std::vector<std::uint32_t>& spirv)
{
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    std::string text;
    tools.Disassemble(spirv, &text,
                      SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES |
                          SPV_BINARY_TO_TEXT_OPTION_NO_HEADER);
    return text;
}

} // namespace limn::test
