#include <limn/core/BuiltinShaders.h>
#include <limn/features/Features.h>

namespace limn
{

namespace embedded
{
std::span<const EmbeddedFile> FeatureShaders();
}

void RegisterVolumeComponents(VolumeComponentRegistry& registry)
{
    FeatureRegistry features;
    RegisterFeatures(features, registry);
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
