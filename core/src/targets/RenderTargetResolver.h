#pragma once

#include "material/FrameGlobals.h"
#include "record/RecordedCommands.h"

#include <limn/core/RenderTexturePool.h>
#include <limn/core/ScriptableRenderContext.h>
#include <unordered_map>

namespace limn
{

/// Looks up what identifiers stand for, and turns their commands into commands with textures.
class RenderTargetResolver
{
public:
    /// @param frame    the frame, whose last commands give what is bound
    /// @param globals  where names that are no temporary textures are looked up
    RenderTargetResolver(const FrameCommands& frame, const FrameGlobals& globals)
        : m_Frame(frame), m_Globals(globals)
    {
    }

    void BeginCamera(CameraTargets camera, std::vector<std::string>& notes);
    void EndCamera();
    void SetCameraColor(const SetCameraColorCommand& command) { m_Camera.color = command.color; }

    // These return commands that do the same without identifiers, valid until the next call. All
    // throw ContractError for what cannot be done.
    const CommandBuffer& Resolve(const GetTemporaryRTCommand& command);
    const CommandBuffer& Resolve(const ReleaseTemporaryRTCommand& command);
    const CommandBuffer& Resolve(const SetIdentifiedTargetCommand& command);
    const CommandBuffer& Resolve(const SetGlobalIdentifierCommand& command);
    const CommandBuffer& Resolve(const IdentifiedBlitCommand& command);
    const CommandBuffer& Resolve(const CopyDrawCommand& command);
    const CommandBuffer& Resolve(const CopyTextureCommand& command);
    std::shared_ptr<const RenderTexture> Resolve(const GenerateMipsCommand& command) const;
    const CommandBuffer& Resolve(const SetComputeTextureCommand& command);

    /// Returns the name under which commands ask for the texture: a temporary one has a name of its
    /// own beside that.
    std::string NameOf(const Texture& texture) const;

    /// Returns the kernel for DrawRecorder::Copy, which the renderer's compiler compiles.
    const std::shared_ptr<const ComputeShader>& CopyKernel(std::string_view call);

private:
    using TexturePointer = std::shared_ptr<const Texture>;

    const CameraTargets& Camera(std::string_view call) const;
    const SetRenderTargetCommand& Bound(std::string_view call) const;
    TexturePointer Find(const RenderTargetIdentifier& identifier, std::string_view call) const;
    TexturePointer FindNamed(ShaderPropertyId name, std::string_view call) const;
    RTHandle FindTarget(const RenderTargetIdentifier& identifier, std::string_view call) const;
    RTHandle DepthBeside(const RenderTargetIdentifier& color) const;
    void Bind(const RenderTargetIdentifier& dest, const RTHandle& texture);
    /// @param scaleBias  of the source's uv
    void DrawCopy(const TexturePointer& source, const RenderTexture& dest,
                  const glm::vec4& scaleBias, int pass, std::string_view call);
    /// Draws onto the bound target, with everything in `properties` but the source.
    void DrawCopy(const TexturePointer& source, int pass, std::string_view call,
                  MaterialPropertyBlock properties, MeshTopology topology);
    const std::shared_ptr<const Material>& CopyMaterial(std::string_view call) const;
    void BindAgain();

    const FrameCommands& m_Frame;
    const FrameGlobals& m_Globals;
    CameraTargets m_Camera;
    std::vector<std::string>* m_Notes = nullptr; ///< null = no camera is rendered
    std::unordered_map<ShaderPropertyId, TemporaryTexture> m_Temporaries;
    CommandBuffer m_Result;
    std::shared_ptr<const ComputeShader> m_CopyKernel;
    std::shared_ptr<ShaderCompiler> m_CopyCompiler; ///< the compiler of m_CopyKernel
};

/// Makes a kernel that copies words from one buffer to another, of any targets, for
/// DrawRecorder::Copy.
std::shared_ptr<const ComputeShader> MakeCopyKernel(std::shared_ptr<ShaderCompiler> compiler);

} // namespace limn
