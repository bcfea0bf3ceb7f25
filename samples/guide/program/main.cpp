// Draws a torus with an outline into torus.png.

#include <exception>
#include <iostream>
#include <limn/limn.h>
#include <limn/vulkan/VulkanDevice.h>

using namespace limn;

int main()
try
{
    VulkanDevice device;
    Outline<StrokeOutlineRendererFeature> outline(device);
    outline.component().m_OutlineWidth.Override(6.0f); // pixels
    outline.component().m_OutlineColor.Override({1.0f, 0.6f, 0.1f});

    Scene scene;
    GameObject& torus = scene.Add("Torus");
    torus.transform = {{0.0f, 0.0f, 2.0f}, EulerToRotation({60.0f, 0.0f, 20.0f})};
    torus.renderer = MeshRenderer{CreatePrimitive(PrimitiveType::Torus),
                                  {outline.CreateMaterial("Universal Render Pipeline/Lit")}};
    const Camera camera; // at the origin, where it looks along +z

    const RenderResult result = outline.Render(scene, camera, 640, 360);
    for (const std::string& note : result.report.notes)
    {
        std::cerr << "note: " << note << '\n';
    }
    WritePng("torus.png", device.ReadBack(*result.output.rt()));
}
catch (const std::exception& error)
{
    std::cerr << "error: " << error.what() << '\n';
    return 1;
}
