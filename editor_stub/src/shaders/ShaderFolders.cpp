#include "shaders/ShaderFolders.h"

#include "console/CacheFolder.h"
#include "console/Texts.h"

#include <limn/base/WorkerProcess.h>
#include <limn/features/Features.h>

namespace limn
{

std::filesystem::path FolderOfShaders(const std::filesystem::path& shaderFile)
{
    std::filesystem::path folder = shaderFile.parent_path();
    for (std::filesystem::path above = std::filesystem::absolute(shaderFile).parent_path();
         above.has_relative_path(); above = above.parent_path())
    {
        if (above.filename() == "Assets")
        {
            folder = above;
        }
    }
    return folder.empty() ? "." : folder;
}

ShaderDatabase FindShaders(const std::vector<std::filesystem::path>& folders)
{
    ShaderDatabase database;
    for (const std::filesystem::path& folder : folders)
    {
        database.AddFolder(folder);
    }
    database.Add(ShippedShaders());
    return database;
}

bool isUnityShader(std::string_view name)
{
    static const std::vector<std::string> folders = SplitText(
        "Autodesk Interactive,FX/,GUI/,HDRP/,Hidden/Core/,Hidden/HDRP/,Hidden/Internal,"
        "Hidden/Nature/,Hidden/Shader Graph/,Hidden/TerrainEngine/,"
        "Hidden/Universal Render Pipeline/,Legacy Shaders/,Lightmapped/,Mobile/,Nature/,Particles/,"
        "Reflective/,Self-Illumin/,Skybox/,Sprites/,Transparent/,UI/,Universal Render Pipeline/,"
        "Unlit/",
        ',');
    // Names without a folder, as the built-in pipeline's oldest shaders have them.
    return IsIn(name, {"Diffuse", "Specular", "VertexLit", "Bumped Diffuse", "Bumped Specular",
                       "Standard", "Diffuse Detail", "Standard (Specular setup)"}) ||
           std::ranges::any_of(folders, [name](const auto& one) { return name.starts_with(one); });
}

ShaderCompilerOptions DefaultCompilerOptions()
{
    ShaderCompilerOptions options;
    const std::filesystem::path folder = DefaultCacheFolder();
    if (!folder.empty() && MakeFolder(folder).empty())
    {
        options.cacheFolder = folder;
    }
    options.cacheLimit = CacheLimit(options.cacheLimit);
    options.process = std::make_shared<WorkerProcess>();
    return options;
}

} // namespace limn
