#pragma once

#include "graph/RenderGraphPass.h"

#include <limn/core/RenderReport.h>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

/// Runs passes of a render graph, and compares what they did with what they declare. Where Unity
/// throws or draws something else, it is an error; all errors of a pass are reported at once. What
/// is not declared and yet drawn right in Unity is drawn right here, too, since the frame compiler
/// sees what is used; it becomes a note with the line that declares it. What is declared but not
/// used is a note as well.
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

    // These are for the pass's command buffer:
    void DrawRendererList(const RendererListHandle& list);
    /// Adds an error unless the pass may set globals.
    /// @param what  what the pass does, "sets ..."
    /// @param name  the name of what it sets; empty = none
    void ExpectGlobalsAllowed(std::string_view what, std::string_view name = {});
    /// Adds an error if the texture is one of the graph that the pass does not declare, as Unity's
    /// command buffers require it when they are given a handle.
    void ExpectDeclared(const RTHandle& texture, ShaderPropertyId id);

    /// Returns the texture that a camera's draws find under the name now; null = no render texture.
    static RTHandle GlobalTexture(const ScriptableRenderContext& context, ShaderPropertyId id);

private:
    void ExpectRunnable() const;
    void ResolveGlobals();
    void ExpectWritten();
    void Clear();
    void Bind();
    void Record();
    void Flush();
    void ExpectAsDeclared(std::size_t firstCommand);
    void ExpectTarget(const SetRenderTargetCommand* target);
    void ExpectTarget(const RenderTexture& texture);
    void ExpectReads(const DrawBindings& bindings, bool isDispatch);
    void ExpectWrites(const DrawBindings& bindings);
    void ExpectBuffers(const DrawBindings& bindings);
    void ExpectRunByUnity();
    void NoteNativeGlobal(std::string_view name);
    void NoteUnused(bool draws);
    void Finish();
    void Fail(std::string problem);
    /// Adds a note about a use that is not declared if Unity draws the same, else an error.
    /// @param otherwise  what happens in Unity then, ", for which Unity throws"
    /// @param line       declares the use
    void NoteOrFail(bool isDrawnRight, const std::string& what, const char* otherwise,
                    const std::string& line);
    void ThrowIfProblems();

    /// Returns whether the texture was global before the pass.
    bool wasGlobal(const Texture& texture) const;
    /// Returns whether in Unity a handle still stands for a texture in this pass, though it does
    /// not declare it.
    bool isAlive(const RenderGraphTexture& texture) const;
    bool isAlive(const RenderGraphBuffer& buffer) const;
    template <typename Resource>
    bool isDeclaredLater(const Resource& resource) const;
    /// Returns the line that declares it: "builder.UseTexture(resourceData.cameraNormalsTexture);"
    static std::string LineFor(const RenderGraphTexture& texture, AccessFlags flags);
    static std::string LineFor(const GraphicsBuffer& buffer, AccessFlags flags);
    std::string Subject() const { return "pass '" + m_Pass->name.name() + "'"; }

    const RenderGraph& m_Graph;
    RenderGraphState& m_State;
    ScriptableRenderContext& m_Context;
    RenderReport& m_Report;

    // These are of the pass that runs:
    RenderGraphPass* m_Pass = nullptr;
    CommandBuffer* m_Cmd = nullptr;
    PooledVector<std::size_t> m_DrawnLists;
    PooledVector<const Texture*> m_Sampled;
    PooledVector<const Texture*> m_Targets;        ///< drawn into, cleared or written by kernels
    PooledVector<const GraphicsBuffer*> m_Buffers; ///< the buffers that are bound
    std::vector<std::string> m_Problems;
    std::vector<std::string> m_RefusedGlobals; ///< names that were already reported
    /// The line that would keep Unity from leaving the pass out; "" = none.
    std::string m_LineToBeRun;
    PooledVector<ShaderPropertyId> m_SetHere; ///< globals that the pass set itself
    bool m_HasEffect = false;                 ///< it draws, writes or sets a global
};

} // namespace limn
