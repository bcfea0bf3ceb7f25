#pragma once

#include "explain/pixel/PassProbe.h"
#include "explain/pixel/PixelHistory.h"

#include <limn/core/RenderReport.h>
#include <map>
#include <set>

namespace limn
{

/// A recorded frame, and what it shows.
struct TracedFrame
{
    const CompiledFrame& frame;
    const RenderReport& report;
    const std::vector<const GameObject*>& objects; ///< all objects of the scene
    std::shared_ptr<const RenderTexture> output;
    std::shared_ptr<ShaderCompiler> compiler;
};

/// Goes through a frame's passes and finds out what each does at one pixel.
class FrameTrace
{
public:
    /// @param history  has the pixel and the size; receives all that passes do
    FrameTrace(TracedFrame traced, VulkanDevice& device, PixelHistory& history);

    void Run(const std::function<void(const std::string&)>& progress);

    /// Returns the objects that passes of the picture draw, as indices in the scene.
    const std::set<std::uint32_t>& drawn() const { return m_Drawn; }
    /// Returns the objects of drawn() that reach the pixel.
    const std::set<std::uint32_t>& reaching() const { return m_Reaching; }

private:
    using Texels = std::vector<std::byte>;
    /// The texel of a texture at the pixel's place.
    struct Known
    {
        Texels texel;
        Texels stencil;
    };

    bool IsPicture(const Texture& texture) const;
    std::pair<int, int> PlaceIn(const Texture& texture) const;
    bool IsElsewhere(const CompiledRenderPass& pass);
    void FindRun();

    void TraceDraws(std::size_t pass);
    void TraceDispatches(std::size_t pass);
    void TraceWrite(std::size_t pass, const DispatchSetup& setup,
                    const std::shared_ptr<const RenderTexture>& texture);
    TargetTexels BeforeFirst(const CompiledRenderPass& pass, const PassProbe& probe) const;
    void Remember(const CompiledRenderPass& pass, const TargetTexels& texels);
    void CountSteps(const CompiledRenderPass& pass, const PassProbe& probe);
    void AddUncovered(const PassStep& step, const DrawSetup& setup);
    void AddClear(const CompiledRenderPass& pass, const TargetTexels& first);
    PixelEvent EventOf(const CompiledRenderPass& pass, const PassProbe& probe, std::size_t which);
    void AddValues(const CompiledRenderPass& pass, const TargetTexels& before,
                   const TargetTexels& after, PixelEvent& event) const;
    void ExplainUnchanged(const PassProbe& probe, std::size_t which, const TargetTexels& before,
                          PixelEvent& event) const;
    PixelValue ValueIn(const RenderTexture& texture, GraphicsFormat format, const Texels& before,
                       const Texels& after) const;
    std::string MaterialOf(const DrawSetup& setup, const DrawCommand& draw, const std::string& pass,
                           const std::set<std::uint32_t>& objects) const;
    std::set<std::uint32_t> ObjectsOf(const DrawCommand& draw, const PassStep& step) const;

    TracedFrame m_Traced;
    VulkanDevice& m_Device;
    PixelHistory& m_History;
    CoverPrograms m_Covers;
    std::map<std::uint64_t, Known> m_Known; ///< by Texture::id
    /// The draws that the device runs for `limn render`, by DrawCommand::firstInstance, with the
    /// part of the target that each is drawn into.
    std::map<std::uint32_t, std::optional<ViewportRect>> m_Run;
    std::set<std::uint32_t> m_Drawn;
    std::set<std::uint32_t> m_Reaching;
};

} // namespace limn
