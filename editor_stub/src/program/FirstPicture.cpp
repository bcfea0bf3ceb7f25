#include "scene/SceneView.h"

#include "shaders/UsedShaders.h"

#include <exception>
#include <iostream>
#include <limn/core/Image.h>
#include <limn/editor_stub/AssetContext.h>
#include <limn/vulkan/VulkanDevice.h>

namespace limn
{

namespace
{

void DrawPicture(const RenderOptions& options, Console& console)
{
    ShaderCompilerOptions compilerOptions = ChooseCompilerOptions(options, console);
    VulkanDevice device({options.device, options.validate, compilerOptions.cacheFolder});
    compilerOptions.missingFeatures = device.missingShaderFeatures();
    AssetContext assets(compilerOptions);
    SceneAsset asset = LoadForRendering(options, assets);
    console.Print(asset.notes);
    CompileUsedShaders(asset);
    SceneView view(std::move(asset), assets);
    UniversalRenderPipeline pipeline(device);
    const RenderResult frame = view.Render(pipeline, options.time, true);
    Image image = device.ReadBack(*frame.output.rt());
    MakeOpaque(image);
    WritePng(options.output, image);
}

} // namespace

} // namespace limn

/// `first_picture SCENE FILE` draws as `limn render SCENE -o FILE` does.
int main(int argc, char** argv)
{
    limn::Console console(std::cout, std::cerr);
    try
    {
        if (argc != 3)
        {
            console.Error("first_picture takes a scene and the PNG to write");
            return 2;
        }
        limn::RenderOptions options;
        options.scene = argv[1];
        options.output = argv[2];
        limn::DrawPicture(options, console);
        return 0;
    }
    catch (const limn::AssetError& error)
    {
        console.Print(error.diagnostics());
        return 1;
    }
    catch (const std::exception& error)
    {
        console.Error(error.what());
        return 1;
    }
}
