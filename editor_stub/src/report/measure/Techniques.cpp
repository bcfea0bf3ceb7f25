#include "report/measure/Techniques.h"

#include <limn/editor_stub/Overrides.h>
#include <limn/volume/YamlRead.h>

namespace limn::study
{

const Technique& RequireTechnique(const AssetContext& assets, const std::string& name)
{
    const Technique* technique = FindTechnique(assets.features().techniques(), name);
    if (technique == nullptr)
    {
        throw ContractError("there is no technique '" + name + "'");
    }
    return *technique;
}

void UseTechnique(SceneAsset& asset, const Technique& technique, const std::string& width,
                  AssetContext& assets)
{
    std::unique_ptr<ScriptableRendererFeature> feature =
        assets.features().Create(technique.feature);
    if (!feature)
    {
        throw ContractError("there is no feature " + technique.feature);
    }
    feature->name = "Outline";
    asset.renderer.features.clear();
    asset.renderer.features.push_back(std::move(feature));
    asset.renderer.featureTypes = {technique.feature};
    asset.volumes.clear();

    std::vector<std::string> changes = {"Outline.m_RenderQueueRange=All",
                                        "Outline.m_RenderingLayerMask=" +
                                            std::to_string(k_OutlinedLayer),
                                        technique.component + ".m_Enable=true",
                                        technique.component + ".m_OutlineColor=[1, 1, 1, 1]",
                                        technique.component + ".m_OutlineWidth=" + width};
    changes.insert(changes.end(), technique.settings.begin(), technique.settings.end());
    ApplyOverrides(asset, changes, assets);
}

void UseTechnique(SceneAsset& asset, const Technique& technique, double width, AssetContext& assets)
{
    UseTechnique(asset, technique, NumberText(width), assets);
}

} // namespace limn::study
