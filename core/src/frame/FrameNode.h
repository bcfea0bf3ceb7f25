#pragma once

#include <algorithm>
#include <limn/core/FrameCompiler.h>
#include <memory_resource>
#include <span>
#include <unordered_map>
#include <unordered_set>

namespace limn
{

using OutputSpan = std::span<const std::shared_ptr<const RenderTexture>>;

/// Samples of a target that are resolved to one per texel at the end of a node.
struct SampleResolve
{
    std::shared_ptr<const RenderTexture> from;
    std::shared_ptr<const RenderTexture> to; ///< see ColorAttachment::resolve
};

/// The use of a buffer by a node.
struct BufferUse
{
    std::shared_ptr<const GraphicsBuffer> buffer;
    ShaderStage stages = ShaderStage::None;
    bool isWritten = false;
};

/// Allocates the lists of a frame while it is compiled. They are freed together, and the next frame
/// uses that memory.
using FrameAllocator = std::pmr::polymorphic_allocator<>;

/// Commands on one set of targets, or dispatches, before load, store and barriers are decided.
struct FrameNode
{
    using allocator_type = FrameAllocator;

    FrameNode() = default;
    explicit FrameNode(const FrameAllocator& memory);
    FrameNode(FrameNode&& other) noexcept = default;
    FrameNode(FrameNode&& other, const FrameAllocator& memory);
    FrameNode& operator=(FrameNode&& other) = default;

    std::pmr::string name;
    SetRenderTargetCommand targets;
    std::optional<ClearCommand> clear; ///< all that is cleared before the first draw
    /// Colours that are cleared separately, by index, if `clear` clears none; the list may be
    /// shorter than the targets' colours.
    FixedList<std::optional<Color>, k_MostColors> clearedColors;
    /// If true, a draw covers the colour, so that its contents before the node do not matter.
    bool coversColor = false;
    std::pmr::vector<PassCommand> commands;
    /// The textures that are drawn into or sampled; each once.
    std::pmr::vector<std::shared_ptr<const Texture>> reads;
    std::pmr::vector<std::shared_ptr<const RenderTexture>> writes; ///< by dispatches; each once
    std::pmr::vector<BufferUse> buffers;                           ///< one use for each
    bool isCompute = false; ///< it has dispatches, and no targets
    std::pmr::vector<SampleResolve> resolves;
    std::pmr::string whyLeftOut; ///< "" = it is not left out
    std::size_t place = 0;       ///< see CompiledRenderPass
};

using FrameNodes = std::pmr::vector<FrameNode>;
using TextureIds = std::pmr::unordered_set<std::uint64_t>; ///< Texture::id

/// Returns the aspects of a texture that an attachment or a clear concerns.
ClearFlag AspectsOf(const RenderTexture& texture);
bool Clears(const FrameNode& node, ClearFlag aspects); ///< returns whether it clears all of them
bool HasSamples(const RenderTexture& texture);         ///< returns whether it has several per texel
/// Returns the colour to which a colour target is cleared before the first draw; none = it is not
/// cleared.
std::optional<Color> ClearColorOf(const FrameNode& node, const RenderTexture& target);
bool HasDraws(const FrameNode& node); ///< returns whether it has draws or dispatches

/// Returns whether the node has a command of this kind.
template <typename Command>
bool Has(const FrameNode& node)
{
    return std::ranges::any_of(node.commands, [](const PassCommand& command)
                               { return std::holds_alternative<Command>(command); });
}

/// Returns whether `is(setup)` is true for the set-up of one of the node's draws.
template <typename Is>
bool AnyDraw(const FrameNode& node, const FrameTables& tables, const Is& is)
{
    return std::ranges::any_of(node.commands,
                               [&](const PassCommand& command)
                               {
                                   const auto* draw = std::get_if<DrawCommand>(&command);
                                   return draw != nullptr && is(tables.Setup(*draw));
                               });
}

/// Returns whether each component that the format has is 0.
bool IsZero(const Color& color, GraphicsFormat format);
/// Returns whether a draw tests or writes depth or stencil if they are attached.
bool UsesDepth(const PipelineState& state);
/// Returns whether the contents of the target before the node do not matter.
bool Overwrites(const FrameNode& node, const RenderTexture& target);
/// Calls `visit` with each texture that the node draws into, resolves to or writes, until it
/// returns true.
/// @return whether it did
template <typename Visit>
bool AnyTarget(const FrameNode& node, const Visit& visit)
{
    for (const auto& color : node.targets.colors)
    {
        if (visit(color))
        {
            return true;
        }
    }
    if (node.targets.depth && visit(node.targets.depth))
    {
        return true;
    }
    for (const SampleResolve& resolve : node.resolves)
    {
        if (resolve.to != resolve.from && visit(resolve.to))
        {
            return true;
        }
    }
    return std::ranges::any_of(node.writes, visit);
}
template <typename Visit>
void ForEachTarget(const FrameNode& node, const Visit& visit)
{
    AnyTarget(node,
              [&](const std::shared_ptr<const RenderTexture>& target)
              {
                  visit(target);
                  return false;
              });
}
/// Returns whether the node draws into the texture, resolves to it or writes it.
bool HasTarget(const FrameNode& node, const Texture& texture);
/// Returns whether the node's draws or dispatches sample the texture.
bool Reads(const FrameNode& node, const Texture& texture);
/// Returns whether the node draws into the texture, writes it or reads it.
bool Uses(const FrameNode& node, const Texture& texture);
/// Returns the texture that the node copies; null if it copies none, or more than one.
std::shared_ptr<const RenderTexture> CopiedBy(const FrameNode& node, const FrameTables& tables);
/// Fills FrameNode::reads, writes and buffers from the draws and dispatches.
void CollectReads(FrameNode& node, const FrameTables& tables);

/// Changes the setups of a node's draws, without those of other nodes.
/// @param change  called with a DrawSetup&
template <typename Change>
void ChangeSetups(FrameNode& node, FrameTables& tables, const Change& change)
{
    std::pmr::unordered_map<std::uint32_t, std::uint32_t> changed(node.commands.get_allocator());
    for (PassCommand& command : node.commands)
    {
        if (auto* draw = std::get_if<DrawCommand>(&command))
        {
            const auto [known, isNew] =
                changed.try_emplace(draw->setup, static_cast<std::uint32_t>(tables.setups.size()));
            if (isNew)
            {
                DrawSetup setup = tables.Setup(*draw);
                change(setup);
                tables.setups.push_back(std::move(setup));
            }
            draw->setup = known->second;
        }
    }
}

/// Returns bindings with another texture in place of one.
std::shared_ptr<const DrawBindings> WithTexture(const DrawBindings& bindings,
                                                const Texture& replaced,
                                                const std::shared_ptr<const Texture>& texture);
/// Makes the node's draws read another texture in place of one.
void ReadInstead(FrameNode& node, FrameTables& tables, const Texture& replaced,
                 const std::shared_ptr<const Texture>& texture);

/// Adds what `other` clears, which replaces the values of `clear` for the same aspects.
void Merge(ClearCommand& clear, const ClearCommand& other);
/// Adds what `other` clears to what the node clears before its first draw.
void AddClear(FrameNode& node, const ClearCommand& other);

/// Moves the nodes that have a reason to be left out behind those that are left out already.
void EraseLeftOut(FrameNodes& nodes, FrameNodes& leftOut);

/// Appends all parts without a separator.
inline void Append(std::pmr::string& text, std::initializer_list<std::string_view> parts)
{
    for (const std::string_view part : parts)
    {
        text += part;
    }
}

/// Erases samples that begin and end with nothing in between.
void EraseEmptySamples(FrameNode& node);

/// Splits a frame's commands into nodes. Targets and viewports take effect when something is drawn
/// or cleared, so binding alone neither begins nor ends a node. Each dispatch is a node. Samples
/// that continue in another node begin there anew, and those left open end with the frame.
/// @param nodes  must be empty; receives the nodes
/// @throws ContractError as CompileFrame does
void SplitIntoNodes(std::span<const FrameCommand> commands, const FrameTables& tables,
                    FrameNodes& nodes);

/// Notes the draws that blend with the alpha of an HDR target of 32 bits, which has none.
void NoteMissingAlpha(const FrameNodes& nodes, CompiledFrame& frame);

/// Finds what each node reads, and which draws cover their target: what they cover is dropped.
void FindAccess(FrameNodes& nodes, const FrameTables& tables);

// Each of the following steps leaves a frame that draws the same. They know of earlier frames only
// `frame.states`, and set FrameNode::whyLeftOut of the nodes that they leave out: EraseLeftOut
// follows each of them.

void ElideConstantDraws(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame);
void EliminateCopies(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame);
/// Makes draws read a depth texture itself in place of its copy, if nothing is drawn with the depth
/// behind the copy.
void ReadOriginals(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame);
void CullPasses(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame);
/// Draws full-screen passes only where they can be seen, as far as the bounds of what was drawn
/// before and the passes' promises tell.
void ScissorFullScreenPasses(FrameNodes& nodes, const FrameTables& tables);
/// Replaces every transient depth-stencil texture whose stencil no draw of the frame uses by a twin
/// of format D32_SFloat: less memory, less traffic. Draws sample only its depth. Outputs and
/// textures that kernels read stay, since others know them by identity.
void StripUnusedStencil(FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame);
/// Merges nodes with equal targets into one, before or behind nodes that do not depend on their
/// order.
void MergeNodes(FrameNodes& nodes, FrameTables& tables);
/// Resolves samples if something reads them before the texture's next node: as late as possible,
/// and not if they are only drawn onto.
void ResolveSamples(FrameNodes& nodes, OutputSpan outputs, const CompiledFrame& frame);

/// Places textures in shared memory, in `frame.placed`, if that saves any. What they held before
/// the frame is lost. An empty `footprint` places none.
void AliasTransientMemory(const FrameNodes& nodes, OutputSpan outputs,
                          const TextureFootprintFunction& footprint, CompiledFrame& frame);

/// Assigns load, store and barriers.
/// @param frame  its `passes` are those of an earlier frame, whose memory is used again
void AssignLoadStoreBarriers(const FrameNodes& nodes, OutputSpan outputs, CompiledFrame& frame);

/// Compiles into a frame whose lists have the memory of an earlier one.
/// @param memory  for what is needed while compiling
/// @throws ContractError as CompileFrame does; the frame must not be used then
void CompileInto(CompiledFrame& frame, const FrameCommands& commands, const TextureStates& states,
                 OutputSpan outputs, const FrameCompilerOptions& options,
                 std::pmr::memory_resource& memory);

/// Returns whether blending this colour in leaves every texel as it is, whatever it holds.
/// @param color  linear, the result of the fragment function
bool LeavesTargetAsItIs(const RenderTargetBlendState& blend, const Color& color);

/// Returns whether the target's contents after a draw follow from the draw alone.
bool ReplacesTarget(const RenderTargetBlendState& blend);

/// Returns whether each component of the colour stays as it is or follows from the draw alone; the
/// alpha may be blended.
bool ReplacesColor(const RenderTargetBlendState& blend);

/// Returns whether a factor of the colour's blending is made from the target's alpha.
bool FactorsReadAlpha(const RenderTargetBlendState& blend);

/// Returns whether the colour after a draw depends on the target's alpha.
bool ReadsTargetAlpha(const RenderTargetBlendState& blend);

/// Returns what is known of a texture; nothing is known of a new one.
TextureState& StateOf(TextureStates& states, const std::shared_ptr<const Texture>& texture);
const TextureState* FindState(const TextureStates& states, const Texture& texture); ///< null = new

bool Contains(OutputSpan outputs, const RenderTexture& texture);

/// Forgets the contents of textures that no next frame reads; only their use is kept.
void ForgetContents(TextureStates& states);

/// Returns whether a next frame may read what this one leaves in the texture: anything that holds
/// it may, even if each earlier frame overwrote it first.
bool OutlivesFrame(const RenderTexture& texture, const TextureStates& states);

} // namespace limn
