#include "DrawResolver.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <limn/core/ScriptableRenderContext.h>

namespace limn
{

namespace
{

/// The inverse in double precision; all zero where there is none (a scale of zero), which leaves
/// normals zero instead of infinite.
glm::mat4 InverseOrZero(const glm::dmat4& matrix)
{
    const glm::mat4 inverse(glm::inverse(matrix));
    for (int column = 0; column < 4; ++column)
    {
        for (int row = 0; row < 4; ++row)
        {
            if (!std::isfinite(inverse[column][row]))
            {
                return glm::mat4(0.0f);
            }
        }
    }
    return inverse;
}

PerDrawData MakePerDrawData(const glm::mat4& localToWorld, RenderingLayerMask renderingLayers)
{
    const glm::dmat4 matrix(localToWorld);
    const glm::mat4 inverse = InverseOrZero(matrix);
    PerDrawData data{};
    std::memcpy(data.objectToWorld, glm::value_ptr(localToWorld), sizeof data.objectToWorld);
    std::memcpy(data.worldToObject, glm::value_ptr(inverse), sizeof data.worldToObject);
    data.worldTransformParams[3] = glm::determinant(glm::dmat3(matrix)) < 0.0 ? -1.0f : 1.0f;
    data.renderingLayer[0] = renderingLayers.bits;
    return data;
}

bool FragmentReadsPerDraw(const CompiledPass& pass)
{
    for (const StorageBufferBinding& buffer : pass.layout.storageBuffers)
    {
        if (buffer.stages & ShaderStage::Fragment)
        {
            return true;
        }
    }
    return false;
}

} // namespace

/// Looks recorded draws up and appends them to the frame.
class ScriptableRenderContext::Resolver
{
public:
    Resolver(FrameCommands& frame, MaterialPropertyBlock& globals)
        : m_Frame(frame), m_Globals(globals)
    {
    }

    void SetGlobal(const SetGlobalCommand& command)
    {
        m_Globals.Set(command.id, command.value);
        ++m_GlobalsVersion;
    }

    void Draw(const RecordedDraw& recorded, RenderingLayerMask renderingLayers)
    {
        const Material& material = *recorded.material;
        DrawCommand draw;
        draw.pass = material.Compile(recorded.shaderPass);
        draw.shader = material.shader();
        draw.shaderPass = recorded.shaderPass;
        draw.state =
            ResolveState(material.shader()->passState(recorded.shaderPass), material, m_Globals);
        draw.bindings = m_Resolver.Resolve(draw.pass, {&recorded.properties, &material, &m_Globals},
                                           m_GlobalsVersion, m_Frame.uniformData);
        draw.mesh = recorded.mesh;
        draw.subMesh = recorded.subMesh;
        draw.vertexCount = recorded.vertexCount;
        draw.firstInstance = static_cast<std::uint32_t>(m_Frame.perDraw.size());
        m_Frame.perDraw.push_back(MakePerDrawData(recorded.matrix, renderingLayers));
        const bool mirrored = m_Frame.perDraw.back().worldTransformParams[3] < 0.0f;
        // A shader that makes clip positions of its own, such as a full-screen triangle, counts on
        // Unity's render textures, which are upside down: counter-clockwise is the front there.
        draw.state.frontFaceFlipped = mirrored != (draw.mesh == nullptr);
        if (!MergeIntoLast(draw))
        {
            m_Frame.commands.emplace_back(std::move(draw));
        }
    }

private:
    /// Draws that differ in their transform only become instances of one. A fragment function that
    /// reads per-draw data finds it by the first instance, so those stay apart.
    bool MergeIntoLast(const DrawCommand& draw)
    {
        auto* last =
            m_Frame.commands.empty() ? nullptr : std::get_if<DrawCommand>(&m_Frame.commands.back());
        if (last == nullptr || draw.mesh == nullptr || last->mesh != draw.mesh ||
            last->subMesh != draw.subMesh || last->pass != draw.pass ||
            last->bindings != draw.bindings || last->state != draw.state ||
            FragmentReadsPerDraw(*draw.pass))
        {
            return false;
        }
        ++last->instanceCount;
        return true;
    }

    FrameCommands& m_Frame;
    MaterialPropertyBlock& m_Globals;
    std::uint64_t m_GlobalsVersion = 0;
    DrawResolver m_Resolver;
};

ScriptableRenderContext::ScriptableRenderContext(RenderReport& report)
    : m_Report(report), m_Resolver(std::make_unique<Resolver>(m_Frame, m_Globals))
{
}

ScriptableRenderContext::~ScriptableRenderContext() = default;

void ScriptableRenderContext::ExecuteCommandBuffer(const CommandBuffer& commandBuffer)
{
    for (const RecordedCommand& command : commandBuffer.commands())
    {
        std::visit(
            [&](const auto& c)
            {
                using Command = std::decay_t<decltype(c)>;
                if constexpr (std::is_same_v<Command, RecordedDraw>)
                {
                    m_Resolver->Draw(c, RenderingLayerMask::FromIndex(0));
                }
                else if constexpr (std::is_same_v<Command, SetGlobalCommand>)
                {
                    m_Resolver->SetGlobal(c);
                }
                else
                {
                    m_Frame.commands.emplace_back(c);
                }
            },
            command);
    }
}

void ScriptableRenderContext::DrawRenderers(const CullingResults& cullingResults,
                                            const DrawingSettings& drawingSettings,
                                            const FilteringSettings& filteringSettings)
{
    DrawRenderersReport report{m_PassName, filteringSettings, drawingSettings, {}};
    std::vector<int> drawn;
    for (std::size_t i = 0; i < cullingResults.items.size(); ++i)
    {
        const FilterVerdict verdict =
            Judge(cullingResults.items[i].filter, filteringSettings, drawingSettings);
        ++report.counts[static_cast<std::size_t>(verdict)];
        if (verdict == FilterVerdict::Drawn)
        {
            drawn.push_back(static_cast<int>(i));
        }
    }
    m_Report.draws.push_back(std::move(report));
    Sort(cullingResults.items, drawingSettings.sortingSettings, drawn);

    for (const int index : drawn)
    {
        const RendererItem& item = cullingResults.items[static_cast<std::size_t>(index)];
        const MeshRenderer& renderer = *item.object->renderer;
        RecordedDraw draw{renderer.mesh, item.subMesh, 0, item.localToWorld, item.material, 0, {}};
        if (drawingSettings.overrideMaterial)
        {
            draw.material = drawingSettings.overrideMaterial;
            draw.shaderPass = drawingSettings.overrideMaterialPassIndex;
            m_Resolver->Draw(draw, renderer.renderingLayerMask);
            continue;
        }
        for (const ShaderTagId tag : drawingSettings.shaderTagIds)
        {
            draw.shaderPass = item.filter.shader->FindPassByLightMode(tag);
            if (draw.shaderPass >= 0)
            {
                m_Resolver->Draw(draw, renderer.renderingLayerMask);
            }
        }
    }
}

FrameCommands ScriptableRenderContext::TakeCommands()
{
    m_Resolver = nullptr;
    FrameCommands result = std::move(m_Frame);
    m_Frame = {};
    m_Resolver = std::make_unique<Resolver>(m_Frame, m_Globals);
    return result;
}

} // namespace limn
