#pragma once

#include "graph/RenderGraphPass.h"

#include <limn/core/RenderReport.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// Runs passes of a render graph, and compares what they did with what they declare. What Unity
/// throws for or draws otherwise is an error, all of a pass at once. What is not declared and yet
/// drawn right there is so here, as the frame compiler sees what is used, and becomes a note with
/// the line that declares it; so does what is declared for nothing.
class RenderGraphRun
{
public:
    RenderGraphRun(const RenderGraph& graph, RenderGraphState& state,
                   ScriptableRenderContext& context, RenderReport& report)
        : m_Graph(graph), m_State(state), m_Context(context), m_Report(report)
    {
    }

    /// @throws ContractError with a line for each error
    void Run(RenderGraphPass& pass);

    // For the pass's command buffer:
    void DrawRendererList(const RendererListHandle& list);
    /// An error unless the pass may set globals.
    /// @param what  the pass does, "sets ..."
    /// @param name  of what; empty = none
    void ExpectGlobalsAllowed(std::string_view what, std::string_view name = {});
    /// An error if the texture is one of the graph that the pass does not declare, as Unity's
    /// command buffers ask for where a handle is given to them.
    void ExpectDeclared(const RTHandle& texture, ShaderPropertyId id);

    /// What a camera's draws find under the name now; null = no render texture.
    static RTHandle GlobalTexture(const ScriptableRenderContext& context, ShaderPropertyId id);

private:
    void ExpectRunnable() const;
    void ResolveGlobals();
    void ExpectWritten();
    void Clear();
    void Bind();
    void Record();
    template <typename Buffer, typename Pass>
    void RecordWith(Pass& pass);
    void Flush();
    void ExpectAsDeclared(std::size_t firstCommand);
    void ExpectTarget(const SetRenderTargetCommand* target);
    void ExpectTarget(const RenderTexture& texture);
    void ExpectReads(const DrawBindings& bindings, bool isDispatch);
    void ExpectWrites(const DrawBindings& bindings);
    void ExpectBuffers(const DrawBindings& bindings);
    void ExpectRunByUnity();
    void NoteNativeGlobal(std::string_view name);
    void NoteUnusedBuffers();
    void NoteUnused(bool draws);
    void Finish();
    void Fail(std::string problem);
    void ThrowIfProblems();

    /// Whether it was global before the pass.
    bool wasGlobal(const Texture& texture) const;
    /// Whether a handle still stands for a texture in this pass in Unity though it does not declare
    /// it.
    bool isAlive(const RenderGraphTexture& texture) const;
    bool isAlive(const RenderGraphBuffer& buffer) const;
    bool isDeclaredLater(const RTHandle& texture) const;
    /// "builder.UseTexture(resourceData.cameraNormalsTexture);"
    static std::string LineFor(const RenderGraphTexture& texture, AccessFlags flags);
    static std::string LineFor(const GraphicsBuffer& buffer, AccessFlags flags);
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
    std::vector<std::string> m_Problems;
    std::vector<std::string> m_RefusedGlobals; ///< names that were spoken of
    std::string m_LineToBeRun; ///< that would keep Unity from leaving the pass out; "" = none
    PooledVector<ShaderPropertyId> m_SetHere; ///< globals that the pass set itself
    bool m_HasEffect = false;                 ///< it draws, writes or sets a global
};

} // namespace limn
