#pragma once

#include "graph/RenderGraphPass.h"

#include <limn/core/RenderReport.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// Runs passes of a render graph, and compares what they did with what they declare.
class RenderGraphRun
{
public:
    RenderGraphRun(const RenderGraph& graph, RenderGraphState& state,
                   ScriptableRenderContext& context, RenderReport& report)
        : m_Graph(graph), m_State(state), m_Context(context), m_Report(report)
    {
    }

    /// @throws ContractError for what Unity would draw wrongly. What is declared for nothing
    /// becomes
    ///         a note
    void Run(RenderGraphPass& pass);

    // For the pass's command buffer:
    void DrawRendererList(const RendererListHandle& list);
    /// @param what  the pass does, "sets ..."
    /// @param name  of what; empty = none
    void ExpectGlobalsAllowed(std::string_view what, std::string_view name = {}) const;

    /// What a camera's draws find under the name now; null = no render texture.
    static RTHandle GlobalTexture(const ScriptableRenderContext& context, ShaderPropertyId id);

private:
    void ExpectRunnable() const;
    void ResolveGlobals();
    void ExpectWritten() const;
    void Clear();
    void Bind();
    void Record();
    void Flush();
    void ExpectAsDeclared(std::size_t firstCommand);
    void ExpectTarget(const SetRenderTargetCommand* target);
    void ExpectReads(const DrawBindings& bindings);
    void ExpectWrites(const DrawBindings& bindings);
    void ExpectBuffers(const DrawBindings& bindings);
    void NoteUnusedBuffers();
    void NoteUnused(bool draws);
    void Finish();
    std::string Subject() const { return "pass '" + m_Pass->name.name() + "'"; }

    const RenderGraph& m_Graph;
    RenderGraphState& m_State;
    ScriptableRenderContext& m_Context;
    RenderReport& m_Report;

    // Of the pass that runs:
    RenderGraphPass* m_Pass = nullptr;
    CommandBuffer* m_Cmd = nullptr;
    PooledVector<std::size_t> m_DrawnLists;
    PooledVector<const Texture*> m_Sampled;
    PooledVector<const Texture*> m_Targets;        ///< drawn into, cleared or written by kernels
    PooledVector<const GraphicsBuffer*> m_Buffers; ///< bound
};

} // namespace limn
