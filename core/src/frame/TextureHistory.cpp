#include "frame/TextureHistory.h"

#include <unordered_set>

namespace limn
{

namespace
{

/// Takes a frame's accesses in their order; the first of each texture counts.
class HistoryLearner
{
public:
    explicit HistoryLearner(CompiledFrame& frame) : m_Frame(frame) {}

    void Read(const std::shared_ptr<const Texture>& texture)
    {
        m_Consumed.insert(texture->id());
        if (!m_Seen.insert(texture->id()).second)
        {
            return;
        }
        TextureState& state = StateOf(texture);
        if (!state.isFilled && !state.isPending && state.history == TextureHistory::Overwritten)
        {
            m_Frame.notes.push_back("what the frame before left in '" + texture->name() +
                                    "' is read, but was not kept, because the frames before that "
                                    "had overwritten it first; it is kept from now on");
        }
        if (state.isFilled || state.isPending || state.history == TextureHistory::Overwritten)
        {
            state.history = TextureHistory::Read;
        }
    }

    /// Draws into what is there.
    void Change(const std::shared_ptr<const Texture>& texture)
    {
        Read(texture);
        m_Consumed.erase(texture->id());
    }

    void Overwrite(const std::shared_ptr<const Texture>& texture)
    {
        m_Consumed.erase(texture->id());
        if (m_Seen.insert(texture->id()).second)
        {
            StateOf(texture);
            overwritten.push_back(texture->id());
        }
    }

    /// Of what the frame overwrites and nobody used before, what it reads behind the last change
    /// is there for the frame itself: see LeaveOutUnread.
    void MarkConsumed()
    {
        for (const std::uint64_t id : overwritten)
        {
            TextureHistory& history = m_Frame.states.textures[id].history;
            if (history == TextureHistory::Unknown && m_Consumed.contains(id))
            {
                history = TextureHistory::Consumed;
            }
        }
    }

    std::vector<std::uint64_t> overwritten;

private:
    TextureState& StateOf(const std::shared_ptr<const Texture>& texture)
    {
        TextureState& state = m_Frame.states.textures[texture->id()];
        state.texture = texture;
        return state;
    }

    CompiledFrame& m_Frame;
    std::unordered_set<std::uint64_t> m_Seen;
    std::unordered_set<std::uint64_t> m_Consumed; ///< read since it was changed
};

} // namespace

std::vector<std::uint64_t> LearnHistory(const std::vector<FrameNode>& nodes, OutputSpan outputs,
                                        CompiledFrame& frame)
{
    HistoryLearner learner(frame);
    for (const FrameNode& node : nodes)
    {
        for (const auto& texture : node.reads)
        {
            learner.Read(texture);
        }
        for (const auto& target : TargetsOf(node))
        {
            if (Overwrites(node, *target))
            {
                learner.Overwrite(target);
            }
            else
            {
                learner.Change(target);
            }
        }
    }
    learner.MarkConsumed();
    for (const auto& output : outputs)
    {
        learner.Read(output);
    }
    return std::move(learner.overwritten);
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

void KeepNothing(TextureStates& states)
{
    for (auto& [id, state] : states.textures)
    {
        state.history = TextureHistory::Overwritten;
    }
}

void RememberOverwritten(std::span<const std::uint64_t> textures, TextureStates& states)
{
    for (const std::uint64_t id : textures)
    {
        TextureHistory& history = states.textures[id].history;
        history = history == TextureHistory::Unknown ? TextureHistory::Overwritten : history;
    }
}

bool OutlivesFrame(const RenderTexture& texture, const TextureStates& states)
{
    const auto found = states.textures.find(texture.id());
    return !texture.isTransient() &&
           (found == states.textures.end() || found->second.history != TextureHistory::Overwritten);
}

} // namespace limn
