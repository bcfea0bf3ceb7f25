#include "spirv/SpirvInstructions.h"

#include <limn/base/Diagnostic.h>
#include <spirv-tools/libspirv.h>

namespace limn
{

std::vector<SpirvInstruction> ParseSpirv(const SpirvWords& spirv)
{
    std::vector<SpirvInstruction> instructions;
    const auto take = [](void* to, const spv_parsed_instruction_t* parsed)
    {
        SpirvInstruction instruction{parsed->opcode,
                                     parsed->type_id,
                                     parsed->result_id,
                                     {parsed->words, parsed->words + parsed->num_words},
                                     {}};
        for (std::size_t i = 0; i < parsed->num_operands; ++i)
        {
            const spv_parsed_operand_t& operand = parsed->operands[i];
            if (operand.type == SPV_OPERAND_TYPE_ID)
            {
                instruction.operands.push_back(operand.offset);
            }
        }
        static_cast<std::vector<SpirvInstruction>*>(to)->push_back(std::move(instruction));
        return SPV_SUCCESS;
    };
    const spv_context context = spvContextCreate(SPV_ENV_VULKAN_1_1);
    const spv_result_t result =
        spvBinaryParse(context, &instructions, spirv.data(), spirv.size(), nullptr, take, nullptr);
    spvContextDestroy(context);
    if (result != SPV_SUCCESS)
    {
        throw ContractError("the HLSL compiler's SPIR-V cannot be read");
    }
    return instructions;
}

} // namespace limn
