// The camera's matrices, and what must come before a frame's draws.
#include "draw/DrawRecorder.h"
#include "draw/MatrixIds.h"
#include "draw/PerDraw.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <limn/core/Camera.h>

namespace limn
{

void DrawRecorder::SetMatrix(const SetViewCommand& command)
{
    SetViewProjection({command.view, m_Projection, false});
}

void DrawRecorder::SetMatrix(const SetProjectionCommand& command)
{
    SetViewProjection(
        {m_View, GpuProjection(command.projection, m_Frame.usesReversedZBuffer), false});
}

void DrawRecorder::ExpectUnused(const GraphicsBuffer& buffer, const char* call) const
{
    const auto uses = [&](const auto& setup)
    {
        return setup.bindings &&
               std::ranges::any_of(setup.bindings->buffers, [&](const BufferSlot& slot)
                                   { return slot.buffer.get() == &buffer; });
    };
    if (std::ranges::any_of(m_Frame.setups, uses) ||
        std::ranges::any_of(m_Frame.dispatchSetups, uses))
    {
        throw ContractError(std::string(call) + " of '" + buffer.name() +
                            "', which this frame uses already: what is set goes to the device "
                            "before the frame. Set it before its first use, or take two buffers");
    }
}

void DrawRecorder::SetViewProjection(const SetViewProjectionCommand& command)
{
    m_View = command.view;
    m_Projection = command.gpuProjection;
    const auto set = [&](ShaderPropertyId id, const ShaderPropertyValue& value)
    {
        SetGlobal({id, value});
    };
    const glm::dmat4 projection(command.gpuProjection);
    const glm::dvec4 origin = RelativeTo(m_Origin, command.view)[3];
    set(unity_MatrixV, glm::mat4(command.view));
    set(glstate_matrix_projection, command.gpuProjection);
    set(unity_MatrixVP, glm::mat4(projection * command.view));
    set(limn_OriginVS, glm::vec4(origin));
    set(limn_OriginCS, glm::vec4(projection * origin));
    if (command.inverses)
    {
        const glm::dmat4 viewToWorld = glm::inverse(command.view);
        const glm::dmat4 clipToView = glm::inverse(projection);
        set(unity_MatrixInvV, glm::mat4(viewToWorld));
        set(unity_MatrixInvP, glm::mat4(clipToView));
        set(unity_MatrixInvVP, glm::mat4(viewToWorld * clipToView));
    }
}

} // namespace limn
