#pragma once

#include <limn/core/FrameCommands.h>
#include <unordered_map>
#include <vector>

namespace limn
{

/// What a texture is being used for; the device maps it to layout, stage and access.
enum class TextureUsage
{
    Undefined, ///< contents are worthless
    ColorAttachment,
    DepthStencilAttachment,
    ShaderRead, ///< sampled, in whatever stage
    CopySource,
    RandomWrite ///< read and written by a kernel
};

/// A texture as a frame leaves it.
struct TextureState
{
    std::weak_ptr<const Texture> texture;
    TextureUsage usage = TextureUsage::Undefined;
    bool isFilled = false; ///< it holds something
    bool isPlaced = false; ///< the last frame that used it had it in shared memory
    /// What every texel of it is, of the aspects that `flags` names; what nobody has read may not
    /// be in the image yet.
    ClearCommand constant;
    bool isPending = false;                  ///< `constant` is not in the image
    ShaderStage readers = ShaderStage::None; ///< see TextureBarrier
};

/// A buffer as a frame leaves it.
struct BufferState
{
    std::weak_ptr<const GraphicsBuffer> buffer;
    bool isWritten = false;                  ///< by a kernel
    ShaderStage visible = ShaderStage::None; ///< for these it is what was written
    ShaderStage readers = ShaderStage::None; ///< that read it since
};

/// What a device knows of the textures that frames drew into, and of buffers: all that one frame
/// leaves to the next.
struct TextureStates
{
    std::unordered_map<std::uint64_t, TextureState> textures; ///< by Texture::id

    /// The D32_SFloat texture that stands in for a depth-stencil one.
    struct DepthTwin
    {
        std::weak_ptr<const RenderTexture> original;
        std::shared_ptr<const RenderTexture> texture;
    };
    std::unordered_map<std::uint64_t, DepthTwin> depthTwins; ///< by the original's id

    std::unordered_map<std::uint64_t, BufferState> buffers; ///< by GraphicsBuffer::id

    // Of the frame that is being compiled: see FrameCompilerOptions.
    std::vector<std::uint64_t> held; ///< by Texture::id
    bool isLast = false;
};

} // namespace limn
