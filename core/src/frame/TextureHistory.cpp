#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

TextureState& StateOf(TextureStates& states, const std::shared_ptr<const Texture>& texture)
{
    TextureState& state = states.textures[texture->id()];
    state.texture = texture;
    return state;
}

const TextureState* FindState(const TextureStates& states, const Texture& texture)
{
    const auto found = states.textures.find(texture.id());
    return found == states.textures.end() ? nullptr : &found->second;
}

bool Contains(OutputSpan outputs, const RenderTexture& texture)
{
    return std::ranges::find(outputs, &texture, &std::shared_ptr<const RenderTexture>::get) !=
           outputs.end();
}

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
