#pragma once

#include "pipeline/RendererHarness.h"

#include <functional>
#include <limn/core/UniversalFrameData.h>

namespace limn::test
{

/// A pass that records what a test says.
class GraphPass final : public ScriptableRenderPass
{
public:
    using Recording = std::function<void(RenderGraph&, ContextContainer&)>;

    explicit GraphPass(Recording recording, std::string name = "Feature",
                       RenderPassEvent event = RenderPassEvent::AfterRenderingTransparents)
        : m_Recording(std::move(recording))
    {
        profilingSampler = ProfilingSampler(std::move(name));
        renderPassEvent = event;
    }

    void RecordRenderGraph(RenderGraph& renderGraph, ContextContainer& frameData) override
    {
        m_Recording(renderGraph, frameData);
    }

private:
    Recording m_Recording;
};

struct NoData
{
};

/// @param declare  of the builder
/// @param record   of the command buffer
template <typename Declare, typename Record>
void AddRaster(RenderGraph& graph, const char* name, Declare declare, Record record)
{
    NoData* data = nullptr;
    auto builder = graph.AddRasterRenderPass<NoData>(name, data);
    declare(builder);
    builder.SetRenderFunc([record](NoData&, RasterGraphContext& context) { record(context.cmd); });
}
template <typename Declare, typename Record>
void AddUnsafe(RenderGraph& graph, const char* name, Declare declare, Record record)
{
    NoData* data = nullptr;
    auto builder = graph.AddUnsafePass<NoData>(name, data);
    declare(builder);
    builder.SetRenderFunc([record](NoData&, UnsafeGraphContext& context) { record(context.cmd); });
}

/// A texture of the harness's size.
inline TextureDesc Desc(const char* name)
{
    TextureDesc desc(8, 4);
    desc.name = name;
    return desc;
}

/// Draws without textures.
inline std::shared_ptr<const Material> Plain()
{
    static const auto material = std::make_shared<const Material>(ShaderWithProgram(""));
    return material;
}
/// Samples _BlitTexture.
inline std::shared_ptr<const Material> Sampling()
{
    static const auto material = std::make_shared<const Material>(
        ShaderWithProgram("", "Texture2D _BlitTexture; SamplerState sampler_BlitTexture;",
                          "_BlitTexture.Sample(sampler_BlitTexture, 0.5)"));
    return material;
}

inline void Draw(BaseCommandBuffer& cmd, const std::shared_ptr<const Material>& material = Plain())
{
    CoreUtils::DrawFullScreen(cmd, material);
}
inline void Sample(BaseCommandBuffer& cmd, const RTHandle& texture)
{
    Blitter::BlitTexture(cmd, texture, {1, 1, 0, 0}, Sampling(), 0);
}

} // namespace limn::test
