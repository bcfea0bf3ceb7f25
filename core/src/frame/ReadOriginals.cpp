#include "frame/FrameNode.h"

#include <algorithm>

namespace limn
{

namespace
{

/// Returns whether the sampler gives texels as they are, whatever the texture's format is.
bool IsPlain(const SamplerState& sampler)
{
    return sampler.filterMode == FilterMode::Point && sampler.anisoLevel == 1 &&
           !sampler.comparison;
}

bool HasPlainSamplers(const DrawBindings& bindings)
{
    return std::ranges::all_of(bindings.samplers,
                               [](const SamplerSlot& slot) { return IsPlain(slot.state); }) &&
           std::ranges::all_of(bindings.textures, [](const TextureSlot& slot)
                               { return !slot.sampler || IsPlain(*slot.sampler); });
}

/// Returns whether a shader sees the same in depth and in the one channel it was copied to.
bool LooksTheSame(const RenderTexture& depth, const RenderTexture& copy)
{
    return IsDepthFormat(depth.graphicsFormat()) &&
           copy.graphicsFormat() == GraphicsFormat::R32_SFloat && !HasSamples(copy) &&
           depth.width() == copy.width() && depth.height() == copy.height() &&
           depth.mipmapCount() == 1 && copy.mipmapCount() == 1;
}

/// Returns whether the node's draws may read another texture that looks the same.
bool CanReadAnother(const FrameNode& node, const FrameTables& tables)
{
    return !node.isCompute &&
           !AnyDraw(node, tables,
                    [](const DrawSetup& draw) { return !HasPlainSamplers(*draw.bindings); });
}

/// Returns whether all that uses the copy, node `at`, can read the original. A draw with the depth
/// behind it would have to be a pass apart from what reads it: the copy is cheaper then.
bool CanDoWithout(const FrameNodes& nodes, std::size_t at, const FrameTables& tables,
                  const RenderTexture& original)
{
    const RenderTexture& copy = *nodes[at].targets.colors.front();
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        const FrameNode& node = nodes[i];
        const bool isFine = i == at  ? true
                            : i < at ? !Uses(node, copy)
                                     : !HasTarget(node, original) && !HasTarget(node, copy) &&
                                           (!Reads(node, copy) || CanReadAnother(node, tables));
        if (!isFine)
        {
            return false;
        }
    }
    return true;
}

} // namespace

void ReadOriginals(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame)
{
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        const std::shared_ptr<const RenderTexture> original = CopiedBy(nodes[i], frame);
        const std::shared_ptr<const RenderTexture> copy =
            original ? nodes[i].targets.colors.front() : nullptr;
        if (!original || nodes[i].targets.isKept || !LooksTheSame(*original, *copy) ||
            OutlivesFrame(*copy, frame.states) || Contains(outputs, *copy) ||
            !CanDoWithout(nodes, i, frame, *original))
        {
            continue;
        }
        for (FrameNode& node : nodes)
        {
            if (Reads(node, *copy))
            {
                ReadInstead(node, frame, *copy, original);
            }
        }
        Append(nodes[i].whyLeftOut,
               {"passes that read '", copy->name(), "' can read '", original->name(),
                "', because nothing draws into that any more"});
    }
}

} // namespace limn
