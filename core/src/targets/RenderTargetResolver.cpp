#include "targets/RenderTargetResolver.h"

#include "material/PropertyValues.h"

#include <algorithm>
#include <limn/base/NumberText.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/TargetOrientation.h>

namespace limn
{

namespace
{

const ShaderPropertyId _BlitMipLevel{"_BlitMipLevel"};
const ShaderPropertyId _BlitScaleBiasRt{"_BlitScaleBiasRt"};
const ShaderPropertyId _InputDepthTexture{"_InputDepthTexture"};
// These are further passes of CameraTargets::copy.
constexpr int k_NearestQuadPass = 6;
constexpr int k_BilinearQuadPass = 7;
constexpr int k_ColorAndDepthPass = 8;
constexpr glm::vec4 k_WholeSource(1.0f, 1.0f, 0.0f, 0.0f);

/// A negative size is a part of the camera's.
int SizeOf(int asked, int camera)
{
    return asked < 0 ? std::max(camera / -asked, 1) : asked;
}

int SamplesOf(const Texture& texture)
{
    const auto* target = dynamic_cast<const RenderTexture*>(&texture);
    return target != nullptr ? target->descriptor().msaaSamples : 1;
}

std::string Describe(const Texture& texture)
{
    const int samples = SamplesOf(texture);
    return "'" + texture.name() + "' is " + std::to_string(texture.width()) + "x" +
           std::to_string(texture.height()) + " " + ToString(texture.graphicsFormat()) +
           (samples > 1 ? " with " + std::to_string(samples) + " samples per texel" : "");
}

void ExpectCopyable(const Texture& source, const RenderTexture& dest)
{
    if (source.width() != dest.width() || source.height() != dest.height() ||
        source.graphicsFormat() != dest.graphicsFormat())
    {
        throw ContractError("CopyTexture: " + Describe(source) + ", and " + Describe(dest) +
                            "; size and format must be the same");
    }
    if (IsDepthFormat(dest.graphicsFormat()) || SamplesOf(dest) > 1 || SamplesOf(source) > 1)
    {
        throw ContractError("CopyTexture: " + Describe(SamplesOf(dest) > 1 ? dest : source) +
                            "; limn copies only colours with one sample per texel");
    }
}

} // namespace

void RenderTargetResolver::BeginCamera(CameraTargets camera, std::vector<std::string>& notes)
{
    EndCamera();
    m_Camera = std::move(camera);
    m_Notes = &notes;
}

void RenderTargetResolver::EndCamera()
{
    m_Result.Clear();
    m_Temporaries.clear();
    m_Camera = {};
    m_Notes = nullptr;
}

const CameraTargets& RenderTargetResolver::Camera(std::string_view call) const
{
    if (m_Notes == nullptr)
    {
        throw ContractError(std::string(call) + ": no camera is rendered, so there is no "
                                                "CameraTarget and no temporary texture");
    }
    return m_Camera;
}

/// Returns the target of the frame's later draws.
const SetRenderTargetCommand& RenderTargetResolver::Bound(std::string_view call) const
{
    const auto isTarget = [](const FrameCommand& command)
    {
        return std::holds_alternative<SetRenderTargetCommand>(command);
    };
    const auto& commands = m_Frame.commands;
    const auto bound = std::find_if(commands.rbegin(), commands.rend(), isTarget);
    if (bound == commands.rend())
    {
        throw ContractError(std::string(call) +
                            ": CurrentActive is given, but no target is bound yet");
    }
    return std::get<SetRenderTargetCommand>(*bound);
}

RenderTargetResolver::TexturePointer RenderTargetResolver::FindNamed(ShaderPropertyId name,
                                                                     std::string_view call) const
{
    if (const auto temporary = m_Temporaries.find(name); temporary != m_Temporaries.end())
    {
        return temporary->second.handle().rt();
    }
    const auto* texture = std::get_if<TexturePointer>(m_Globals.Find(name));
    if (texture == nullptr || !*texture)
    {
        throw ContractError(
            std::string(call) + ": '" + name.name() +
            "' stands for no texture; call GetTemporaryRT or SetGlobalTexture first");
    }
    return *texture;
}

/// @return null for none
RenderTargetResolver::TexturePointer
RenderTargetResolver::Find(const RenderTargetIdentifier& identifier, std::string_view call) const
{
    if (const auto* texture = std::get_if<TexturePointer>(&identifier.content()))
    {
        return *texture;
    }
    if (const auto* name = std::get_if<ShaderPropertyId>(&identifier.content()))
    {
        return FindNamed(*name, call);
    }
    switch (std::get<BuiltinRenderTextureType>(identifier.content()))
    {
    case BuiltinRenderTextureType::CameraTarget:
    case BuiltinRenderTextureType::CameraColor:
        return Camera(call).color.rt();
    case BuiltinRenderTextureType::CurrentActive:
    {
        const SetRenderTargetCommand& bound = Bound(call);
        return bound.colors.empty() ? bound.depth : bound.colors.front();
    }
    case BuiltinRenderTextureType::None:
        break;
    }
    return nullptr;
}

RTHandle RenderTargetResolver::FindTarget(const RenderTargetIdentifier& identifier,
                                          std::string_view call) const
{
    const TexturePointer texture = Find(identifier, call);
    auto target = std::dynamic_pointer_cast<const RenderTexture>(texture);
    if (!target)
    {
        throw ContractError(
            std::string(call) + ": the destination " +
            (texture ? "'" + texture->name() + "' is no render texture" : std::string("is None")));
    }
    return RTHandle(std::move(target));
}

/// Returns the depth that is bound with a colour which is named alone.
RTHandle RenderTargetResolver::DepthBeside(const RenderTargetIdentifier& color) const
{
    if (color == BuiltinRenderTextureType::CameraTarget)
    {
        return m_Camera.depth;
    }
    if (color == BuiltinRenderTextureType::CurrentActive)
    {
        return RTHandle(Bound("SetRenderTarget").depth);
    }
    const auto texture =
        std::dynamic_pointer_cast<const RenderTexture>(Find(color, "SetRenderTarget"));
    return texture ? RTHandle(texture->depthBuffer()) : RTHandle();
}

const CommandBuffer& RenderTargetResolver::Resolve(const GetTemporaryRTCommand& command)
{
    const CameraTargets& camera = Camera("GetTemporaryRT");
    if (camera.temporaryTextures == nullptr)
    {
        throw ContractError("GetTemporaryRT: no pipeline renders, so there is no temporary "
                            "texture");
    }
    RenderTextureDescriptor descriptor = command.descriptor;
    if (descriptor.width < 0 || descriptor.height < 0)
    {
        const RTHandle target =
            FindTarget(BuiltinRenderTextureType::CameraTarget, "GetTemporaryRT");
        descriptor.width = SizeOf(descriptor.width, target.rt()->width());
        descriptor.height = SizeOf(descriptor.height, target.rt()->height());
    }
    TemporaryTexture temporary =
        camera.temporaryTextures->GetTemporary(descriptor, command.filter, TextureWrapMode::Clamp);
    m_Result.Clear();
    m_Result.SetGlobalTexture(command.id, temporary.handle());
    m_Temporaries[command.id] = std::move(temporary);
    return m_Result;
}

const CommandBuffer& RenderTargetResolver::Resolve(const ReleaseTemporaryRTCommand& command)
{
    m_Result.Clear();
    const auto temporary = m_Temporaries.find(command.id);
    if (temporary != m_Temporaries.end())
    {
        const auto* texture = std::get_if<TexturePointer>(m_Globals.Find(command.id));
        if (texture != nullptr && *texture == temporary->second.handle().rt())
        {
            m_Result.SetGlobalTexture(command.id, TexturePointer());
        }
        m_Temporaries.erase(temporary);
        return m_Result;
    }
    Camera("ReleaseTemporaryRT");
    std::string note = "ReleaseTemporaryRT: '" + command.id.name() +
                       "' is no temporary texture: never made, or released before";
    if (std::find(m_Notes->begin(), m_Notes->end(), note) == m_Notes->end())
    {
        m_Notes->push_back(std::move(note));
    }
    return m_Result;
}

const CommandBuffer& RenderTargetResolver::Resolve(const SetIdentifiedTargetCommand& command)
{
    static constexpr std::string_view k_Call = "SetRenderTarget";
    const RenderTargetIdentifier& depth = command.depth;
    m_Result.Clear();
    const bool isAlone = command.colors.size() == 1;
    RTHandle second;
    if (depth == BuiltinRenderTextureType::None)
    {
        second = isAlone ? DepthBeside(command.colors.front()) : RTHandle();
    }
    else if (const RTHandle beside = DepthBeside(depth))
    {
        second = beside;
    }
    else
    {
        second = FindTarget(depth, k_Call);
    }
    FixedList<RTHandle, k_MostColors> colors;
    for (const RenderTargetIdentifier& color : command.colors)
    {
        colors.push_back(FindTarget(color, k_Call));
    }
    if (isAlone)
    {
        m_Result.SetRenderTarget(colors[0], colors[0] == second ? RTHandle() : second);
        return m_Result;
    }
    m_Result.SetRenderTarget(std::span<const RTHandle>(colors.begin(), colors.size()), second);
    return m_Result;
}

const CommandBuffer& RenderTargetResolver::Resolve(const SetGlobalIdentifierCommand& command)
{
    m_Result.Clear();
    m_Result.SetGlobalTexture(command.id, Find(command.value, "SetGlobalTexture"));
    return m_Result;
}

const CommandBuffer& RenderTargetResolver::Resolve(const IdentifiedBlitCommand& command)
{
    m_Result.Clear();
    const TexturePointer source = Find(command.source, "Blit");
    const RTHandle dest = FindTarget(command.dest, "Blit");
    Bind(command.dest, dest);
    if (command.material)
    {
        m_Result.DrawBlit(source, *dest.rt(), command.material, command.pass);
        return m_Result;
    }
    if (!source)
    {
        throw ContractError("Blit: the source is None, and no material is given");
    }
    const bool isNearest = source->sampler().filterMode == FilterMode::Point;
    DrawCopy(source, *dest.rt(), BlitScaleBias(IsProjectionFlipped(*dest.rt())),
             isNearest ? CameraTargets::k_NearestPass : CameraTargets::k_BilinearPass, "Blit");
    return m_Result;
}

const CommandBuffer& RenderTargetResolver::Resolve(const CopyTextureCommand& command)
{
    m_Result.Clear();
    const TexturePointer source = Find(command.source, "CopyTexture");
    const RTHandle dest = FindTarget(command.dest, "CopyTexture");
    if (!source)
    {
        throw ContractError("CopyTexture: the source is None");
    }
    ExpectCopyable(*source, *dest.rt());
    m_Result.SetRenderTarget(dest);
    DrawCopy(source, *dest.rt(), k_WholeSource, CameraTargets::k_NearestPass, "CopyTexture");
    BindAgain();
    return m_Result;
}

const CommandBuffer& RenderTargetResolver::Resolve(const SetComputeTextureCommand& command)
{
    m_Result.Clear();
    m_Result.SetParam(command.shader, command.id, Find(command.texture, "SetComputeTextureParam"),
                      command.kernel);
    return m_Result;
}

const CommandBuffer& RenderTargetResolver::Resolve(const CopyDrawCommand& command)
{
    m_Result.Clear();
    const TexturePointer source = Find(command.source, "BlitTexture");
    if (!source)
    {
        throw ContractError("BlitTexture: the source is None");
    }
    if (!(command.mipLevel >= 0.0f && command.mipLevel < static_cast<float>(source->mipmapCount())))
    {
        throw ContractError("BlitTexture: '" + source->name() + "' has no mip level " +
                            NumberText(static_cast<double>(command.mipLevel)) +
                            "; the number of its levels is " +
                            std::to_string(source->mipmapCount()));
    }
    MaterialPropertyBlock properties;
    properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias, command.scaleBias);
    properties.SetFloat(_BlitMipLevel, command.mipLevel);
    if (command.depth)
    {
        properties.SetTexture(_InputDepthTexture, command.depth);
    }
    if (command.targetScaleBias)
    {
        properties.SetVector(_BlitScaleBiasRt, *command.targetScaleBias);
        DrawCopy(source, command.isBilinear ? k_BilinearQuadPass : k_NearestQuadPass, "BlitQuad",
                 std::move(properties), MeshTopology::Quads);
        return m_Result;
    }
    DrawCopy(source,
             command.depth        ? k_ColorAndDepthPass
             : command.isBilinear ? CameraTargets::k_BilinearPass
                                  : CameraTargets::k_NearestPass,
             "BlitTexture", std::move(properties), MeshTopology::Triangles);
    return m_Result;
}

std::shared_ptr<const RenderTexture>
RenderTargetResolver::Resolve(const GenerateMipsCommand& command) const
{
    const TexturePointer found = Find(command.texture, "GenerateMips");
    auto texture = std::dynamic_pointer_cast<const RenderTexture>(found);
    if (!texture || texture->mipmapCount() == 1)
    {
        throw ContractError("GenerateMips: " + (found ? "'" + NameOf(*found) + "'" : "None") +
                            " is no render texture with mip levels; a descriptor with useMipMap "
                            "makes one");
    }
    return texture;
}

std::string RenderTargetResolver::NameOf(const Texture& texture) const
{
    const auto named =
        std::ranges::find_if(m_Temporaries, [&](const auto& temporary)
                             { return temporary.second.handle().rt().get() == &texture; });
    return named != m_Temporaries.end() ? named->first.name() : texture.name();
}

/// Sets the target of a blit with the depth that belongs to it.
void RenderTargetResolver::Bind(const RenderTargetIdentifier& dest, const RTHandle& texture)
{
    if (dest != BuiltinRenderTextureType::CurrentActive)
    {
        m_Result.SetRenderTarget(texture, DepthBeside(dest));
    }
}

void RenderTargetResolver::DrawCopy(const TexturePointer& source, const RenderTexture& dest,
                                    const glm::vec4& scaleBias, int pass, std::string_view call)
{
    if (source.get() == &dest)
    {
        throw ContractError(std::string(call) + ": '" + source->name() +
                            "' is both source and destination");
    }
    MaterialPropertyBlock properties;
    properties.SetVector(Blitter::BlitShaderIDs::_BlitScaleBias, scaleBias);
    DrawCopy(source, pass, call, std::move(properties), MeshTopology::Triangles);
}

void RenderTargetResolver::DrawCopy(const TexturePointer& source, int pass, std::string_view call,
                                    MaterialPropertyBlock properties, MeshTopology topology)
{
    properties.SetTexture(Blitter::BlitShaderIDs::_BlitTexture, source);
    m_Result.DrawProcedural(glm::mat4(1.0f), CopyMaterial(call), pass, topology,
                            topology == MeshTopology::Quads ? 4 : 3, 1, properties);
}

const std::shared_ptr<const Material>&
RenderTargetResolver::CopyMaterial(std::string_view call) const
{
    const std::shared_ptr<const Material>& material = Camera(call).copy;
    if (!material)
    {
        throw ContractError(std::string(call) +
                            ": copying needs a shader, and the renderer has no shaderCompiler()");
    }
    return material;
}

const std::shared_ptr<const ComputeShader>& RenderTargetResolver::CopyKernel(std::string_view call)
{
    const std::shared_ptr<ShaderCompiler>& compiler = CopyMaterial(call)->shader()->compiler();
    if (m_CopyCompiler != compiler)
    {
        m_CopyKernel = MakeCopyKernel(compiler);
        m_CopyCompiler = compiler;
    }
    return m_CopyKernel;
}

/// The target and the viewport that the frame ends with.
void RenderTargetResolver::BindAgain()
{
    const auto& commands = m_Frame.commands;
    const SetViewportCommand* viewport = nullptr;
    for (auto command = commands.rbegin(); command != commands.rend(); ++command)
    {
        if (const auto* target = std::get_if<SetRenderTargetCommand>(&*command))
        {
            m_Result.m_Commands.emplace_back(*target);
            if (viewport != nullptr)
            {
                m_Result.SetViewport(viewport->rect);
            }
            return;
        }
        if (const auto* set = std::get_if<SetViewportCommand>(&*command))
        {
            viewport = viewport != nullptr ? viewport : set;
        }
    }
}

} // namespace limn
