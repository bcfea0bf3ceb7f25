#pragma once

#include <limn/core/FrameCommands.h>
#include <unordered_map>
#include <vector>

namespace limn
{

/// The current use of a texture; the device maps it to layout, stage and access.
enum class TextureUsage
{
    Undefined, ///< contents are worthless
    ColorAttachment,
    DepthStencilAttachment,
    ShaderRead, ///< sampled, in any stage
    CopySource,
    RandomWrite ///< read and written by a kernel
};

/// The state in which a frame leaves a texture.
struct TextureState
{
    std::weak_ptr<const Texture> texture;
    TextureUsage usage = TextureUsage::Undefined;
    bool isFilled = false; ///< it holds something
    bool isPlaced = false; ///< the last frame that used it had it in shared memory
    /// The values that every texel of the texture has, in the aspects that `flags` names. If
    /// nothing has read them yet, they may not be in the image.
    ClearCommand constant;
    bool isPending = false;                  ///< `constant` is not in the image
    ShaderStage readers = ShaderStage::None; ///< see TextureBarrier
};

/// The state in which a frame leaves a buffer.
struct BufferState
{
    std::weak_ptr<const GraphicsBuffer> buffer;
    bool isWritten = false;                  ///< by a kernel
    ShaderStage visible = ShaderStage::None; ///< the stages for which its contents are visible
    ShaderStage readers = ShaderStage::None; ///< the stages that have read it since
};

/// The state of the textures that frames drew into, and of buffers, on a device. It is all that one
/// frame leaves to the next.
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

    // These two are copied from the FrameCompilerOptions of the frame that is being compiled.
    std::vector<std::uint64_t> held; ///< by Texture::id
    bool isLast = false;
};

/// A barrier before a pass that changes the use of a texture and makes everything written visible.
struct TextureBarrier
{
    std::shared_ptr<const Texture> texture;
    TextureUsage before = TextureUsage::Undefined;
    TextureUsage after = TextureUsage::Undefined;
    /// The shader stages that may read the texture until the next barrier, for ShaderRead; None =
    /// all.
    ShaderStage readers = ShaderStage::None;

    bool operator==(const TextureBarrier&) const = default;
};

/// A barrier before a pass that waits until the earlier uses of a buffer are done.
struct BufferBarrier
{
    std::shared_ptr<const GraphicsBuffer> buffer;
    ShaderStage before = ShaderStage::None; ///< the stages that used it
    bool wasWritten = false;                ///< if true, what they wrote is made visible
    ShaderStage after = ShaderStage::None;  ///< the stages that will use it
    bool isWritten = false;                 ///< if true, they may write

    bool operator==(const BufferBarrier&) const = default;
};

enum class LoadOp
{
    Load,
    Clear,
    DontCare
};
enum class StoreOp
{
    Store,
    DontCare
};

struct ColorAttachment
{
    std::shared_ptr<const RenderTexture> texture;
    LoadOp load = LoadOp::Load;
    StoreOp store = StoreOp::Store;
    Color clearColor; ///< linear
    /// The texture that receives the average of the samples at the pass's end; null if none does.
    /// It is `texture` itself, whose readers then see the average, or another texture of its format
    /// with one sample per texel. `load` and `store` concern the samples only.
    std::shared_ptr<const RenderTexture> resolve = nullptr;
    /// If true, the mip levels behind the first are made at the pass's end: those of `resolve`, or
    /// else of `texture`.
    bool generatesMips = false;

    bool operator==(const ColorAttachment&) const = default;
};

struct DepthAttachment
{
    std::shared_ptr<const RenderTexture> texture;
    LoadOp load = LoadOp::Load;
    StoreOp store = StoreOp::Store;
    LoadOp stencilLoad = LoadOp::Load;
    StoreOp stencilStore = StoreOp::Store;
    float clearDepth = 1.0f; ///< 1 = far, see ClearCommand
    int clearStencil = 0;
    /// The texture that receives the first sample of depth and stencil at the pass's end, see
    /// ColorAttachment::resolve.
    std::shared_ptr<const RenderTexture> resolve = nullptr;

    bool operator==(const DepthAttachment&) const = default;
};

/// The recorded commands that remain inside a pass.
using PassCommand = std::variant<ClearCommand, SetViewportCommand, DrawCommand, BeginSampleCommand,
                                 EndSampleCommand, DispatchCommand>;

/// A run of commands on one set of attachments, which becomes one vkCmdBeginRendering/EndRendering,
/// or a run of dispatches that are independent of each other.
struct CompiledRenderPass
{
    std::string name; ///< the innermost sample it began in, or ""
    std::vector<TextureBarrier> barriers;
    std::vector<BufferBarrier> bufferBarriers;
    std::vector<ColorAttachment> colors;
    std::optional<DepthAttachment> depth;
    /// The textures that dispatches wrote and whose mip levels behind the first are made at the
    /// pass's end.
    std::vector<std::shared_ptr<const RenderTexture>> mips;
    int width = 0;
    int height = 0;
    std::vector<PassCommand> commands;
    std::size_t place = 0; ///< index in what was recorded, including what is left out

    /// Returns whether the pass has dispatches and no attachments.
    bool isCompute() const { return colors.empty() && !depth; }
    /// Returns its name and those of all samples in it, each once. Passes that were recorded
    /// separately may be merged into one.
    std::vector<std::string> SampleNames() const;
    /// Returns all names in one line: "Draw Opaque Objects + Outline".
    std::string Title() const;
    /// Replaces `title` by the title, and reuses its memory.
    void WriteTitle(std::string& title) const;
};

/// The place of a texture in memory that it shares with other textures, which hold nothing while it
/// does.
struct PlacedTexture
{
    std::shared_ptr<const RenderTexture> texture;
    std::uint32_t kind = 0;   ///< kind of memory, see TextureFootprint
    std::uint64_t offset = 0; ///< bytes from the beginning of the shared memory of that kind
    std::uint64_t size = 0;   ///< bytes

    bool operator==(const PlacedTexture&) const = default;
};

/// Something recorded that the frame leaves out.
struct LeftOut
{
    std::string pass;                      ///< the innermost sample it was recorded in, or ""
    std::string reason;                    ///< "nothing reads 'X'"
    std::vector<std::string> targets = {}; ///< names of the targets it would have drawn into
    std::size_t place = 0;                 ///< see CompiledRenderPass

    bool operator==(const LeftOut&) const = default;
};

/// A frame that is ready to run: the device adds nothing to it and leaves nothing out.
struct CompiledFrame : FrameTables
{
    std::vector<CompiledRenderPass> passes;
    std::vector<PlacedTexture> placed;         ///< the others have memory of their own
    std::vector<TextureBarrier> finalBarriers; ///< after the last pass: outputs → CopySource
    std::vector<std::byte> uniformData;
    std::vector<LeftOut> leftOut;
    std::vector<std::string> notes; ///< sentences for the user
    TextureStates states;           ///< of the textures once it has run
    /// A number other than 0 that is equal for frames of one device which differ only in
    /// uniformData (not its size), in instances and perDraw (not their number) and in the most that
    /// objects hold, and which start from equal states.
    std::uint64_t structure = 0;
};

} // namespace limn
