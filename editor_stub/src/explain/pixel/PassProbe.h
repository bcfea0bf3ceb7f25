#pragma once

#include "explain/pixel/FrameReplay.h"
#include "explain/pixel/PixelHistory.h"

#include <cstddef>
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
    std::size_t command = 0;         ///< index into CompiledRenderPass::commands
    std::uint32_t firstInstance = 0; ///< counted within the draw's instances
    std::uint32_t instanceCount = 1;
    std::optional<ViewportRect> viewport; ///< the one in effect; none = the whole target
    std::string sample;                   ///< the innermost sample that it was recorded in
};

/// The bytes that a pass's targets hold at a texel.
struct TargetTexels
{
    std::vector<std::vector<std::byte>> colors;
    std::vector<std::byte> depth;   ///< as D32_SFloat; empty if the pass has no depth
    std::vector<std::byte> stencil; ///< as R8_UInt; empty if the pass has no stencil
};

/// Programs that show only where draws are: they draw at the same places, in white.
class CoverPrograms
{
public:
    explicit CoverPrograms(const std::shared_ptr<ShaderCompiler>& compiler);

    /// Returns the draw without its fragments' colours, and without the textures that only the
    /// fragments read.
    DrawSetup Cover(const DrawSetup& draw);

private:
    std::vector<std::uint32_t> m_WhiteSpirv;
    std::unordered_map<const ShaderProgram*, std::shared_ptr<const ShaderProgram>> m_Programs;
};

/// Looks at one texel of a pass's targets by running the frame again up to that pass.
class PassProbe
{
public:
    /// @param x, y  the texel, counted from the top left of the picture
    PassProbe(const CompiledFrame& frame, std::size_t pass, int x, int y, VulkanDevice& device,
              CoverPrograms& covers);

    const std::vector<PassStep>& steps() const { return m_Steps; }
    /// Returns the indices in steps() of the steps that reach the texel, whatever tests and shaders
    /// make of it. No others change it.
    const std::vector<std::size_t>& reaching() const { return m_Reaching; }

    /// Returns what the targets hold after the first `count` steps that reach the texel, and 0 for
    /// targets without contents.
    TargetTexels After(std::size_t count) const;

    // Each of these answers for the which-th draw that reaches the texel.

    const DrawCommand& DrawAt(std::size_t which) const { return DrawOf(Step(which)); }
    DrawSetup SetupOf(std::size_t which) const;
    bool LiesInScissor(std::size_t which) const;
    /// Returns whether the texel lies in this part of the targets.
    bool LiesIn(const ViewportRect& rect) const;
    /// Returns whether the draw reaches the texel with these faces culled.
    bool Reaches(std::size_t which, CullMode cull) const;
    /// Returns whether a fragment passes all tests, with this state in place of the draw's own.
    bool Passes(std::size_t which, const PipelineState& state) const;
    /// Returns the output of the draw's shader, or nothing if that is no colour.
    std::optional<std::vector<float>> OutputOf(std::size_t which) const;
    /// Returns the depth of the nearest fragment, 1 = near.
    float DepthOf(std::size_t which) const;

private:
    /// The steps from `begin` on, before `end`.
    struct Range
    {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    static constexpr std::size_t k_Channels = 4;
    using Reached = std::array<bool, k_Channels>;
    using Target = std::shared_ptr<const RenderTexture>;

    const CompiledRenderPass& pass() const { return m_Frame.passes[m_Pass]; }
    const PassStep& Step(std::size_t which) const { return m_Steps[m_Reaching[which]]; }
    const DrawCommand& DrawOf(const PassStep& step) const;
    /// Returns the draw of only this step and only this texel.
    DrawCommand AtTexel(const PassStep& step) const;
    RenderTextureDescriptor ProbeDescriptor(GraphicsFormat format) const;
    ViewportRect TexelRect() const;

    bool IsClear(const PassStep& step) const
    {
        return std::holds_alternative<ClearCommand>(pass().commands[step.command]);
    }
    /// Cuts a range into at most four.
    static void Split(const Range& range, std::vector<Range>& ranges);
    void FindReaching();
    /// Finds out which of at most four ranges reach the texel.
    Reached Cover(std::span<const Range> ranges, CullMode cull) const;
    void AddCover(FrameReplay& replay, const Range& range, int channel, CullMode cull) const;
    FrameReplay BeforePass() const;
    FrameReplay Begin(std::size_t count) const;
    void AddViewport(FrameReplay& replay, const PassStep& step) const;
    /// Adds the draw of only this step and only this texel, with a setup of its own.
    void AddAtTexel(FrameReplay& replay, const PassStep& step, DrawSetup setup) const;
    /// Runs the replay and returns what it leaves at the texel.
    std::vector<std::byte> TexelAfter(FrameReplay& replay, const Target& target) const;
    /// Draws into a target of its own, which is cleared to white, with the pass's depth.
    std::vector<std::byte> Draw(std::size_t which, const PipelineState& state,
                                GraphicsFormat format) const;
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
/// @param which    index into PassProbe::reaching
/// @param before   what the targets hold before the draw
/// @param isEmpty  true if the frame is known to have nothing there for the draw to show
std::pair<PixelFate, std::string> WhyUnchanged(const PassProbe& probe, std::size_t which,
                                               const TargetTexels& before, bool isEmpty);

/// Returns numbers as text: "(0.25, 0, 1)", or "0.25" for one.
std::string NumbersText(const std::vector<float>& numbers);

} // namespace limn
