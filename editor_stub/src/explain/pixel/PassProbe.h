#pragma once

#include "explain/pixel/FrameReplay.h"
#include "explain/pixel/PixelHistory.h"

#include <cstddef>
#include <functional>
#include <limn/core/Image.h>
#include <limn/core/Shader.h>
#include <limn/vulkan/VulkanDevice.h>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace limn
{

/// A draw of a pass, instance by instance where these differ, or a clear within it.
struct PassStep
{
    std::size_t command = 0;         ///< of CompiledRenderPass::commands
    std::uint32_t firstInstance = 0; ///< of the draw's own
    std::uint32_t instanceCount = 1;
    std::optional<ViewportRect> viewport; ///< in effect; none = the whole target
    std::string sample;                   ///< the innermost one it was recorded in
};

/// Returns a pass's steps in their order.
std::vector<PassStep> StepsOf(const CompiledRenderPass& pass, const FrameTables& tables);

/// The bytes that a pass's targets hold at a texel.
struct TargetTexels
{
    std::vector<std::vector<std::byte>> colors;
    std::vector<std::byte> depth;   ///< as D32_SFloat; empty = the pass has none
    std::vector<std::byte> stencil; ///< as R8_UInt; empty likewise
};

/// Programs of draws that show nothing but where they are: the draws' own places, white.
class CoverPrograms
{
public:
    explicit CoverPrograms(const std::shared_ptr<ShaderCompiler>& compiler);

    /// Returns the draw with what its fragments show taken out, and the textures that only they
    /// read.
    DrawSetup Cover(const DrawSetup& draw);

private:
    std::vector<std::uint32_t> m_WhiteSpirv;
    std::unordered_map<const ShaderProgram*, std::shared_ptr<const ShaderProgram>> m_Programs;
};

/// Looks at one texel of a pass's targets, by running the frame again up to there.
class PassProbe
{
public:
    /// @param x, y  of the texel, from the top left of the picture
    PassProbe(const CompiledFrame& frame, std::size_t pass, int x, int y, VulkanDevice& device,
              CoverPrograms& covers);

    const std::vector<PassStep>& steps() const { return m_Steps; }
    /// Returns the places among steps() of those that reach the texel, whatever tests and shaders
    /// make of it. No others change it.
    const std::vector<std::size_t>& reaching() const { return m_Reaching; }

    /// Returns what the targets hold behind the first `count` that reach the texel; 0 where that
    /// is nothing.
    TargetTexels After(std::size_t count) const;

    // Each of these answers for the which-th draw that reaches the texel.

    const DrawCommand& DrawAt(std::size_t which) const { return DrawOf(Step(which)); }
    DrawSetup SetupOf(std::size_t which) const;
    bool LiesInScissor(std::size_t which) const;
    /// Returns whether the texel lies in this part of the targets.
    bool LiesIn(const ViewportRect& rect) const;
    /// Returns whether it reaches the texel with these faces culled.
    bool Reaches(std::size_t which, CullMode cull) const;
    /// Returns whether a fragment gets past all tests, in this state in place of its own.
    bool Passes(std::size_t which, const PipelineState& state) const;
    /// Returns what its shader gives; nothing where that is no colour.
    std::optional<std::vector<float>> OutputOf(std::size_t which) const;
    /// Returns the depth of the nearest fragment, 1 = near.
    float DepthOf(std::size_t which) const;

private:
    /// Steps from `begin` on, before `end`.
    struct Range
    {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    static constexpr std::size_t k_Channels = 4;
    using Reached = std::array<bool, k_Channels>;

    const CompiledRenderPass& pass() const { return m_Frame.passes[m_Pass]; }
    const PassStep& Step(std::size_t which) const { return m_Steps[m_Reaching[which]]; }
    const DrawCommand& DrawOf(const PassStep& step) const;
    /// The draw of this step only, and of this texel.
    DrawCommand AtTexel(const PassStep& step) const;
    RenderTextureDescriptor ProbeDescriptor(GraphicsFormat format) const;
    ViewportRect TexelRect() const;

    bool IsClear(const PassStep& step) const
    {
        return std::holds_alternative<ClearCommand>(pass().commands[step.command]);
    }
    static void Split(const Range& range, std::vector<Range>& ranges); ///< into up to four
    void FindReaching();
    /// Finds out which of at most four ranges reach the texel.
    Reached Cover(std::span<const Range> ranges, CullMode cull) const;
    void AddCover(FrameReplay& replay, const Range& range, int channel, CullMode cull) const;
    FrameReplay BeforePass() const;
    FrameReplay Begin(std::size_t count) const;
    void AddAtTexel(FrameReplay& replay, const PassStep& step) const;
    /// Draws onto a target of its own, which is cleared to white, with the pass's depth.
    Image Draw(std::size_t which, const PipelineState& state, GraphicsFormat format) const;
    std::vector<std::byte> TexelOf(const Image& image) const { return TexelAt(image, m_X, m_Y); }

    const CompiledFrame& m_Frame;
    std::size_t m_Pass;
    int m_X;
    int m_Y;
    VulkanDevice& m_Device;
    CoverPrograms& m_Covers;
    std::vector<PassStep> m_Steps;
    std::vector<std::size_t> m_Reaching;
};

/// Finds the reason for which a draw that reaches the texel leaves it as it was: the first test
/// that rejects it.
/// @param which    of PassProbe::reaching
/// @param before   what the targets hold before it
/// @param isEmpty  whether the frame is known to have nothing there for it to show
std::pair<PixelFate, std::string> WhyUnchanged(const PassProbe& probe, std::size_t which,
                                               const TargetTexels& before, bool isEmpty);

/// "(0.25, 0, 1)", or "0.25".
std::string NumbersText(const std::vector<float>& numbers);

} // namespace limn
