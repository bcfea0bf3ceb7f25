#include <limn/core/DrawingSettings.h>
#include <limn/shaderlab/ShaderLabDocument.h>

namespace limn
{

const std::vector<ShaderTagId>& ForwardShaderTags()
{
    static const std::vector<ShaderTagId> tags{ShaderTagId(k_DefaultLightMode),
                                               ShaderTagId("UniversalForward"),
                                               ShaderTagId("UniversalForwardOnly")};
    return tags;
}

void DrawingSettings::SetShaderPassName(int index, ShaderTagId tag)
{
    if (index < 0 || index >= maxShaderPasses)
    {
        throw ContractError("shader pass name index " + std::to_string(index) +
                            " is outside 0...15");
    }
    const auto slot = static_cast<std::size_t>(index);
    if (shaderTagIds.size() <= slot)
    {
        shaderTagIds.resize(slot + 1);
    }
    shaderTagIds[slot] = tag;
}

} // namespace limn
