#include "draw/DrawResolver.h"
#include "draw/PerDraw.h"
#include "draw/ProjectedBounds.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <limn/core/DrawError.h>
#include <limn/core/ScriptableRenderContext.h>
#include <map>
#include <tuple>

namespace limn
{

namespace
{

std::shared_ptr<const Texture> TextureIn(const ShaderPropertyValue* value)
{
    const auto* texture = value ? std::get_if<std::shared_ptr<const Texture>>(value) : nullptr;
    return texture ? *texture : nullptr;
}

/// Of a number, vector or colour.
bool isZero(const ShaderPropertyValue& value)
{
    return std::visit(
        [](const auto& v)
        {
            using Value = std::decay_t<decltype(v)>;
            if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, glm::vec4>)
            {
                return v == Value(0);
            }
            else if constexpr (std::is_same_v<Value, Color>)
            {
                return v == Color::clear;
            }
            return false;
        },
        value);
}

/// Whether draws that differ in their transform may become instances of one. Only a vertex function
/// learns which instance it works on; and one that takes SV_InstanceID finds 0 in each draw.
bool isInstanceable(const ShaderProgram& program)
{
    const auto& buffers = program.layout.storageBuffers;
    return !(program.layout.pushStages & ShaderStage::Vertex) &&
           std::all_of(buffers.begin(), buffers.end(),
                       [](const StorageBufferBinding& buffer)
                       { return buffer.stages == ShaderStage::Vertex; });
}

bool Compiles(const Material& material, int pass)
{
    try
    {
        material.Compile(pass);
        return true;
    }
    catch (const AssetError&)
    {
        return false;
    }
}

} // namespace

/// Looks recorded draws up and appends them to the frame.
class ScriptableRenderContext::Resolver
{
public:
    Resolver(FrameCommands& frame, MaterialPropertyBlock& globals, RenderReport& report,
             const std::string& passName, const glm::dvec3& origin)
        : m_Frame(frame), m_Globals(globals), m_Origin(origin), m_Resolver(report.notes, passName)
    {
    }

    void SetGlobal(const SetGlobalCommand& command)
    {
        if (m_KeepsChanges)
        {
            const ShaderPropertyValue* before = m_Globals.Find(command.id);
            m_Changes.push_back({command.id, before ? std::optional(*before) : std::nullopt});
        }
        m_Globals.Set(command.id, command.value);
        ++m_GlobalsVersion;
    }

    Place MarkPlace()
    {
        m_KeepsChanges = true;
        return {m_Frame.commands.size(), m_Changes.size()};
    }

    /// Runs `record` with what was global at that place.
    void WithGlobalsOf(const Place& place, const std::function<void()>& record)
    {
        MaterialPropertyBlock now = m_Globals;
        const std::size_t count = m_Changes.size();
        for (std::size_t i = count; i-- > place.globalChange;)
        {
            const GlobalChange& change = m_Changes[i];
            if (change.before)
            {
                m_Globals.Set(change.id, *change.before);
            }
            else
            {
                m_Globals.Remove(change.id);
            }
        }
        ++m_GlobalsVersion;
        record();
        m_Changes.resize(count);
        m_Globals = std::move(now);
        ++m_GlobalsVersion;
    }

    bool Reads(const Texture& texture) const { return m_Resolver.HasBound(texture); }

    void SetViewProjection(const SetViewProjectionCommand& command)
    {
        const auto set = [&](const char* name, const ShaderPropertyValue& value)
        {
            SetGlobal({ShaderPropertyId(name), value});
        };
        const glm::dmat4 projection(command.gpuProjection);
        const glm::dvec4 origin = RelativeTo(m_Origin, command.view)[3];
        set("unity_MatrixV", glm::mat4(command.view));
        set("glstate_matrix_projection", command.gpuProjection);
        set("unity_MatrixVP", glm::mat4(projection * command.view));
        set("limn_OriginVS", glm::vec4(origin));
        set("limn_OriginCS", glm::vec4(projection * origin));
        if (command.inverses)
        {
            const glm::dmat4 viewToWorld = glm::inverse(command.view);
            const glm::dmat4 clipToView = glm::inverse(projection);
            set("unity_MatrixInvV", glm::mat4(viewToWorld));
            set("unity_MatrixInvP", glm::mat4(clipToView));
            set("unity_MatrixInvVP", glm::mat4(viewToWorld * clipToView));
        }
    }

    void Draw(const RecordedDraw& recorded)
    {
        Draw(recorded, MakePerDrawData(glm::dmat4(recorded.matrix),
                                       RenderingLayerMask::FromIndex(0), m_Origin));
    }

    /// @param perDraw  instead of the recorded matrix
    void Draw(const RecordedDraw& recorded, const PerDrawData& perDraw,
              const RenderStateBlock& stateBlock = RenderStateBlock())
    {
        const Material& material = *recorded.material;
        DrawCommand draw;
        draw.program = material.Compile(recorded.shaderPass);
        draw.shader = material.shader();
        draw.shaderPass = recorded.shaderPass;
        draw.state = Override(
            ResolveState(material.shader()->passState(recorded.shaderPass), material, m_Globals),
            stateBlock);
        ExpectStencil(draw.state, material, recorded.shaderPass);
        draw.bindings =
            m_Resolver.Resolve(draw.program, {&recorded.properties, &material, &m_Globals},
                               m_GlobalsVersion, m_Frame.uniformData);
        draw.fullScreen = Promise(recorded);
        draw.bounds = BoundsOf(recorded, perDraw);
        draw.mesh = recorded.mesh;
        draw.subMesh = recorded.subMesh;
        draw.vertexCount = recorded.vertexCount;
        draw.firstInstance = static_cast<std::uint32_t>(m_Frame.perDraw.size());
        m_Frame.perDraw.push_back(perDraw);
        const bool mirrored = perDraw.worldTransformParams[3] < 0.0f;
        // A shader that makes clip positions of its own, such as a full-screen triangle, counts on
        // Unity's render textures, which are upside down: counter-clockwise is the front there.
        draw.state.frontFaceFlipped = mirrored != (draw.mesh == nullptr);
        if (!MergeIntoLast(draw))
        {
            m_Frame.commands.emplace_back(std::move(draw));
        }
    }

    /// The material's values with another shader; the same one for the rest of the frame.
    std::shared_ptr<const Material> WithShader(const std::shared_ptr<const Material>& material,
                                               const std::shared_ptr<const Shader>& shader)
    {
        auto& result = m_WithShader[{material, material->version(), shader}];
        if (!result)
        {
            result = std::make_shared<const Material>(*material, shader);
        }
        return result;
    }

    void SetRenderTarget(const SetRenderTargetCommand& command)
    {
        m_Depth = command.depth;
        m_Frame.commands.emplace_back(command);
    }

private:
    /// Without any depth target the stencil test passes, as everywhere; one that lacks the stencil
    /// is a mistake in the set-up.
    void ExpectStencil(const PipelineState& state, const Material& material, int shaderPass) const
    {
        if (state.stencilEnabled && m_Depth && !HasStencil(m_Depth->graphicsFormat()))
        {
            throw DrawError("material '" + material.name() + "': pass " +
                            std::to_string(shaderPass) + " of shader '" +
                            material.shader()->name() +
                            "' uses the stencil, but the depth target '" + m_Depth->name() +
                            "' has the format " + ToString(m_Depth->graphicsFormat()) +
                            "; give it depthBufferBits 24 or 32");
        }
    }

    /// What the pass's LimnFullScreen tag comes to with the values of this draw.
    std::shared_ptr<const FullScreenPromise> Promise(const RecordedDraw& recorded) const
    {
        const FullScreenTag* tag = recorded.material->shader()->fullScreenTag(recorded.shaderPass);
        if (recorded.mesh || tag == nullptr)
        {
            return nullptr;
        }
        const PropertySources sources{&recorded.properties, recorded.material.get(), &m_Globals};
        auto promise = std::make_shared<FullScreenPromise>();
        promise->output = tag->output;
        for (const ShaderPropertyId id : tag->zeroes)
        {
            const ShaderPropertyValue* value = sources.Find(id);
            if (const auto texture = TextureIn(value))
            {
                promise->zeroTextures.push_back(texture);
            }
            else if (value && isZero(*value))
            {
                promise->zeroProperty = id.name();
            }
        }
        promise->reach = ReachOf(*tag, sources);
        promise->copied = tag->copied ? TextureIn(sources.Find(*tag->copied)) : nullptr;
        return promise;
    }

    static float ReachOf(const FullScreenTag& tag, const PropertySources& sources)
    {
        if (tag.reachProperty)
        {
            const ShaderPropertyValue* value = sources.Find(*tag.reachProperty);
            const auto* number = value ? std::get_if<float>(value) : nullptr;
            return number ? std::abs(*number) : -1.0f;
        }
        return tag.reach.value_or(-1.0f);
    }

    /// Where it draws, if the pass promises to stay within the mesh.
    std::optional<TargetRegion> BoundsOf(const RecordedDraw& recorded,
                                         const PerDrawData& perDraw) const
    {
        static const ShaderPropertyId unity_MatrixVP{"unity_MatrixVP"};
        const ShaderPropertyValue* value = m_Globals.Find(unity_MatrixVP);
        const auto* viewProjection = value ? std::get_if<glm::mat4>(value) : nullptr;
        if (!recorded.mesh || viewProjection == nullptr ||
            !recorded.material->shader()->staysWithinMesh(recorded.shaderPass))
        {
            return std::nullopt;
        }
        // As shaders do it: relative to the origin where that is not the world's.
        glm::mat4 relative = glm::make_mat4(perDraw.objectToWorld);
        glm::mat4 toClip = *viewProjection;
        static const ShaderPropertyId limn_OriginCS{"limn_OriginCS"};
        const ShaderPropertyValue* originCS = m_Globals.Find(limn_OriginCS);
        if (m_Origin != glm::dvec3(0.0) && originCS != nullptr)
        {
            relative[3] = glm::vec4(glm::make_vec3(perDraw.worldTransformParams), 1.0f);
            toClip[3] = std::get<glm::vec4>(*originCS);
        }
        return ProjectBounds(recorded.mesh->bounds(), relative, toClip);
    }

    /// Draws that differ in their transform only become instances of one.
    bool MergeIntoLast(const DrawCommand& draw)
    {
        auto* last =
            m_Frame.commands.empty() ? nullptr : std::get_if<DrawCommand>(&m_Frame.commands.back());
        if (last == nullptr || draw.mesh == nullptr || last->mesh != draw.mesh ||
            last->subMesh != draw.subMesh || last->program != draw.program ||
            last->bindings != draw.bindings || last->state != draw.state ||
            !isInstanceable(*draw.program))
        {
            return false;
        }
        ++last->instanceCount;
        last->bounds = last->bounds && draw.bounds
                           ? std::optional(Union(*last->bounds, *draw.bounds))
                           : std::nullopt;
        return true;
    }

    struct GlobalChange
    {
        ShaderPropertyId id;
        std::optional<ShaderPropertyValue> before; ///< nothing: it was not set
    };

    FrameCommands& m_Frame;
    MaterialPropertyBlock& m_Globals;
    std::vector<GlobalChange> m_Changes; ///< since the first place was marked
    bool m_KeepsChanges = false;
    std::uint64_t m_GlobalsVersion = 0;
    const glm::dvec3 m_Origin;
    std::shared_ptr<const RenderTexture> m_Depth; ///< of the bound target
    DrawResolver m_Resolver;
    std::map<
        std::tuple<std::shared_ptr<const Material>, std::uint64_t, std::shared_ptr<const Shader>>,
        std::shared_ptr<const Material>>
        m_WithShader;
};

ScriptableRenderContext::ScriptableRenderContext(RenderReport& report, const glm::dvec3& origin)
    : m_Report(report),
      m_Origin(origin),
      m_Resolver(std::make_unique<Resolver>(m_Frame, m_Globals, m_Report, m_PassName, m_Origin))
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
                    m_Resolver->Draw(c);
                }
                else if constexpr (std::is_same_v<Command, SetViewProjectionCommand>)
                {
                    m_Resolver->SetViewProjection(c);
                }
                else if constexpr (std::is_same_v<Command, SetGlobalCommand>)
                {
                    m_Resolver->SetGlobal(c);
                }
                else if constexpr (std::is_same_v<Command, SetRenderTargetCommand>)
                {
                    m_Resolver->SetRenderTarget(c);
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
                                            const FilteringSettings& filteringSettings,
                                            const RenderStateBlock& stateBlock)
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
        DrawItem(item, cullingResults.perDraw.at(item.perDraw), drawingSettings, stateBlock);
    }
}

void ScriptableRenderContext::DrawItem(const RendererItem& item, const PerDrawData& perDraw,
                                       const DrawingSettings& drawing,
                                       const RenderStateBlock& stateBlock)
{
    const MeshRenderer& renderer = *item.object->renderer;
    RecordedDraw draw{renderer.mesh, item.subMesh, 0, glm::mat4(1.0f), item.material, 0, {}};
    if (drawing.overrideMaterial)
    {
        draw.material = drawing.overrideMaterial;
        draw.shaderPass = drawing.overrideMaterialPassIndex;
        m_Resolver->Draw(draw, perDraw, stateBlock);
        return;
    }
    if (drawing.overrideShader)
    {
        draw.material = m_Resolver->WithShader(item.material, drawing.overrideShader);
        draw.shaderPass = drawing.overrideShaderPassIndex;
        m_Resolver->Draw(draw, perDraw, stateBlock);
        return;
    }
    for (const ShaderTagId tag : drawing.shaderTagIds)
    {
        draw.shaderPass = item.filter.shader->FindPassByLightMode(tag);
        if (draw.shaderPass < 0)
        {
            continue;
        }
        if (drawing.fallbackMaterial && !Compiles(*item.material, draw.shaderPass))
        {
            draw.material = drawing.fallbackMaterial;
            draw.shaderPass = 0;
            m_Resolver->Draw(draw, perDraw, stateBlock);
            return;
        }
        m_Resolver->Draw(draw, perDraw, stateBlock);
    }
}

ScriptableRenderContext::Place ScriptableRenderContext::MarkPlace()
{
    return m_Resolver->MarkPlace();
}

void ScriptableRenderContext::RecordAt(const Place& place, const std::function<void()>& record)
{
    std::vector<FrameCommand>& commands = m_Frame.commands;
    const auto count = static_cast<std::ptrdiff_t>(commands.size());
    m_Resolver->WithGlobalsOf(place, record);
    std::rotate(commands.begin() + static_cast<std::ptrdiff_t>(place.command),
                commands.begin() + count, commands.end());
}

bool ScriptableRenderContext::Reads(const Texture& texture) const
{
    return m_Resolver->Reads(texture);
}

FrameCommands ScriptableRenderContext::TakeCommands()
{
    m_Resolver = nullptr;
    FrameCommands result = std::move(m_Frame);
    m_Frame = {};
    m_Resolver = std::make_unique<Resolver>(m_Frame, m_Globals, m_Report, m_PassName, m_Origin);
    return result;
}

} // namespace limn
