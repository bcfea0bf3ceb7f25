// The camera's matrices, and what must come before a frame's draws.
#include "material/PropertyValues.h"
#include "record/MatrixIds.h"
#include "resolve/DrawRecorder.h"
#include "scene/PerDraw.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <limn/core/Camera.h>
#include <limn/core/TargetOrientation.h>

namespace limn
{

void DrawRecorder::SetMatrix(const SetViewCommand& command)
{
    SetViewProjection({command.view, m_Projection, false});
}

void DrawRecorder::SetMatrix(const SetProjectionCommand& command)
{
    SetViewProjection(
        {m_View, GpuProjection(command.projection, m_Frame.usesReversedZBuffer, true), false});
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
        throw ContractError(std::string(call) + ": this frame uses '" + buffer.name() +
                            "' already, and the data go to the device before the frame; set them "
                            "before the first use, or use two buffers");
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
    const glm::mat4 gpuProjection =
        m_IsFlipped ? command.gpuProjection : WithFlippedY(command.gpuProjection);
    const glm::dmat4 projection(gpuProjection);
    const glm::dvec4 origin = RelativeTo(m_Origin, command.view)[3];
    set(unity_MatrixV, glm::mat4(command.view));
    set(glstate_matrix_projection, gpuProjection);
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

/// Turns over what shaders know of the camera, for a target of the other kind than the last one.
void DrawRecorder::TurnProjection()
{
    static const ShaderPropertyId _ProjectionParams{"_ProjectionParams"};
    static const ShaderPropertyId _ScaleBiasRt{"_ScaleBiasRt"};
    const auto change = [&]<typename Value>(ShaderPropertyId id, Value (*turned)(Value))
    {
        if (const auto* known = As<Value>(m_Globals.Find(id)))
        {
            SetGlobal({id, turned(*known)});
        }
    };
    for (const ShaderPropertyId toClip : {glstate_matrix_projection, unity_MatrixVP})
    {
        change(toClip, &WithFlippedY<glm::mat4>);
    }
    for (const ShaderPropertyId fromClip : {unity_MatrixInvP, unity_MatrixInvVP})
    {
        change(
            fromClip,
            +[](glm::mat4 matrix)
            {
                matrix[1] = -matrix[1];
                return matrix;
            });
    }
    const auto negatedY = +[](glm::vec4 v)
    {
        return glm::vec4(v.x, -v.y, v.z, v.w);
    };
    change(limn_OriginCS, negatedY);
    change(
        _ProjectionParams, +[](glm::vec4 v) { return glm::vec4(-v.x, v.y, v.z, v.w); });
    SetGlobal({_ScaleBiasRt, ScaleBiasRt(m_IsFlipped)});
}

} // namespace limn
