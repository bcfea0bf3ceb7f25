#pragma once

#include <limn/core/CompiledFrame.h>
#include <span>
#include <unordered_map>
#include <unordered_set>

namespace limn
{

/// The D32_SFloat textures that stand in for depth-stencil ones, by the original's id.
struct DepthTwin
{
    std::weak_ptr<const RenderTexture> original;
    std::shared_ptr<const RenderTexture> texture;
};
using DepthTwins = std::unordered_map<std::uint64_t, DepthTwin>;

/// Turns a frame's recorded commands into passes a device can run. The only place that decides
/// barriers, layouts, load and store, from what the commands read and write:
/// - commands on the same targets form one pass; a target bound and never drawn into or cleared
///   forms none; a target bound again with nothing else in between continues its pass;
/// - an attachment is loaded if it holds something worth keeping, cleared where the pass begins
///   with a clear, else its contents do not matter;
/// - it is stored if a later command of the frame reads or loads it, if it is an output, or if it
///   is not transient (a next frame may read it);
/// - a barrier stands before the pass that needs the other use;
/// - transient depth that no draw uses the stencil of is drawn into a texture without one.
/// Remembers each texture's use between frames, so keep one compiler per device.
class FrameCompiler
{
public:
    /// @param outputs  textures to be readable (CopySource) after the frame
    /// @throws ContractError naming pass and texture, if a draw comes before any target or samples
    ///         a texture that it draws into
    CompiledFrame Compile(FrameCommands commands,
                          std::span<const std::shared_ptr<const RenderTexture>> outputs = {});

private:
    class Run;

    struct KnownTexture
    {
        std::weak_ptr<const Texture> texture;
        TextureUsage usage = TextureUsage::Undefined;
    };
    std::unordered_map<std::uint64_t, KnownTexture> m_Known; ///< by Texture::id
    std::unordered_set<std::uint64_t> m_Filled; ///< ids of textures that hold something
    DepthTwins m_DepthTwins;
};

} // namespace limn
