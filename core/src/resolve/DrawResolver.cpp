#include "resolve/DrawResolver.h"

#include "resolve/StorageSlots.h"

#include <algorithm>
#include <limn/base/Case.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/DrawError.h>
#include <utility>

namespace limn
{

namespace
{

/// A sampler whose name says what it does: "sampler_LinearClamp", "my_point_repeat_sampler".
std::optional<SamplerState> SamplerByName(const std::string& lower)
{
    const auto has = [&](std::string_view word)
    {
        return lower.find(word) != std::string::npos;
    };
    const bool filtered = has("point") || has("linear");
    const bool wrapped = has("clamp") || has("repeat") || has("mirror");
    if (!filtered || !wrapped)
    {
        return std::nullopt;
    }
    SamplerState state;
    state.filterMode = has("point")       ? FilterMode::Point
                       : has("trilinear") ? FilterMode::Trilinear
                                          : FilterMode::Bilinear;
    state.wrapModeU = has("clamp")        ? TextureWrapMode::Clamp
                      : has("mirroronce") ? TextureWrapMode::MirrorOnce
                      : has("mirror")     ? TextureWrapMode::Mirror
                                          : TextureWrapMode::Repeat;
    state.wrapModeV = state.wrapModeU;
    state.wrapModeW = state.wrapModeU;
    return state;
}

/// A texture that a renderer makes for shaders, and the texture that shaders read before it is
/// made.
struct CameraTexture
{
    const char* name;
    const char* color; ///< Unity's, where nothing was written yet: 0 is far with reversed Z
    const char* look;
    const char* reason;
    bool isDepth = false;
};
constexpr const char* k_IsLater = "nothing has written it yet; UniversalRenderer makes it for "
                                  "passes after event 150";
constexpr const char* k_IsLast = "nothing has written it yet; UniversalRenderer makes it for "
                                 "passes after event 400";
constexpr const char* k_HasNoShadow = "no light throws a shadow onto what is seen, or this pass "
                                      "comes before the shadows";
constexpr CameraTexture k_CameraTextures[] = {
    {"_CameraDepthTexture", "black", "far", k_IsLater, true},
    {"_CameraNormalsTexture", "gray", "gray", k_IsLater},
    {"_CameraDepthNormalsTexture", "gray", "gray", k_IsLater},
    {"_CameraOpaqueTexture", "gray", "gray", k_IsLast},
    {"_MainLightShadowmapTexture", "black", "far", k_HasNoShadow, true},
    {"_AdditionalLightsShadowmapTexture", "black", "far", k_HasNoShadow, true}};

/// Returns true if a command of the state, as `Cull [_Cull]`, takes its value from the property.
bool RefersTo(const RenderState& state, const std::string& property)
{
    const auto isIn = [&](const auto&... values)
    {
        return ((values.property == property) || ...);
    };
    const auto isInFace = [&](const StencilFaceState& face)
    {
        return isIn(face.compare, face.pass, face.fail, face.zFail);
    };
    const auto isInBlend = [&](const PassBlendState& blend)
    {
        return isIn(blend.writeMask, blend.sourceColorBlendMode, blend.destinationColorBlendMode,
                    blend.sourceAlphaBlendMode, blend.destinationAlphaBlendMode,
                    blend.colorBlendOperation, blend.alphaBlendOperation);
    };
    const PassStencilState& stencil = state.stencil;
    return isIn(state.cull, state.zTest, state.zWrite, state.zClip, state.offsetFactor,
                state.offsetUnits, state.alphaToMask, state.conservative, stencil.reference,
                stencil.readMask, stencil.writeMask) ||
           isInFace(stencil.front) || isInFace(stencil.back) ||
           std::ranges::any_of(state.targets, isInBlend);
}

/// Returns true if the pass may read the property in some variant: its text or a tag has the name.
bool Names(const ShaderLabPass& pass, const std::string& property)
{
    const auto isIn = [&](const std::string& text)
    {
        return text.find(property) != std::string::npos;
    };
    return RefersTo(pass.state, property) ||
           std::ranges::any_of(pass.tags.items, isIn, &ShaderTag::value) ||
           (pass.program && std::ranges::any_of(pass.program->chunks, isIn, &SourceChunk::text));
}

} // namespace

const ShaderPropertyValue* PropertySources::Find(ShaderPropertyId id) const
{
    const ShaderPropertyValue* value = lights != nullptr ? lights->Find(id) : nullptr;
    if (value == nullptr && block != nullptr)
    {
        value = block->Find(id);
    }
    if (value == nullptr)
    {
        value = material != nullptr ? material->Find(id) : compute->values().Find(id);
    }
    return value != nullptr ? value : globals->Find(id);
}

bool PropertySources::HasBuffers() const
{
    return globals->hasBuffers() || (block != nullptr && block->hasBuffers()) ||
           (material != nullptr ? material->hasBuffers() : compute->values().hasBuffers());
}

bool PropertySources::IsKeywordEnabled(std::string_view keyword) const
{
    return material != nullptr ? material->IsKeywordEnabled(keyword)
                               : compute->IsKeywordEnabled(keyword);
}

std::string PropertySources::Subject() const
{
    return material != nullptr ? "material '" + material->name() + "'"
                               : "compute shader '" + compute->name() + "', kernel '" +
                                     compute->kernelName(kernel) + "'";
}

std::string PropertySources::Subject(const std::string& property) const
{
    return Subject() + ": property '" + property + "'";
}

void DrawResolver::Begin(std::vector<std::string>& notes)
{
    m_Notes = &notes;
    m_SharedNotes.clear();
    m_Noted.clear();
    if (!std::exchange(m_HasResolved, false))
    {
        return;
    }
    m_Built.resize(std::exchange(m_BuiltCount, 0));
    // An entry that the frame before did not use may have no user any more.
    EraseUnused(m_Ids);
    EraseUnused(m_States);
    EraseUnused(m_Shared);
    EraseUnused(m_Bound);
    EraseUnused(m_Undeclared);
}

void DrawResolver::End()
{
    for (const auto& [key, undeclared] : m_Undeclared)
    {
        const std::string& name = key.second.name();
        const Shader& shader = *undeclared.shader;
        if (!undeclared.isUsed || undeclared.isRead ||
            std::ranges::any_of(shader.subShader().passes,
                                [&](const ShaderLabPass& pass) { return Names(pass, name); }))
        {
            continue;
        }
        std::vector<std::string_view> known;
        for (const ShaderProperty& property : shader.document().properties)
        {
            known.push_back(property.name);
        }
        m_Notes->push_back("material '" + undeclared.material + "': '" + name +
                           "' was set, but shader '" + shader.name() +
                           "' has no such property and nothing that was drawn reads it" +
                           DidYouMean(name, known));
    }
}

PipelineState DrawResolver::StateOf(const Material& material, int shaderPass)
{
    m_HasResolved = true;
    KnownState& known = m_States[{shaderPass, material.id()}];
    if (!known.isKnown || known.materialVersion != material.version())
    {
        bool readsGlobals = false;
        std::vector<std::string> unset;
        known.state = ResolveState(material.shader()->passState(shaderPass), material, m_Globals,
                                   &readsGlobals, &unset);
        for (const std::string& reference : unset)
        {
            Note(reference + " is 0, as in Unity: nothing sets this property",
                 material.shader()->name());
        }
        known.isKnown = !readsGlobals;
        known.materialVersion = material.version();
    }
    known.isUsed = true;
    return known.state;
}

std::shared_ptr<const DrawBindings>
DrawResolver::Resolve(const std::shared_ptr<const ShaderProgram>& pass,
                      const PropertySources& sources, std::uint64_t globalsVersion,
                      std::vector<std::byte>& uniformData)
{
    m_HasResolved = true;
    const Material& material = *sources.material;
    ProgramIds& ids = IdsOf(pass, material.shader()->name(), material.shader()->id());
    Shared& shared = m_Shared[{pass.get(), material.id()}];
    shared.isUsed = true;
    const UniformLayers layers{&shared.uniforms, globalsVersion};
    if ((sources.block != nullptr && !sources.block->isEmpty()) || sources.arguments != nullptr ||
        sources.lights != nullptr)
    {
        return Build(ids, sources, layers, uniformData);
    }
    if (shared.materialVersion != material.version() || shared.globalsVersion != globalsVersion)
    {
        Build(ids, sources, layers, uniformData);
        shared.materialVersion = material.version();
        shared.globalsVersion = globalsVersion;
        shared.built = m_BuiltCount - 1;
    }
    return m_Built[shared.built];
}

std::shared_ptr<const DrawBindings>
DrawResolver::Resolve(const std::shared_ptr<const ShaderProgram>& kernel,
                      const PropertySources& sources, std::vector<std::byte>& uniformData)
{
    m_HasResolved = true;
    return Build(IdsOf(kernel, sources.compute->name(), sources.compute->id()), sources, {},
                 uniformData);
}

/// Adds a note. A message about several shaders becomes one note: "shader 'A' (and 'B', 'C'):
/// message".
void DrawResolver::Note(const std::string& message, const std::string& shader)
{
    SharedNote& note =
        m_SharedNotes.try_emplace(message, SharedNote{m_Notes->size(), {}}).first->second;
    if (std::ranges::find(note.shaders, shader) != note.shaders.end())
    {
        return;
    }
    note.shaders.push_back(shader);
    m_Notes->resize(std::max(m_Notes->size(), note.index + 1));
    constexpr std::size_t k_Listed = 4;
    std::string others;
    for (std::size_t i = 1; i < std::min(note.shaders.size(), k_Listed); ++i)
    {
        others += (i == 1 ? " (and '" : ", '") + note.shaders[i] + "'";
    }
    others += note.shaders.size() > k_Listed ? ", …)" : note.shaders.size() > 1 ? ")" : "";
    (*m_Notes)[note.index] = "shader '" + note.shaders[0] + "'" + others + ": " + message;
}

DrawResolver::ProgramIds DrawResolver::MakeIds(const std::shared_ptr<const ShaderProgram>& pass)
{
    ProgramIds ids;
    ids.pass = pass;
    ids.uniforms.emplace(pass->layout, m_Globals);
    for (const TextureBinding& texture : pass->layout.textures)
    {
        ids.textures.emplace_back(texture.name);
    }
    ids.defaults.resize(ids.textures.size());
    for (const SamplerBinding& sampler : pass->layout.samplers)
    {
        // Or of the texture that it is named after: "sampler_MainTex" → _MainTex.
        const std::string lower = ToLower(sampler.name);
        SamplerSource source{SamplerByName(lower), {}};
        if (!source.state && lower.starts_with("sampler"))
        {
            source.texture = ShaderPropertyId(sampler.name.substr(7));
        }
        else if (!source.state)
        {
            source.state = SamplerState();
        }
        ids.samplers.push_back(source);
    }
    for (const StorageBufferBinding& buffer : pass->layout.storageBuffers)
    {
        ids.storageBuffers.push_back(
            {buffer.name, buffer.name == "limn_PerDraw", buffer.name == "limn_Instances"});
    }
    for (const StorageTextureBinding& texture : pass->layout.storageTextures)
    {
        ids.storageTextures.emplace_back(texture.name);
    }
    return ids;
}

bool DrawResolver::Reads(const ProgramIds& ids, ShaderPropertyId property)
{
    const auto isIn = [&](const std::vector<ShaderPropertyId>& list)
    {
        return std::ranges::find(list, property) != list.end();
    };
    return ids.uniforms->Reads(property) || isIn(ids.textures) || isIn(ids.storageTextures) ||
           std::ranges::find(ids.samplers, property, &SamplerSource::texture) !=
               ids.samplers.end() ||
           std::ranges::find(ids.storageBuffers, property, &StoragePlace::id) !=
               ids.storageBuffers.end();
}

void DrawResolver::FollowUndeclared(const ProgramIds& ids, const Material& material)
{
    for (const ShaderPropertyId property : material.undeclared())
    {
        const auto [place, isNew] = m_Undeclared.try_emplace({material.shader()->id(), property});
        Undeclared& undeclared = place->second;
        if (isNew)
        {
            undeclared.shader = material.shader();
            undeclared.material = material.name();
        }
        undeclared.isUsed = true;
        undeclared.isRead = undeclared.isRead || Reads(ids, property);
    }
}

DrawResolver::ProgramIds& DrawResolver::IdsOf(const std::shared_ptr<const ShaderProgram>& pass,
                                              const std::string& shader, std::uint64_t shaderId)
{
    const auto [known, isNew] = m_Ids.try_emplace({pass.get(), shaderId});
    ProgramIds& ids = known->second;
    if (isNew)
    {
        ids = MakeIds(pass);
    }
    if (!std::exchange(ids.isUsed, true))
    {
        for (const Diagnostic& diagnostic : pass->diagnostics)
        {
            if (diagnostic.severity == Severity::Note)
            {
                Note(diagnostic.message, shader);
            }
        }
    }
    return ids;
}

std::shared_ptr<const DrawBindings> DrawResolver::Build(ProgramIds& ids,
                                                        const PropertySources& sources,
                                                        const UniformLayers& layers,
                                                        std::vector<std::byte>& uniformData)
{
    if (sources.material != nullptr)
    {
        FollowUndeclared(ids, *sources.material);
    }
    m_Building.uniforms.clear();
    m_Building.textures.clear();
    m_Building.samplers.clear();
    m_Building.buffers.clear();
    m_Building.storageTextures.clear();
    m_Building.perDrawBinding.reset();
    AddUniforms(ids, sources, layers, uniformData);
    AddTextures(ids, sources);
    AddStorage(ids, sources);
    m_Built.resize(std::max(m_Built.size(), m_BuiltCount + 1));
    std::shared_ptr<const DrawBindings>& built = m_Built[m_BuiltCount++];
    if (!built || *built != m_Building)
    {
        built = std::make_shared<const DrawBindings>(m_Building);
    }
    m_Building.textures.clear(); // they are not kept for longer than the frame has them
    m_Building.buffers.clear();
    m_Building.storageTextures.clear();
    return built;
}

void DrawResolver::AddUniforms(ProgramIds& ids, const PropertySources& sources,
                               const UniformLayers& layers, std::vector<std::byte>& uniformData)
{
    const PropertyLayout& layout = ids.pass->layout;
    ProgramUniforms& uniforms = *ids.uniforms;
    const std::size_t begin =
        (uniformData.size() + k_UniformAlignment - 1) / k_UniformAlignment * k_UniformAlignment;
    uniformData.resize(layout.buffers.empty() ? uniformData.size() : begin + uniforms.size());
    const auto bytes = std::span(uniformData).subspan(std::min(begin, uniformData.size()));
    const bool isWritten = layers.material != nullptr &&
                           uniforms.Write(sources, *layers.material, layers.globalsVersion, bytes);
    const bool hasBuffers = sources.HasBuffers();
    for (std::size_t b = 0; b < layout.buffers.size(); ++b)
    {
        const UniformBuffer& buffer = layout.buffers[b];
        const BufferRange* range = hasBuffers ? FindBuffer(uniforms.name(b), sources) : nullptr;
        if (range != nullptr)
        {
            m_Building.buffers.push_back(UniformSlot(buffer, *range, sources));
            continue;
        }
        if (buffer.name == k_DynamicKeywordBuffer)
        {
            WriteDynamicKeywords(buffer, sources, bytes.subspan(uniforms.offset(b), buffer.size));
        }
        else if (!isWritten)
        {
            uniforms.WriteBuffer(b, sources, bytes);
        }
        m_Building.uniforms.push_back(
            {buffer.binding, static_cast<std::uint32_t>(begin) + uniforms.offset(b), buffer.size});
    }
}

/// Adds the buffers and writable textures that the shader names; others have made them.
void DrawResolver::AddStorage(const ProgramIds& ids, const PropertySources& sources)
{
    const PropertyLayout& layout = ids.pass->layout;
    for (std::size_t i = 0; i < layout.storageBuffers.size(); ++i)
    {
        const StorageBufferBinding& buffer = layout.storageBuffers[i];
        const StoragePlace& place = ids.storageBuffers[i];
        if (place.isPerDraw)
        {
            m_Building.perDrawBinding = buffer.binding;
        }
        else if (!place.isDevices)
        {
            m_Building.buffers.push_back(StorageSlot(buffer, place.id, sources));
        }
    }
    for (std::size_t i = 0; i < layout.storageTextures.size(); ++i)
    {
        m_Building.storageTextures.push_back(
            WritableSlot(layout.storageTextures[i], ids.storageTextures[i], sources));
    }
    if (sources.arguments != nullptr)
    {
        m_Building.buffers.push_back(ArgumentsSlot(*sources.arguments, sources));
    }
}

/// Adds the textures with their samplers.
void DrawResolver::AddTextures(ProgramIds& ids, const PropertySources& sources)
{
    const PropertyLayout& layout = ids.pass->layout;
    for (std::size_t i = 0; i < layout.textures.size(); ++i)
    {
        const TextureBinding& binding = layout.textures[i];
        TextureSlot slot{binding.binding, TextureOf(ids, i, sources), std::nullopt};
        m_Bound[slot.texture->id()] = {true, m_Camera};
        if (binding.combinedSampler)
        {
            slot.sampler = slot.texture->sampler();
        }
        m_Building.textures.push_back(std::move(slot));
    }
    for (std::size_t i = 0; i < layout.samplers.size(); ++i)
    {
        const SamplerSource& source = ids.samplers[i];
        // If no texture is set, the default texture has the default sampler.
        const auto texture = source.state ? nullptr : FindTexture(source.texture, sources);
        SamplerState state = texture ? texture->sampler() : source.state.value_or(SamplerState());
        state.comparison = layout.samplers[i].comparison;
        state.standardZ =
            sources.material != nullptr && !sources.material->shader()->usesReversedZBuffer();
        m_Building.samplers.push_back({layout.samplers[i].binding, state});
    }
}

/// Returns the texture that is bound to a texture of a shader.
std::shared_ptr<const Texture> DrawResolver::TextureOf(ProgramIds& ids, std::size_t index,
                                                       const PropertySources& sources)
{
    const ShaderPropertyId id = ids.textures[index];
    const TextureBinding& binding = ids.pass->layout.textures[index];
    if (binding.multisampled)
    {
        throw DrawError(sources.Subject(id.name()) +
                        " is a texture of several samples per texel in the "
                        "shader; limn cannot bind such textures yet");
    }
    std::shared_ptr<const Texture> texture = FindTexture(id, sources);
    if (!texture)
    {
        const bool hasDefault = sources.material != nullptr && binding.type == UniformType::Float;
        return hasDefault ? DefaultOf(id, binding.dimension, sources, ids.defaults[index])
                          : FailUnset<Texture>(id, "texture", sources);
    }
    ExpectFits(binding.type, binding.dimension, *texture, id, sources);
    return texture;
}

/// The default that a Properties entry names, or gray and a note, once for each shader.
std::shared_ptr<const Texture> DrawResolver::DefaultOf(ShaderPropertyId id,
                                                       TextureDimension dimension,
                                                       const PropertySources& sources,
                                                       std::shared_ptr<const Texture>& known)
{
    if (known)
    {
        return known;
    }
    const Shader& shader = *sources.material->shader();
    if (const int index = shader.FindPropertyIndex(id.name()); index >= 0)
    {
        const ShaderProperty& property =
            shader.document().properties[static_cast<std::size_t>(index)];
        known = DefaultTexture(property.defaultTexture, dimension);
        return known;
    }
    const auto* made = std::ranges::find(k_CameraTextures, id.name(), &CameraTexture::name);
    const bool isMade = made != std::end(k_CameraTextures);
    if (m_Noted.insert({shader.id(), id}).second)
    {
        const std::string subject =
            "shader '" + shader.name() + "'" +
            (m_PassName == SampleName() ? "" : " in pass '" + m_PassName.name() + "'") +
            ": texture '" + id.name() + "' is ";
        m_Notes->push_back(
            subject + (isMade ? std::string(made->look) + " everywhere: " + made->reason
                              : "gray: it is no property of the shader, and neither material "
                                "'" +
                                    sources.material->name() + "' nor anything global sets it"));
    }
    const bool isFarWhite = isMade && made->isDepth && !shader.usesReversedZBuffer();
    return DefaultTexture(isFarWhite ? "white" : isMade ? made->color : "gray", dimension);
}

} // namespace limn
