#include "frame/TextureHistory.h"

#include <algorithm>

namespace limn
{

void ForgetContents(TextureStates& states)
{
    for (auto& [id, state] : states.textures)
    {
        const auto texture = std::static_pointer_cast<const RenderTexture>(state.texture.lock());
        if (texture && !OutlivesFrame(*texture, states))
        {
            state.isFilled = false;
            state.isPending = false;
            state.constant.flags = ClearFlag::None;
        }
    }
}

bool OutlivesFrame(const RenderTexture& texture, const TextureStates& states)
{
    return !states.isLast && (!texture.isTransient() ||
                              std::ranges::find(states.held, texture.id()) != states.held.end());
}

} // namespace limn
