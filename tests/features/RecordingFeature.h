#pragma once

#include <functional>
#include <limn/core/RenderGraph.h>
#include <limn/core/ScriptableRenderPass.h>
#include <limn/core/ScriptableRenderer.h>
#include <limn/core/ScriptableRendererFeature.h>

namespace limn::test
{

/// Records what a test wants, in one pass.
class RecordingFeature final : public ScriptableRendererFeature
{
public:
    using Record = std::function<void(CommandBuffer&, RenderingData&)>;

    RecordingFeature(RenderPassEvent event, Record record, const char* passName = nullptr)
        : m_Pass(std::move(record))
    {
        m_Pass.renderPassEvent = event;
        if (passName != nullptr)
        {
            m_Pass.profilingSampler = ProfilingSampler(passName);
        }
    }
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    class Pass final : public ScriptableRenderPass
    {
    public:
        explicit Pass(Record record) : m_Record(std::move(record)) {}
        void Execute(ScriptableRenderContext& context, RenderingData& data) override
        {
            const CommandBufferPool::Pooled cmd = CommandBufferPool::Get();
            m_Record(*cmd, data);
            context.ExecuteCommandBuffer(*cmd);
        }

    private:
        Record m_Record;
    };
    Pass m_Pass;
};

/// The same in a render graph.
class GraphRecordingFeature final : public ScriptableRendererFeature
{
public:
    using Record = std::function<void(RenderGraph&, ContextContainer&)>;

    GraphRecordingFeature(RenderPassEvent event, Record record) : m_Pass(std::move(record))
    {
        m_Pass.renderPassEvent = event;
    }
    void Create() override {}
    void AddRenderPasses(ScriptableRenderer& renderer, RenderingData&) override
    {
        renderer.EnqueuePass(m_Pass);
    }

private:
    class Pass final : public ScriptableRenderPass
    {
    public:
        explicit Pass(Record record) : m_Record(std::move(record)) {}
        void RecordRenderGraph(RenderGraph& graph, ContextContainer& frameData) override
        {
            m_Record(graph, frameData);
        }

    private:
        Record m_Record;
    };
    Pass m_Pass;
};

} // namespace limn::test
