#include <iostream>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/PrimitiveMesh.h>
#include <limn/core/RecordingDevice.h>
#include <limn/core/UniversalRenderPipeline.h>

// A public header must not drag these in, and a layer above core is not there.
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
        {std::make_shared<Material>(FindBuiltinShader("Universal Render Pipeline/Lit", compiler))}};
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
