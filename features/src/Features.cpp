#include <limn/core/BuiltinShaders.h>
#include <limn/features/Features.h>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <limn/features/RenderObjects.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>
#include <limn/shaderlab/EmbeddedFile.h>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> FeatureShaders();
}

namespace
{

struct FeatureType
{
    std::string_view name;
    std::unique_ptr<ScriptableRendererFeature> (*create)();
};

template <typename T>
std::unique_ptr<ScriptableRendererFeature> Make()
{
    return std::make_unique<T>();
}

constexpr FeatureType k_Features[] = {
    {"ScreenSpaceOutlineRenderFeature", &Make<ScreenSpaceOutlineRenderFeature>},
    {"RenderObjects", &Make<RenderObjects>},
    {"FullScreenPassRendererFeature", &Make<FullScreenPassRendererFeature>},
};

struct FeatureShader
{
    std::string_view name;
    std::string_view folder;
    std::string_view stem;
};

constexpr FeatureShader k_Shaders[] = {
    {"Hidden/ScreenSpaceOutline", "screen_space_outline", "ScreenSpaceOutline"},
    {"Limn/TranslucentOutline", "translucent_outline", "TranslucentOutline"},
    {"Limn/TranslucentOutlineHull", "translucent_outline", "TranslucentOutlineHull"},
    {"Limn/TranslucentSolid", "translucent_outline", "TranslucentSolid"},
};

} // namespace

void RegisterVolumeComponents(VolumeComponentRegistry& registry)
{
    registry.Register<ScreenSpaceOutline>("ScreenSpaceOutline");
}

std::unique_ptr<ScriptableRendererFeature> CreateFeature(std::string_view typeName)
{
    for (const FeatureType& feature : k_Features)
    {
        if (feature.name == typeName)
        {
            return feature.create();
        }
    }
    return nullptr;
}

std::vector<std::string_view> FeatureTypeNames()
{
    std::vector<std::string_view> names;
    for (const FeatureType& feature : k_Features)
    {
        names.push_back(feature.name);
    }
    return names;
}

std::shared_ptr<const Shader> FindShippedShader(std::string_view name,
                                                const std::shared_ptr<ShaderCompiler>& compiler)
{
    for (const FeatureShader& shader : k_Shaders)
    {
        const std::string path =
            std::string(shader.folder) + "/" + std::string(shader.stem) + ".shader";
        for (const EmbeddedFile& file : embedded::FeatureShaders())
        {
            if (shader.name == name && file.path == path)
            {
                return Shader::FromText(file.text, std::string(shader.stem) + ".shader", compiler);
            }
        }
    }
    return FindBuiltinShader(name, compiler);
}

std::vector<std::string_view> ShippedShaderNames()
{
    std::vector<std::string_view> names = BuiltinShaderNames();
    for (const FeatureShader& shader : k_Shaders)
    {
        names.push_back(shader.name);
    }
    return names;
}

std::string_view ShippedShaderOfFile(std::string_view stem)
{
    for (const FeatureShader& shader : k_Shaders)
    {
        if (shader.stem == stem)
        {
            return shader.name;
        }
    }
    return {};
}

} // namespace limn
