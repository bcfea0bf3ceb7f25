#include <limn/features/Features.h>
#include <limn/features/Outline.h>

namespace limn
{

RenderSetup::RenderSetup(GraphicsDevice& device)
    : m_Compiler(std::make_shared<ShaderCompiler>()),
      m_Profile(std::make_shared<VolumeProfile>()),
      m_Volumes(m_Components),
      m_Stack(
          [this]
          {
              RegisterVolumeComponents(m_Components);
              return m_Volumes.CreateStack();
          }()),
      m_Renderer(m_Compiler),
      m_Pipeline(device)
{
    m_Volume.sharedProfile = m_Profile;
    m_Volumes.Register(&m_Volume);
}

std::shared_ptr<Material> RenderSetup::CreateMaterial(std::string_view shader) const
{
    return std::make_shared<Material>(FindShippedShader(shader, m_Compiler));
}

RenderResult RenderSetup::Render(const Scene& scene, const Camera& camera, int width, int height)
{
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = width;
    request.height = height;
    return Render(std::move(request));
}

RenderResult RenderSetup::Render(RenderRequest request)
{
    request.blendVolumes = [this](const Camera& camera)
    {
        m_Volumes.Update(m_Stack, camera.volumeTrigger.value_or(camera.transform.position()),
                         camera.volumeLayerMask);
        return &m_Stack;
    };
    return m_Pipeline.RenderSingleCamera(m_Renderer, request);
}

/// Registers nothing: the code that techniques share has no feature of its own.
void RegisterOutline(FeatureRegistry&, VolumeComponentRegistry&) {}

} // namespace limn
