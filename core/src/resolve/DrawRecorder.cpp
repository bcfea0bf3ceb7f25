#include "resolve/DrawRecorder.h"

#include "cull/ProjectedBounds.h"
#include "material/FrameGlobals.h"
#include "material/PropertyValues.h"
#include "record/MatrixIds.h"
#include "scene/PerDraw.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <limn/base/Lists.h>
#include <limn/core/Camera.h>
#include <limn/core/DrawError.h>
#include <limn/core/TargetOrientation.h>

namespace limn
{

namespace
{

/// Returns whether a number, vector or colour is 0.
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

float ReachOf(const FullScreenTag& tag, const PropertySources& sources)
{
    if (tag.reachProperty)
    {
        const auto* number = std::get_if<float>(sources.Find(*tag.reachProperty));
        return number ? std::abs(*number) : -1.0f;
    }
    return tag.reach.value_or(-1.0f);
}

/// @throws DrawError if the geometry function of the material's shader takes other primitives
void ExpectTopology(MeshTopology drawn, GeometryInput taken, const Material& material)
{
    static constexpr const char* k_Taken[] = {nullptr,     "points",
                                              "lines",     "lines with neighbours",
                                              "triangles", "triangles with neighbours"};
    const bool isOfPoints = drawn == MeshTopology::Points;
    const bool isOfLines = drawn == MeshTopology::Lines || drawn == MeshTopology::LineStrip;
    const GeometryInput fitting = isOfPoints  ? GeometryInput::Point
                                  : isOfLines ? GeometryInput::Line
                                              : GeometryInput::Triangle;
    if (taken == GeometryInput::None || taken == fitting)
    {
        return;
    }
    throw DrawError("material '" + material.name() +
                    "': the geometry function of its shader takes " +
                    k_Taken[static_cast<std::size_t>(taken)] + ", but " +
                    (isOfPoints  ? "points are drawn"
                     : isOfLines ? "lines are drawn"
                                 : "triangles are drawn; write 'triangle' and an array of 3"));
}

/// Returns the indices that draw quads of four vertices as triangles. All vertices are at 0, since
/// draws of MeshTopology::Quads have no other data than SV_VertexID.
std::shared_ptr<const Mesh> MakeQuads(std::uint32_t count)
{
    MeshData data;
    data.vertices.resize(std::size_t{count} * 4);
    data.triangles.reserve(std::size_t{count} * 6);
    for (std::uint32_t i = 0; i < count; ++i)
    {
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        {
            data.triangles.push_back(i * 4 + corner);
        }
    }
    return std::make_shared<const Mesh>("Quads", std::move(data));
}

/// Returns the number of a setup, which is added unless it is that of the draw before.
template <typename Setup>
std::uint32_t AddSetup(std::vector<Setup>& setups, Setup setup)
{
    if (setups.empty() || setups.back() != setup)
    {
        setups.push_back(std::move(setup));
    }
    return static_cast<std::uint32_t>(setups.size() - 1);
}

/// Returns whether the draw is that of a mesh somewhere in the scene.
bool isPlaced(const RecordedDraw& draw)
{
    return draw.mesh && !draw.isBlit && !draw.isProcedural;
}

} // namespace

bool isInstanceable(const ShaderProgram& program)
{
    const auto& buffers = program.layout.storageBuffers;
    return !(program.layout.pushStages & ShaderStage::Vertex) &&
           std::ranges::all_of(buffers,
                               [](const auto& b) { return b.stages == ShaderStage::Vertex; });
}

void DrawRecorder::Begin(std::vector<std::string>& notes, const glm::dvec3& origin)
{
    m_Globals.Clear();
    m_Changes.clear();
    m_KeepsChanges = false;
    ++m_GlobalsVersion;
    m_AreKeywordsOld = true;
    m_Origin = origin;
    m_State = {};
    m_ObjectLights.Begin({}, 0);
    m_ShaderGlobalsVersion = 0;
    m_ShaderGlobals.clear();
    m_Notes = &notes;
    m_Target = nullptr;
    m_Depth = nullptr;
    m_IsFlipped = true;
    if (std::exchange(m_HasDraws, false))
    {
        EraseUnused(m_MeshPlaces);
        EraseUnused(m_WithShader);
        EraseUnused(m_Quads);
        m_Promises.resize(std::exchange(m_PromiseCount, 0));
    }
    m_Resolver.Begin(notes);
}

void DrawRecorder::BeginCamera()
{
    m_State = {};
    m_IsFlipped = true; // as its uniforms are set; its first target may turn them
    ++m_GlobalsVersion; // what the last camera's draws have bound, this one's have to bind anew
    m_Resolver.BeginCamera();
}

void DrawRecorder::SetGlobal(const SetGlobalCommand& command)
{
    const FrameGlobals::Place place = m_Globals.PlaceOf(command.id);
    if (m_KeepsChanges)
    {
        const ShaderPropertyValue* before = m_Globals.At(place);
        m_Changes.push_back({place, before ? std::optional(*before) : std::nullopt});
    }
    m_Globals.Set(place, command.value);
    ++m_GlobalsVersion;
}

void DrawRecorder::SetKeyword(const SetKeywordCommand& command)
{
    const auto place =
        std::ranges::lower_bound(m_KnownKeywords, command.keyword.name(), {}, &GlobalKeyword::name);
    if (place == m_KnownKeywords.end() || *place != command.keyword)
    {
        m_KnownKeywords.insert(place, command.keyword);
    }
    SetGlobal({command.keyword.id(), command.isOn ? 1 : 0});
    m_AreKeywordsOld = true;
}

std::span<const std::string> DrawRecorder::keywords()
{
    if (!std::exchange(m_AreKeywordsOld, false))
    {
        return std::span(m_Keywords).first(m_KeywordCount);
    }
    // Most frames have those of the one before: the texts stay.
    std::size_t count = 0;
    for (const GlobalKeyword& keyword : m_KnownKeywords)
    {
        const ShaderPropertyValue* isOn = m_Globals.Find(keyword.id());
        if (isOn == nullptr || *isOn != ShaderPropertyValue(1))
        {
            continue;
        }
        m_Keywords.resize(std::max(m_Keywords.size(), count + 1));
        if (m_Keywords[count] != keyword.name())
        {
            m_Keywords[count] = keyword.name();
        }
        ++count;
    }
    m_KeywordCount = count;
    return std::span(m_Keywords).first(count);
}

void DrawRecorder::TakeShaderGlobals()
{
    const std::uint64_t version = ShaderGlobals::version();
    if (std::exchange(m_ShaderGlobalsVersion, version) == version)
    {
        return;
    }
    ShaderGlobals::ForEach(
        [&](ShaderPropertyId id, const ShaderPropertyValue& value)
        {
            const ShaderPropertyValue* now = m_Globals.Find(id);
            const auto taken = m_ShaderGlobals.find(id);
            if (now == nullptr || (taken != m_ShaderGlobals.end() && *now == taken->second))
            {
                Take(id, value);
                m_ShaderGlobals[id] = value;
            }
        });
}

void DrawRecorder::Take(ShaderPropertyId id, const ShaderPropertyValue& value)
{
    if (const std::optional<GlobalKeyword> keyword = GlobalKeyword::OfId(id))
    {
        SetKeyword({*keyword, value == ShaderPropertyValue(1)});
    }
    else
    {
        SetGlobal({id, value});
    }
}

DrawRecorder::Place DrawRecorder::MarkPlace()
{
    m_KeepsChanges = true;
    return {m_Frame.commands.size(), m_Changes.size(), m_State};
}

void DrawRecorder::WithGlobalsOf(const Place& place, const std::function<void()>& record)
{
    const std::size_t count = m_Changes.size();
    UndoChanges(place.globalChange, count);
    ++m_GlobalsVersion;
    m_AreKeywordsOld = true;
    const CommonDrawState state = std::exchange(m_State, place.state);
    record();
    m_State = state;
    UndoChanges(count, m_Changes.size());
    m_Changes.resize(count);
    for (std::size_t i = place.globalChange; i < count; ++i)
    {
        m_Globals.Swap(m_Changes[i].place, m_Changes[i].other);
    }
    ++m_GlobalsVersion;
    m_AreKeywordsOld = true;
}

/// Gives the globals back the values that they had before these changes.
void DrawRecorder::UndoChanges(std::size_t begin, std::size_t end)
{
    for (std::size_t i = end; i-- > begin;)
    {
        m_Globals.Swap(m_Changes[i].place, m_Changes[i].other);
    }
}

DrawSetup DrawRecorder::LookUp(const Material& material, int shaderPass,
                               const DrawProperties& properties, const RenderStateBlock& stateBlock,
                               const RecordedDraw* recorded)
{
    m_HasDraws = true;
    ExpectSameDepth(material);
    DrawSetup draw;
    const bool isProcedural = recorded != nullptr && recorded->isProcedural;
    draw.program = material.Compile(shaderPass, isProcedural ? ProceduralKeywords() : keywords());
    ExpectTopology(recorded != nullptr ? recorded->topology : MeshTopology::Triangles,
                   draw.program->layout.geometryInput, material);
    draw.shader = material.shader();
    draw.shaderPass = shaderPass;
    draw.state = Override(m_Resolver.StateOf(material, shaderPass), stateBlock);
    draw.state.offsetUnits += m_State.depthBias;
    draw.state.offsetFactor += m_State.slopeDepthBias;
    ExpectStencil(draw.state, material, shaderPass);
    PropertySources sources{properties.own, &material, &m_Globals};
    sources.lights = recorded != nullptr ? LightsOf(*recorded, *draw.program) : properties.lights;
    sources.arguments =
        recorded != nullptr && recorded->arguments.buffer ? &recorded->arguments : nullptr;
    draw.bindings =
        m_Resolver.Resolve(draw.program, sources, m_GlobalsVersion, m_Frame.uniformData);
    return draw;
}

std::span<const std::string> DrawRecorder::ProceduralKeywords()
{
    const std::span<const std::string> all = keywords();
    m_ProceduralKeywords.resize(all.size() + 1);
    std::ranges::merge(all, std::span(&k_ProceduralInstancing, 1), m_ProceduralKeywords.begin());
    return m_ProceduralKeywords;
}

const MaterialPropertyBlock* DrawRecorder::LightsOf(const RecordedDraw& recorded,
                                                    const ShaderProgram& program)
{
    if (!isPlaced(recorded) || !m_ObjectLights.isNeeded() || !ReadsObjectLights(program))
    {
        return nullptr;
    }
    const Bounds& bounds = recorded.mesh->bounds();
    const glm::dmat4& world = recorded.matrix;
    glm::dvec3 extent(0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
        extent += glm::abs(glm::dvec3(world[axis])) * static_cast<double>(bounds.extents[axis]);
    }
    const glm::dvec3 center(world * glm::dvec4(bounds.center, 1.0));
    return &m_ObjectLights.ValuesOf(m_ObjectLights.Find(center, extent));
}

const std::shared_ptr<const Mesh>& DrawRecorder::QuadIndices(std::uint32_t count)
{
    Quads& quads = m_Quads[count];
    quads.isUsed = true;
    if (!quads.mesh)
    {
        quads.mesh = MakeQuads(count);
    }
    return quads.mesh;
}

std::uint32_t DrawRecorder::Add(DrawSetup setup)
{
    return AddSetup(m_Frame.setups, std::move(setup));
}

std::uint32_t DrawRecorder::Add(const std::shared_ptr<const Mesh>& mesh)
{
    if (!mesh)
    {
        return DrawCommand::k_NoMesh;
    }
    MeshPlace& place = m_MeshPlaces[mesh.get()];
    if (!std::exchange(place.isUsed, true))
    {
        place.index = static_cast<std::uint32_t>(m_Frame.meshes.size());
        m_Frame.meshes.push_back(mesh);
    }
    return place.index;
}

void DrawRecorder::Draw(const RecordedDraw& recorded, const MaterialPropertyBlock* properties)
{
    DrawSetup setup = LookUp(*recorded.material, recorded.shaderPass, {properties},
                             RenderStateBlock(), &recorded);
    const PerDrawData perDraw =
        MakePerDrawData(recorded.matrix, recorded.renderingLayers, m_Origin);
    setup.fullScreen = Promise(recorded, properties, setup.state);
    if (recorded.isBlit && !m_Depth)
    {
        NoteMissingDepth(setup.state, *recorded.material, recorded.shaderPass);
    }
    DrawCommand draw;
    draw.scissor = m_State.scissor;
    if (isPlaced(recorded) && setup.shader->staysWithinMesh(setup.shaderPass))
    {
        draw.bounds = Project(recorded.mesh->bounds(), recorded.mesh->boundingRadius(), perDraw);
    }
    const bool isOfQuads = recorded.topology == MeshTopology::Quads;
    draw.mesh = Add(isOfQuads ? QuadIndices(recorded.vertexCount / 4) : recorded.mesh);
    draw.subMesh = recorded.subMesh;
    draw.vertexCount = recorded.vertexCount;
    draw.firstInstance = static_cast<std::uint32_t>(m_Frame.instances.size());
    draw.instanceCount = recorded.instanceCount;
    m_Frame.instances.insert(m_Frame.instances.end(), recorded.instanceCount,
                             static_cast<std::uint32_t>(m_Frame.perDraw.size()));
    m_Frame.perDraw.push_back(perDraw);
    const bool isMirrored = perDraw.worldTransformParams[3] < 0.0f;
    setup.state.topology = isOfQuads ? MeshTopology::Triangles : recorded.topology;
    setup.state.frontFaceFlipped = FlipsFrontFace(isMirrored);
    draw.setup = Add(std::move(setup));
    if (recorded.isProcedural || !recorded.mesh || !MergeIntoLast(draw))
    {
        m_Frame.commands.emplace_back(draw);
    }
}

void DrawRecorder::Dispatch(const RecordedDispatch& recorded)
{
    const ComputeShader& shader = *recorded.shader;
    Dispatch(recorded,
             {&shader.kernelValues(recorded.kernel), nullptr, &m_Globals, &shader, recorded.kernel,
              recorded.arguments.buffer ? &recorded.arguments : nullptr});
}

void DrawRecorder::Dispatch(const RecordedDispatch& recorded, const PropertySources& sources)
{
    DispatchSetup setup;
    setup.program = recorded.shader->Compile(recorded.kernel, keywords());
    setup.shader = recorded.shader;
    setup.kernel = recorded.kernel;
    setup.bindings = m_Resolver.Resolve(setup.program, sources, m_Frame.uniformData);
    m_Frame.commands.emplace_back(DispatchCommand{
        AddSetup(m_Frame.dispatchSetups, std::move(setup)), recorded.groups, false, false});
}

std::optional<TargetRegion> DrawRecorder::Project(const Bounds& bounds, float radius,
                                                  const PerDrawData& perDraw) const
{
    const auto* viewProjection = std::get_if<glm::mat4>(m_Globals.Find(unity_MatrixVP));
    if (viewProjection == nullptr)
    {
        return std::nullopt;
    }
    // This computes as shaders do: relative to the origin, if that is not the world's.
    glm::mat4 relative = glm::make_mat4(perDraw.objectToWorld);
    glm::mat4 toClip = *viewProjection;
    const ShaderPropertyValue* originCS = m_Globals.Find(limn_OriginCS);
    if (m_Origin != glm::dvec3(0.0) && originCS != nullptr)
    {
        relative[3] = glm::vec4(glm::make_vec3(perDraw.worldTransformParams), 1.0f);
        toClip[3] = std::get<glm::vec4>(*originCS);
    }
    return ProjectBounds(bounds, radius, relative, toClip);
}

std::shared_ptr<const Material>
DrawRecorder::WithShader(const std::shared_ptr<const Material>& material,
                         const std::shared_ptr<const Shader>& shader)
{
    Variant& result = m_WithShader[{material, material->version(), shader}];
    result.isUsed = true;
    if (!result.material)
    {
        result.material = std::make_shared<const Material>(*material, shader);
    }
    return result.material;
}

void DrawRecorder::SetRenderTarget(const SetRenderTargetCommand& command)
{
    m_Depth = command.depth;
    m_Frame.commands.emplace_back(command);
    m_Target = command.colors.empty() ? command.depth.get() : command.colors.front().get();
    if (IsProjectionFlipped(*m_Target) != m_IsFlipped)
    {
        m_IsFlipped = !m_IsFlipped;
        TurnProjection();
    }
}

/// A shader of another compiler than the renderer's may take near for far.
void DrawRecorder::ExpectSameDepth(const Material& material) const
{
    if (material.shader()->usesReversedZBuffer() != m_Frame.usesReversedZBuffer)
    {
        const auto text = [](bool isReversed)
        {
            return isReversed ? "1 near ... 0 far" : "0 near ... 1 far";
        };
        throw DrawError("material '" + material.name() + "': shader '" + material.shader()->name() +
                        "' is compiled for depths of " + text(!m_Frame.usesReversedZBuffer) +
                        ", but the frame has " + text(m_Frame.usesReversedZBuffer) +
                        "; give it the renderer's shaderCompiler()");
    }
}

/// Without any depth target the stencil test passes, as everywhere; one that lacks the stencil
/// is a mistake in the set-up.
void DrawRecorder::ExpectStencil(const PipelineState& state, const Material& material,
                                 int shaderPass) const
{
    if (state.stencilEnabled && m_Depth && !HasStencil(m_Depth->graphicsFormat()))
    {
        throw DrawError("material '" + material.name() + "': pass " + std::to_string(shaderPass) +
                        " of shader '" + material.shader()->name() +
                        "' uses the stencil, but the depth target '" + m_Depth->name() +
                        "' has the format " + ToString(m_Depth->graphicsFormat()) +
                        "; give it depthBufferBits 24 or 32");
    }
}

/// Adds a note, once a frame, that a blit tests depth or stencil which its target does not have.
/// Passes without a ZTest have LEqual; a blit lies at the near plane, where that always passes.
void DrawRecorder::NoteMissingDepth(const PipelineState& state, const Material& material,
                                    int shaderPass)
{
    const bool testsStencil =
        state.stencilEnabled && (state.stencilFront.compare != CompareFunction::Always ||
                                 state.stencilBack.compare != CompareFunction::Always);
    const bool testsDepth = state.zTest != CompareFunction::Disabled &&
                            state.zTest != CompareFunction::Always &&
                            state.zTest != CompareFunction::LessEqual;
    if (m_Target == nullptr || !(testsStencil || testsDepth))
    {
        return;
    }
    std::string note = "Blit: pass " + std::to_string(shaderPass) + " of shader '" +
                       material.shader()->name() + "' tests the " +
                       (testsStencil ? "stencil" : "depth") + ", but the target '" +
                       m_Target->name() +
                       "' has none, so the test passes everywhere. Blit into "
                       "BuiltinRenderTextureType::CameraTarget or into a texture made with "
                       "depthBufferBits, or bind colour and depth and blit to CurrentActive. "
                       "The camera's colour has a depth in URP 7 to 11: where the feature is "
                       "written for one of those, set pipelineVersion to it";
    AddOnce(note, *m_Notes);
}

/// Returns whether it can be a draw over the whole of the target.
bool DrawRecorder::MayCover(const RecordedDraw& recorded, const PipelineState& state) const
{
    return (!recorded.mesh || recorded.isBlit) && !recorded.arguments.buffer && !m_State.scissor &&
           recorded.topology == MeshTopology::Triangles &&
           (!m_State.invertsCulling || state.cull == CullMode::Off);
}

/// Returns the promise of the pass's LimnFullScreen tag for the values of this draw.
std::shared_ptr<const FullScreenPromise>
DrawRecorder::Promise(const RecordedDraw& recorded, const MaterialPropertyBlock* properties,
                      const PipelineState& state)
{
    const FullScreenTag* tag = recorded.material->shader()->fullScreenTag(recorded.shaderPass);
    if (tag == nullptr || !MayCover(recorded, state))
    {
        return nullptr;
    }
    const PropertySources sources{properties, recorded.material.get(), &m_Globals};
    FullScreenPromise promise;
    promise.output = tag->output;
    for (const ShaderPropertyId id : tag->zeroes)
    {
        const ShaderPropertyValue* value = sources.Find(id);
        if (const auto texture = CopyOf<std::shared_ptr<const Texture>>(value);
            texture && !promise.zeroTextures.full())
        {
            promise.zeroTextures.push_back(texture);
        }
        else if (value && isZero(*value))
        {
            promise.zeroProperty = id;
        }
    }
    promise.reach = ReachOf(*tag, sources);
    promise.copied =
        tag->copied ? CopyOf<std::shared_ptr<const Texture>>(sources.Find(*tag->copied)) : nullptr;
    m_Promises.resize(std::max(m_Promises.size(), m_PromiseCount + 1));
    auto& kept = m_Promises[m_PromiseCount++];
    if (!kept || *kept != promise)
    {
        kept = std::make_shared<const FullScreenPromise>(std::move(promise));
    }
    return kept;
}

/// Draws that differ in their transform only become instances of one.
bool DrawRecorder::MergeIntoLast(const DrawCommand& draw)
{
    auto* last =
        m_Frame.commands.empty() ? nullptr : std::get_if<DrawCommand>(&m_Frame.commands.back());
    if (last == nullptr || draw.mesh == DrawCommand::k_NoMesh || last->mesh != draw.mesh ||
        last->subMesh != draw.subMesh || last->drawsObjects != draw.drawsObjects ||
        last->setup != draw.setup || last->scissor != draw.scissor ||
        !isInstanceable(*m_Frame.Setup(draw).program))
    {
        return false;
    }
    ++last->instanceCount;
    last->bounds = last->bounds && draw.bounds ? std::optional(Union(*last->bounds, *draw.bounds))
                                               : std::nullopt;
    return true;
}

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
        if (const auto* known = std::get_if<Value>(m_Globals.Find(id)))
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
