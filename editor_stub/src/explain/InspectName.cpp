#include "explain/InspectReport.h"
#include "shader_reports/ShaderDescription.h"

#include <array>
#include <limn/editor_stub/LayerNames.h>
#include <limn/features/Features.h>

namespace limn
{

namespace
{

constexpr std::array<std::string_view, 3> k_FeatureEndings{"", "RenderFeature", "RendererFeature"};

InspectedGroup InspectShader(const Shader& shader)
{
    InspectedGroup group;
    group.type = shader.name();
    for (const ShaderProperty& property : shader.document().properties)
    {
        InspectedValue& value = group.values.emplace_back();
        value.name = property.name;
        value.value = DefaultText(property);
        value.hasDefault = false;
        value.unit = TypeText(property);
        value.tooltip = property.displayName;
    }
    return group;
}

} // namespace

std::vector<std::string> KnownNames(const AssetContext& assets)
{
    std::vector<std::string> names;
    for (const auto& known : {assets.volumeComponents().names(), assets.features().names()})
    {
        names.insert(names.end(), known.begin(), known.end());
    }
    for (const std::string_view name : ShippedShaders().names())
    {
        names.emplace_back(name);
    }
    return names;
}

InspectReport InspectName(const std::string& name, AssetContext& assets)
{
    InspectReport report;
    report.kind = "name";
    if (assets.volumeComponents().Find(name))
    {
        VolumeProfile profile;
        profile.Add(assets.volumeComponents().Create(name));
        report.volumes.emplace_back().components =
            InspectProfile(profile, assets.volumeComponents());
    }
    for (const std::string_view ending : k_FeatureEndings)
    {
        const std::string type = name + std::string(ending);
        if (std::unique_ptr<ScriptableRendererFeature> feature = assets.features().Create(type))
        {
            report.features.push_back({type, type, true,
                                       CollectSettings(*feature, *assets.features().Create(type),
                                                       LayerNames{}, LayerNames{})});
        }
    }
    if (const std::shared_ptr<const Shader> shader = assets.FindShader(name))
    {
        report.shaders.push_back(InspectShader(*shader));
    }
    if (report.volumes.empty() && report.features.empty() && report.shaders.empty())
    {
        const std::vector<std::string> known = KnownNames(assets);
        const std::string_view nearest = NearestName(name, {known.begin(), known.end()});
        throw AssetError(name, {},
                         "there is no such file, and no volume component, feature or shader has "
                         "this name" +
                             (nearest.empty() ? std::string()
                                              : "; did you mean '" + std::string(nearest) + "'?"));
    }
    return report;
}

} // namespace limn
