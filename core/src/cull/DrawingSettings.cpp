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

namespace
{

std::size_t SlotOf(int index)
{
    if (index < 0 || index >= DrawingSettings::maxShaderPasses)
    {
        throw ContractError("shader pass name index " + std::to_string(index) +
                            " is outside 0...15");
    }
    return static_cast<std::size_t>(index);
}

} // namespace

ShaderTagId DrawingSettings::GetShaderPassName(int index) const
{
    const std::size_t slot = SlotOf(index);
    return slot < shaderTagIds.size() ? shaderTagIds[slot] : ShaderTagId();
}

void DrawingSettings::SetShaderPassName(int index, ShaderTagId tag)
{
    const std::size_t slot = SlotOf(index);
    if (shaderTagIds.size() <= slot)
    {
        shaderTagIds.resize(slot + 1);
    }
    shaderTagIds[slot] = tag;
}

} // namespace limn
