#include "assets/FileKind.h"
#include "console/Console.h"
#include "scene/Loader.h"
#include "scene/SceneView.h"
#include "shaders/ShaderFolders.h"
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

void DrawPicture(const std::filesystem::path& scene, const std::filesystem::path& output,
                 Console& console)
{
    RequireKind(scene.string(), {FileKind::Scene}, "first_picture");
    ShaderCompilerOptions compilerOptions = DefaultCompilerOptions();
    VulkanDevice device({"", false, compilerOptions.cacheFolder});
    compilerOptions.missingFeatures = device.missingShaderFeatures();
    AssetContext assets(compilerOptions);
    SceneAsset asset = LoadSceneFile(scene, assets, InactiveObjects::Check);
    console.Print(asset.notes);
    console.Print(CompileUsedShaders(asset));
    SceneView view(std::move(asset), assets);
    UniversalRenderPipeline pipeline(device);
    const RenderResult frame = view.Render(pipeline, 0.0, true);
    Image image = device.ReadBack(*frame.output.rt());
    MakeOpaque(image);
    WritePng(output, image);
}

} // namespace

} // namespace limn

/// `first_picture SCENE FILE` draws a scene file as `limn render SCENE -o FILE` does.
int main(int argc, char** argv)
{
    limn::Console console(std::cout, std::cerr);
    try
    {
        if (argc != 3)
        {
            console.Error("first_picture takes a scene file and the PNG to write");
            return 2;
        }
        limn::DrawPicture(argv[1], argv[2], console);
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
