#pragma once

#include <functional>
#include <limn/core/CompiledFrame.h>
#include <memory>
#include <memory_resource>
#include <span>

namespace limn
{

/// What a texture takes of a device's memory.
struct TextureFootprint
{
    std::uint64_t size = 0;      ///< bytes; 0 = it has to have memory of its own
    std::uint64_t alignment = 1; ///< bytes
    std::uint32_t kind = 0;      ///< textures of different kinds cannot share memory
};

using TextureFootprintFunction = std::function<TextureFootprint(const RenderTexture&)>;

struct FrameCompilerOptions
{
    bool isLast = false; ///< no frame comes after this one: nothing is kept for it
    /// The ids of transient textures that somebody keeps all the same, so that a next frame may
    /// read them: RenderTexturePool::held.
    std::vector<std::uint64_t> held;
    /// Off: everything recorded is run, each node as one pass, to compare with. The same for all
    /// frames of a device.
    bool leavesOut = true;
    bool limitsRegions = true; ///< full-screen passes are drawn where they can be seen only
    /// Of the device, so that textures share memory; none = each has its own.
    TextureFootprintFunction footprint = nullptr;
};

/// Turns a frame's recorded commands into passes a device can run. The only place that decides what
/// is left out, barriers, layouts, load and store, from what the commands read and write. A pure
/// function: it knows of earlier frames what `states` says, and says in `CompiledFrame::states`
/// what it leaves to the next.
///
/// Textures outlive the frame where a next one may read them: all but those that are made transient
/// and that nobody holds, as nobody can tell what a next frame's passes read.
///
/// Its steps, each in a file of core/src/frame:
/// - SplitIntoNodes: commands on the same targets form a node; a target bound and never drawn into
///   or cleared forms none; each dispatch is a node, which changes the textures that it may write;
/// - NoteMissingAlpha: draws that blend with an alpha which an HDR target of 32 bits lacks;
/// - FindAccess: what each node reads, and whether it covers what its target held;
/// - ElideConstantDraws: a draw that is known to change nothing goes; one that makes its target one
///   colour, as a copy of one colour does, is a clear; a node without draws only says what its
///   targets hold from now on, and is run where something reads that; depth is attached where a
///   draw uses it;
/// - EliminateCopies: a copy of a texture that nothing else reads goes: what drew into the texture
///   draws into the copy, or is resolved into it; what blends, where the copy holds the same;
/// - ReadOriginals: a copy of depth goes where nothing is drawn with the depth any more: what reads
///   the copy reads the depth itself;
/// - CullPasses: a node whose targets nothing reads goes, unless it isKept or writes a buffer;
/// - ScissorFullScreenPasses: a full-screen pass is drawn where what it reads is not known to be 0;
/// - StripUnusedStencil: depth has a stencil where a draw uses it;
/// - MergeNodes: nodes whose colours are the same, as far as both have some, and whose depth is not
///   another become one, if nothing between them minds; so do neighbouring dispatches;
/// - ResolveSamples: several samples a texel become one where something reads that;
/// - AliasTransientMemory: textures that nothing keeps share memory where no two hold something at
/// once;
/// - then load, store and barriers: an attachment is loaded if it holds something worth keeping,
///   and stored if it is read later, is an output, or may be read by a next frame.
///
/// @param states   as the frame before left them
/// @param outputs  textures to be readable (CopySource) after the frame
/// @throws ContractError naming pass and texture, if a draw comes before any target or samples
///         a texture that it draws into
CompiledFrame CompileFrame(FrameCommands commands, const TextureStates& states,
                           std::span<const std::shared_ptr<const RenderTexture>> outputs = {},
                           const FrameCompilerOptions& options = {});

/// Compiles one frame after the other for one device. A frame that records what the one before did
/// is not worked out again: it only gets new uniform and per-draw data. Another one is worked out
/// in the memory of the frame before.
///
/// The regions that draws are seen in change whenever the camera or an object moves. Where nothing
/// else changes, the frame is compiled for regions that are a little wider, by 1/32 of the target
/// at each side, and kept while the draws stay within them; where they rest for 16 frames, it is
/// compiled for their regions once more. Pictures do not depend on it.
class FrameCache
{
public:
    /// As CompileFrame; takes what it needs out of `commands`, whose lists keep their memory where
    /// they can.
    /// @param options  its `footprint` is the same function in every call
    /// @return never null. It stays as it is for as long as somebody else holds it
    std::shared_ptr<const CompiledFrame>
    Compile(FrameCommands& commands, const TextureStates& states,
            std::span<const std::shared_ptr<const RenderTexture>> outputs,
            const FrameCompilerOptions& options);

    /// The next frame is worked out anew.
    void Clear() { m_Frame = nullptr; }

private:
    bool IsSame(const FrameCommands& commands, const TextureStates& states,
                std::span<const std::shared_ptr<const RenderTexture>> outputs,
                const FrameCompilerOptions& options) const;
    /// Returns whether the draws are seen where they were in enough frames before.
    bool HasComeToRest(std::span<FrameCommand> commands);

    std::shared_ptr<CompiledFrame> m_Frame;
    /// Compiling uses it for a time. The first frame makes it, so that caches can be moved.
    std::unique_ptr<std::pmr::unsynchronized_pool_resource> m_Memory;
    bool m_IsWidened = false;                ///< `m_Frame` is compiled for wider regions
    int m_FramesAtRest = 0;                  ///< since then
    std::vector<TargetRegion> m_LastRegions; ///< of the last frame since then
    // What it was compiled from, without uniform and per-draw data.
    FrameCommands m_Commands;
    TextureStates m_States;
    std::vector<std::shared_ptr<const RenderTexture>> m_Outputs;
    FrameCompilerOptions m_Options;
};

} // namespace limn
