#include <limn/core/BuiltinShaders.h>
#include <limn/features/Features.h>
#include <limn/features/FullScreenPassRendererFeature.h>
#include <limn/features/RenderObjects.h>
#include <limn/features/ScreenSpaceOutline.h>
#include <limn/features/ScreenSpaceOutlineRenderFeature.h>

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

const ShaderDatabase& ShippedShaders()
{
    static const ShaderDatabase shaders = []
    {
        ShaderDatabase database = BuiltinShaders();
        database.Add(embedded::FeatureShaders());
        return database;
    }();
    return shaders;
}

} // namespace limn
