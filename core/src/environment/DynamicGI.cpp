#include <limn/core/DynamicGI.h>

#include "environment/CubeLight.h"

#include <bit>
#include <glm/gtc/quaternion.hpp>
#include <limn/base/Diagnostic.h>
#include <limn/core/Debug.h>
#include <limn/core/QualitySettings.h>
#include <limn/core/UniversalRenderPipeline.h>

namespace limn
{

namespace
{

/// Returns a copy of the sky's material without the disc of the sun.
std::shared_ptr<const Material> WithoutSun(const Material& sky)
{
    const auto copy = std::make_shared<Material>(sky, sky.shader());
    for (const char* disc : {"_SUNDISK_SIMPLE", "_SUNDISK_HIGH_QUALITY"})
    {
        copy->DisableKeyword(disc);
    }
    copy->EnableKeyword("_SUNDISK_NONE");
    return copy;
}

/// Draws the sky and nothing else, face by face.
CubeLight DrawSky(GraphicsDevice& device, const std::shared_ptr<ShaderCompiler>& compiler,
                  const Scene& scene, int width, double time)
{
    Scene sky;
    sky.skybox = WithoutSun(*scene.skybox);
    sky.mainLight = scene.mainLight;
    sky.mainLight.shadows = LightShadows::None;

    Camera camera;
    camera.fieldOfView = 90.0f;
    camera.clearFlags = CameraClearFlags::Skybox;
    camera.backgroundColor = Color::black;
    camera.cameraType = CameraType::Reflection;
    camera.renderPostProcessing = false;
    camera.allowMSAA = false;
    const RenderTextureDescriptor size(width, width, GraphicsFormat::R16G16B16A16_SFloat);
    camera.targetTexture = std::make_shared<const RenderTexture>("Sky around", size);

    UniversalRenderPipeline pipeline(device);
    UniversalRenderer renderer(compiler);
    RenderRequest request;
    request.scene = &sky;
    request.camera = &camera;
    request.width = width;
    request.height = width;
    request.time = time;
    std::array<Image, k_CubeFaces> faces;
    for (std::size_t face = 0; face < faces.size(); ++face)
    {
        const CubeFace& axes = k_FacesOfCube[face];
        camera.transform.localRotation =
            glm::quat_cast(glm::mat3(axes.right, axes.up, axes.forward));
        const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
        faces[face] = device.ReadBack(*result.output.rt());
    }
    std::size_t notNumbers = 0;
    CubeLight light = ReadCubeLight(faces, notNumbers);
    if (notNumbers > 0)
    {
        Debug::LogWarning("the sky of material '" + scene.skybox->name() + "' gives no number in " +
                          std::to_string(notNumbers) + " of " +
                          std::to_string(light.texels.size()) +
                          " directions; these light the scene as black does");
    }
    return light;
}

/// Returns the light of a sky that was drawn in the colour space of the process. Harmonics are
/// linear in both.
CubeLight InLinearSpace(CubeLight light)
{
    if (QualitySettings::activeColorSpace() == ColorSpace::Gamma)
    {
        for (glm::vec3& texel : light.texels)
        {
            texel = glm::vec3(Color(texel.r, texel.g, texel.b).linear().vector());
        }
    }
    return light;
}

} // namespace

void DynamicGI::UpdateEnvironment(GraphicsDevice& device,
                                  const std::shared_ptr<ShaderCompiler>& compiler, Scene& scene,
                                  double time)
{
    constexpr int k_MostTexels = 2048;
    constexpr int k_AmbientTexels = 32; // harmonics of order 2 have no more detail
    const int resolution = scene.defaultReflectionResolution;
    if (resolution < 1 || resolution > k_MostTexels ||
        !std::has_single_bit(static_cast<unsigned>(resolution)))
    {
        throw ContractError("UpdateEnvironment: defaultReflectionResolution is " +
                            std::to_string(resolution) + "; it must be a power of two from 1 to " +
                            std::to_string(k_MostTexels));
    }
    if (!NeedsEnvironment(scene) || !device.drawsPictures())
    {
        return;
    }
    const bool isMirrored = scene.defaultReflectionMode == DefaultReflectionMode::Skybox;
    const CubeLight light =
        DrawSky(device, compiler, scene, isMirrored ? resolution : k_AmbientTexels, time);
    if (scene.ambientMode == AmbientMode::Skybox)
    {
        scene.ambientProbe = ProjectLight(InLinearSpace(light));
    }
    if (isMirrored)
    {
        scene.skyReflection = MakeCubemap("Sky's reflection", FilterReflection(light));
    }
}

} // namespace limn
