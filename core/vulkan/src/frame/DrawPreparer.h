#pragma once

#include "frame/PreparedFrame.h"

namespace limn::vulkan
{

/// Looks up the objects that a frame's draws need, and makes those that do not exist yet.
/// Consecutive draws mostly have most of them in common; these are looked up once.
class DrawPreparer
{
public:
    /// @param number  the number of the frame's submission
    DrawPreparer(const VulkanContext& context, DeviceResources& resources,
                 FrameDescriptors& descriptors, const FrameTables& tables, std::uint64_t number,
                 PreparedFrame& frame);

    /// Begins a pass; the following draws are drawn into targets of these formats.
    /// @lifetime keeps `formats` until the next call
    void BeginPass(const CompiledRenderPass& pass, const TargetFormats& formats);

    /// Appends a draw to the frame's draws.
    /// @throws ContractError if the draw needs something that the frame, its mesh or the device
    ///     lacks
    void Add(const DrawCommand& draw);
    /// Appends a dispatch to the frame's dispatches.
    /// @throws ContractError as the other Add does
    void Add(const DispatchCommand& dispatch);

private:
    ImageFormats FormatsFor(const DispatchSetup& setup) const;
    void UseProgram(const DrawSetup& setup);
    void UseState(const DrawSetup& setup);
    void UseMesh(const DrawCommand& draw);
    void AddRuns(const DrawCommand& draw);
    PreparedArguments ArgumentsOf(const DrawBindings* bindings);

    const VulkanContext& m_Context;
    DeviceResources& m_Resources;
    FrameDescriptors& m_Descriptors;
    const FrameTables& m_Tables;
    std::uint64_t m_Number;
    PreparedFrame& m_Frame;
    const CompiledRenderPass* m_Pass = nullptr;
    const TargetFormats* m_Formats = nullptr; ///< the formats of m_Pass
    const DrawCommand* m_Last = nullptr;      ///< the last draw of this pass
    /// The program of the last draw, like the following members.
    ProgramObjects* m_Program = nullptr;
    bool m_HasBindings = false;
    PreparedDraw m_Draw;
    PreparedRun m_LastRun;         ///< the run of m_Last
    bool m_LastIsIndirect = false; ///< likewise
};

} // namespace limn::vulkan
