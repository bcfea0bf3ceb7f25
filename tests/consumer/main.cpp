#include <iostream>
#include <limn/core/RecordingDevice.h>
#include <limn/limn.h>
#include <limn/vulkan/VulkanDevice.h>

// A public header must not drag these in.
#if defined(VULKAN_H_) || defined(YAML_CPP_API) || defined(SPIRV_CROSS_HPP)
#error "an implementation detail reaches the user"
#endif

int main()
{
    using namespace limn;
    const auto compiler = std::make_shared<ShaderCompiler>();
    Scene scene;
    scene.Add("Cube").renderer = MeshRenderer{
        CreatePrimitive(PrimitiveType::Cube),
        {std::make_shared<Material>(FindShippedShader("Universal Render Pipeline/Lit", compiler))}};
    Camera camera;
    camera.transform.localPosition = {0.0f, 0.0f, -3.0f};
    RecordingDevice device;
    UniversalRenderPipeline pipeline(device);
    UniversalRenderer renderer(compiler);
    RenderRequest request;
    request.scene = &scene;
    request.camera = &camera;
    request.width = 32;
    request.height = 32;
    const RenderResult result = pipeline.RenderSingleCamera(renderer, request);
    std::cout << result.report.draws.at(0).counts.at(0) << " drawn\n";
    return result.report.draws.at(0).counts.at(0) == 1 ? 0 : 1;
}
