#pragma once

#include <functional>
#include <limn/core/CompiledFrame.h>
#include <memory>
#include <memory_resource>
#include <span>

namespace limn
{

/// The memory that a texture takes on a device.
struct TextureFootprint
{
    std::uint64_t size = 0;      ///< bytes; 0 = it must have memory of its own
    std::uint64_t alignment = 1; ///< bytes
    std::uint32_t kind = 0;      ///< textures of different kinds cannot share memory
};

using TextureFootprintFunction = std::function<TextureFootprint(const RenderTexture&)>;

struct FrameCompilerOptions
{
    bool isLast = false; ///< no frame comes after this one: nothing is kept for it
    /// The ids of transient textures that are kept nevertheless, so that the next frame may read
    /// them: RenderTexturePool::held.
    std::vector<std::uint64_t> held;
    /// If false, everything recorded is run, each node as one pass, for comparison. Must be the
    /// same for all frames of a device.
    bool leavesOut = true;
    bool limitsRegions = true; ///< full-screen passes are drawn only where they can be seen
    /// Returns the memory of a texture on the device, so that textures can share memory; none =
    /// each has its own.
    TextureFootprintFunction footprint = nullptr;
};

/// Turns a frame's recorded commands into passes that a device can run. Only this function decides
/// what is left out, and sets barriers, layouts, load and store, from what the commands read and
/// write. It is a pure function: it knows of earlier frames only `states`, and returns in
/// `CompiledFrame::states` what it leaves to the next one.
///
/// Textures outlive the frame where a next one may read them, since nothing tells what a next
/// frame's passes read. The exceptions are those that are made transient and that nothing holds.
///
/// Its steps, each in a file of core/src/frame:
/// - SplitIntoNodes: commands on the same targets form a node; a target that is bound and never
///   drawn into or cleared forms none; each dispatch is a node, which changes the textures that it
///   may write;
/// - NoteMissingAlpha: notes draws that blend with an alpha which an HDR target of 32 bits lacks;
/// - FindAccess: finds what each node reads, and whether it covers what its target held;
/// - ElideConstantDraws: a draw that is known to change nothing is removed; one that makes its
///   target one colour, as a copy of one colour does, becomes a clear; a node without draws only
///   records what its targets hold from now on, and is run where something reads that; depth is
///   attached where a draw uses it;
/// - EliminateCopies: a copy of a texture that nothing else reads is removed: what drew into the
///   texture draws into the copy, or is resolved into it; what blends does so only where the copy
///   holds the same;
/// - ReadOriginals: a copy of depth is removed if nothing is drawn with the depth any more: what
///   reads the copy reads the depth itself;
/// - CullPasses: a node whose targets nothing reads is removed, unless it isKept or writes a
///   buffer;
/// - ScissorFullScreenPasses: a full-screen pass is drawn only where what it reads is not known to
///   be 0;
/// - StripUnusedStencil: depth keeps a stencil only where a draw uses it;
/// - MergeNodes: nodes whose colours are the same, as far as both have some, and which do not have
///   different depths become one, if nothing between them depends on the order; so do neighbouring
///   dispatches;
/// - ResolveSamples: several samples per texel are resolved to one where something reads that;
/// - AliasTransientMemory: textures that nothing keeps share memory if they never hold something at
///   the same time;
/// - finally load, store and barriers: an attachment is loaded if it holds something worth keeping,
///   and stored if it is read later, is an output, or may be read by a next frame.
///
/// @param states   as the frame before left them
/// @param outputs  textures that must be readable (CopySource) after the frame
/// @throws ContractError naming pass and texture, if a draw comes before any target or samples a
///     texture that it draws into
CompiledFrame CompileFrame(FrameCommands commands, const TextureStates& states,
                           std::span<const std::shared_ptr<const RenderTexture>> outputs = {},
                           const FrameCompilerOptions& options = {});

/// Compiles the frames of one device, one after the other. A frame that records the same as the one
/// before is not compiled again: it only gets new uniform and per-draw data. Any other frame is
/// compiled in the memory of the frame before.
///
/// The regions in which draws are seen change whenever the camera or an object moves. If nothing
/// else changes, the frame is compiled for regions that are a little wider, by 1/32 of the target
/// at each side, and kept while the draws stay within them; if they rest for 16 frames, it is
/// compiled for their exact regions once more. Pictures do not depend on it.
class FrameCache
{
public:
    /// Compiles a frame as CompileFrame does. It takes what it needs out of `commands`, whose lists
    /// keep their memory where they can.
    /// @param options  its `footprint` must be the same function in every call
    /// @return never null. It does not change as long as something else holds it
    std::shared_ptr<const CompiledFrame>
    Compile(FrameCommands& commands, const TextureStates& states,
            std::span<const std::shared_ptr<const RenderTexture>> outputs,
            const FrameCompilerOptions& options);

    /// Makes the next frame compile anew.
    void Clear() { m_Frame = nullptr; }

private:
    bool IsSame(const FrameCommands& commands, const TextureStates& states,
                std::span<const std::shared_ptr<const RenderTexture>> outputs,
                const FrameCompilerOptions& options) const;
    /// Returns whether the draws are seen where they were in enough frames before.
    bool HasComeToRest(std::span<FrameCommand> commands);

    std::shared_ptr<CompiledFrame> m_Frame;
    /// The memory that compiling uses for its time. The first frame makes it, so that caches can be
    /// moved.
    std::unique_ptr<std::pmr::unsynchronized_pool_resource> m_Memory;
    bool m_IsWidened = false;                ///< `m_Frame` is compiled for wider regions
    int m_FramesAtRest = 0;                  ///< since then
    std::vector<TargetRegion> m_LastRegions; ///< of the last frame since then
    // These are what it was compiled from, without uniform and per-draw data.
    FrameCommands m_Commands;
    TextureStates m_States;
    std::vector<std::shared_ptr<const RenderTexture>> m_Outputs;
    FrameCompilerOptions m_Options;
};

} // namespace limn
