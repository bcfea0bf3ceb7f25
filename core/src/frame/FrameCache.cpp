#include "frame/FrameNode.h"

#include <algorithm>
#include <atomic>
#include <limn/core/FrameCompiler.h>
#include <utility>

namespace limn
{

namespace
{

template <typename T>
bool AreSame(const std::shared_ptr<T>& a, const std::shared_ptr<T>& b)
{
    return a == b || (a && b && *a == *b);
}

bool AreSame(const DrawSetup& a, const DrawSetup& b)
{
    return a.program == b.program && a.shader == b.shader && a.shaderPass == b.shaderPass &&
           a.state == b.state && AreSame(a.bindings, b.bindings) &&
           AreSame(a.fullScreen, b.fullScreen);
}

bool AreSame(const TextureState& a, const TextureState& b)
{
    return !a.texture.expired() && a.usage == b.usage && a.isFilled == b.isFilled &&
           a.isPlaced == b.isPlaced && a.constant == b.constant && a.isPending == b.isPending &&
           a.readers == b.readers;
}

bool AreSame(const BufferState& a, const BufferState& b)
{
    return !a.buffer.expired() && a.isWritten == b.isWritten && a.visible == b.visible &&
           a.readers == b.readers;
}

bool AreSame(const DispatchSetup& a, const DispatchSetup& b)
{
    return a.program == b.program && a.shader == b.shader && a.kernel == b.kernel &&
           AreSame(a.bindings, b.bindings);
}

bool AreSame(const TextureStates::DepthTwin& a, const TextureStates::DepthTwin& b)
{
    return !a.original.expired() && a.texture == b.texture;
}

/// Returns whether both have the same elements, and all of them still exist.
template <typename Element>
bool AreSame(const std::unordered_map<std::uint64_t, Element>& now,
             const std::unordered_map<std::uint64_t, Element>& then)
{
    const auto isSame = [&](const auto& entry)
    {
        const auto other = then.find(entry.first);
        return other != then.end() && AreSame(entry.second, other->second);
    };
    return now.size() == then.size() && std::ranges::all_of(now, isSame);
}

/// The part of a target by which moving draws may leave the regions that a frame was compiled for.
constexpr double k_Margin = 1.0 / 32.0;

/// Returns whether a frame compiled for `kept` draws all that is seen in `now`, and hardly more.
bool Covers(const std::optional<TargetRegion>& kept, const std::optional<TargetRegion>& now)
{
    if (!kept || !now)
    {
        return kept == now;
    }
    // Nothing is drawn beyond the target's borders, however far it reaches.
    const auto coversSide = [](double outer, double inner)
    {
        return outer <= std::max(inner, 0.0) && (inner <= 0.0 || outer >= inner - 2.0 * k_Margin);
    };
    return coversSide(kept->left, now->left) && coversSide(kept->top, now->top) &&
           coversSide(1.0 - kept->right, 1.0 - now->right) &&
           coversSide(1.0 - kept->bottom, 1.0 - now->bottom);
}

/// Returns whether both are equal but for the regions of draws, of which `fits(kept, now)` decides.
template <typename Fits>
bool AreSame(std::span<const FrameCommand> now, std::span<const FrameCommand> kept,
             const Fits& fits)
{
    return std::ranges::equal(now, kept,
                              [&](const FrameCommand& a, const FrameCommand& b)
                              {
                                  if (a == b)
                                  {
                                      return true;
                                  }
                                  const auto* draw = std::get_if<DrawCommand>(&a);
                                  const auto* other = std::get_if<DrawCommand>(&b);
                                  if (draw == nullptr || other == nullptr ||
                                      !fits(other->bounds, draw->bounds))
                                  {
                                      return false;
                                  }
                                  DrawCommand same = *draw;
                                  same.bounds = other->bounds;
                                  return same == *other;
                              });
}

template <typename Change>
void ForEachRegion(std::span<FrameCommand> commands, const Change& change)
{
    for (FrameCommand& command : commands)
    {
        auto* draw = std::get_if<DrawCommand>(&command);
        if (draw != nullptr && draw->bounds)
        {
            change(*draw->bounds);
        }
    }
}

void Widen(TargetRegion& region)
{
    region.left -= k_Margin;
    region.top -= k_Margin;
    region.right += k_Margin;
    region.bottom += k_Margin;
}

/// Gives the frame the data that differ in frames of one structure, and the recorder the memory of
/// those before.
void SwapData(FrameCommands& commands, CompiledFrame& frame)
{
    std::swap(frame.uniformData, commands.uniformData);
    std::swap(frame.instances, commands.instances);
    std::swap(frame.perDraw, commands.perDraw);
    std::swap(frame.objects, commands.objects);
}

/// Gives the frame what draws refer to; compiling adds to it.
void CopyTables(const FrameCommands& commands, CompiledFrame& frame)
{
    frame.setups = commands.setups;
    frame.dispatchSetups = commands.dispatchSetups;
    frame.meshes = commands.meshes;
    frame.usesReversedZBuffer = commands.usesReversedZBuffer;
}

} // namespace

bool FrameCache::IsSame(const FrameCommands& commands, const TextureStates& states,
                        std::span<const std::shared_ptr<const RenderTexture>> outputs,
                        const FrameCompilerOptions& options) const
{
    const auto fits = [&](const auto& kept, const auto& now)
    {
        return !options.limitsRegions || Covers(kept, now);
    };
    return m_Frame && options.isLast == m_Options.isLast &&
           options.leavesOut == m_Options.leavesOut &&
           options.limitsRegions == m_Options.limitsRegions && options.held == m_Options.held &&
           commands.usesReversedZBuffer == m_Frame->usesReversedZBuffer &&
           std::ranges::equal(outputs, m_Outputs) &&
           AreSame(commands.commands, m_Commands.commands, fits) &&
           commands.meshes == m_Commands.meshes && commands.objects == m_Frame->objects &&
           commands.uniformData.size() == m_Frame->uniformData.size() &&
           commands.instances.size() == m_Frame->instances.size() &&
           commands.perDraw.size() == m_Frame->perDraw.size() &&
           std::ranges::equal(commands.setups, m_Commands.setups,
                              [](const DrawSetup& a, const DrawSetup& b)
                              { return AreSame(a, b); }) &&
           std::ranges::equal(commands.dispatchSetups, m_Commands.dispatchSetups,
                              [](const DispatchSetup& a, const DispatchSetup& b)
                              { return AreSame(a, b); }) &&
           AreSame(states.textures, m_States.textures) &&
           AreSame(states.buffers, m_States.buffers) &&
           AreSame(states.depthTwins, m_States.depthTwins);
}

bool FrameCache::HasComeToRest(std::span<FrameCommand> commands)
{
    constexpr int k_FramesOfRest = 16;
    bool isStill = true;
    std::size_t count = 0;
    ForEachRegion(commands,
                  [&](const TargetRegion& region)
                  {
                      m_LastRegions.resize(std::max(m_LastRegions.size(), count + 1));
                      isStill = isStill && m_LastRegions[count] == region;
                      m_LastRegions[count++] = region;
                  });
    m_FramesAtRest = isStill ? m_FramesAtRest + 1 : 0;
    return m_FramesAtRest >= k_FramesOfRest;
}

std::shared_ptr<const CompiledFrame>
FrameCache::Compile(FrameCommands& commands, const TextureStates& states,
                    std::span<const std::shared_ptr<const RenderTexture>> outputs,
                    const FrameCompilerOptions& options)
{
    static std::atomic<std::uint64_t> structures{0};
    const bool isSame = IsSame(commands, states, outputs, options);
    if (isSame && !(m_IsWidened && HasComeToRest(commands.commands)))
    {
        if (m_Frame.use_count() > 1)
        {
            m_Frame = std::make_shared<CompiledFrame>(*m_Frame);
        }
        SwapData(commands, *m_Frame);
        return m_Frame;
    }
    std::shared_ptr<CompiledFrame> frame = std::exchange(m_Frame, nullptr); // if compiling throws
    if (!frame || frame.use_count() > 1)
    {
        frame = std::make_shared<CompiledFrame>();
    }
    const auto any = [](const auto&, const auto&)
    {
        return true;
    };
    m_IsWidened = !isSame && frame && options.limitsRegions &&
                  commands.commands != m_Commands.commands &&
                  AreSame(commands.commands, m_Commands.commands, any);
    if (m_IsWidened)
    {
        ForEachRegion(commands.commands, Widen);
    }
    m_FramesAtRest = 0;
    if (!m_Memory)
    {
        m_Memory = std::make_unique<std::pmr::unsynchronized_pool_resource>();
    }
    CopyTables(commands, *frame);
    SwapData(commands, *frame);
    std::pmr::monotonic_buffer_resource memory(m_Memory.get());
    CompileInto(*frame, commands, states, outputs, options, memory);
    frame->structure = ++structures;
    std::swap(m_Commands, commands);
    m_States = states;
    m_Outputs.assign(outputs.begin(), outputs.end());
    m_Options = options;
    m_Frame = std::move(frame);
    return m_Frame;
}

} // namespace limn
