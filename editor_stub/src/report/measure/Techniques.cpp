#include "report/measure/Techniques.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limn/editor_stub/Overrides.h>

namespace limn::study
{

namespace
{

constexpr const char* k_FeatureName = "Outline";
constexpr double k_AnyWidth = std::numeric_limits<double>::infinity();

bool IsSameLetter(char a, char b)
{
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
}

/// As short as it can be written and read back as the same number.
std::string Shortest(double value)
{
    char text[40];
    const auto [end, error] = std::to_chars(text, text + sizeof(text), value);
    return std::string(text, end);
}

} // namespace

const std::vector<Technique>& Techniques()
{
    const char* const straddles = "its lines lie on both sides of what it finds";
    static const std::vector<Technique> techniques = {
        {{"Strokes", "StrokeOutlineRendererFeature", "silhouette edges drawn as geometry", false,
          ""},
         "StrokeOutline",
         {"Outline.m_Grouping=Together"},
         k_AnyWidth,
         std::nullopt,
         "Outline.m_Occlusion"},
        {{"Separable", "WideOutlineRendererFeature",
          "distance to the edge, by columns and then by rows", false, ""},
         "WideOutline",
         {"Outline.m_Method=Separable"}},
        {{"Jump flood", "WideOutlineRendererFeature", "distance to the edge, by jump flooding",
          false, ""},
         "WideOutline",
         {"Outline.m_Method=JumpFlood"}},
        {{"Auto", "AutoOutlineRendererFeature", "strokes or distances, whichever is cheaper", false,
          ""},
         "AutoOutline",
         {"Outline.m_Grouping=Together"}},
        {{"Inflated", "InflatedOutlineRendererFeature", "vertices moved outwards in pixels", false,
          ""},
         "InflatedOutline",
         {"Outline.m_Grouping=Together"},
         k_AnyWidth,
         HiddenAt::Point},
        {{"Screen space", "ScreenSpaceOutlineRenderFeature",
          "the first article: mask of half the size, Roberts cross", true, ""},
         "ScreenSpaceOutline",
         {"Outline.m_ScreenSpaceOutlineShader=Hidden/ScreenSpaceOutline",
          "Outline.m_LayerMask=Everything"},
         10.0},
        {{"Selection", "SelectionOutlineRendererFeature",
          "the article on selection: blurred mask, composite", true, ""},
         "SelectionOutline",
         {"SelectionOutline.m_VaryingColor=false"}},
        {{"Mask difference", "MaskDifferenceOutlineRendererFeature",
          "the article on post-processing: five samples of a mask", true, ""},
         "MaskDifferenceOutline",
         {"Outline.m_Grouping=Together"}},
        {{"Depth and normals (article)", "DepthNormalsOutlineRendererFeature",
          "the article on depth and normals, its formula", true, straddles},
         "DepthNormalsOutline",
         {"DepthNormalsOutline.m_Technique=Article"}},
        {{"Depth and normals", "DepthNormalsOutlineRendererFeature",
          "depth and normals by metres and degrees", false, straddles},
         "DepthNormalsOutline",
         {}},
        {{"Color edges", "ColorEdgesRendererFeature", "steps of the picture's brightness", false,
          straddles},
         "ColorEdges",
         {}},
        {{"Rim", "RimOutlineRendererFeature", "where normal and view are at right angles", false,
          "its rim lies within the object and is as wide as the object is curved"},
         "RimOutline",
         {}},
    };
    return techniques;
}

const Technique* FindTechnique(std::string_view name)
{
    const auto& techniques = Techniques();
    const auto found = std::ranges::find_if(
        techniques, [name](const Technique& technique)
        { return std::ranges::equal(technique.info.name, name, IsSameLetter); });
    return found == techniques.end() ? nullptr : &*found;
}

void UseTechnique(SceneAsset& asset, const Technique& technique, const std::string& width,
                  AssetContext& assets)
{
    std::unique_ptr<ScriptableRendererFeature> feature =
        assets.features().Create(technique.info.feature);
    if (!feature)
    {
        throw ContractError("there is no feature " + technique.info.feature);
    }
    feature->name = k_FeatureName;
    asset.renderer.features.clear();
    asset.renderer.features.push_back(std::move(feature));
    asset.renderer.featureTypes = {technique.info.feature};
    asset.volumes.clear();

    std::vector<std::string> changes = {"Outline.m_RenderQueueRange=All",
                                        "Outline.m_RenderingLayerMask=" +
                                            std::to_string(k_OutlinedLayer),
                                        technique.component + ".m_Enable=true",
                                        technique.component + ".m_OutlineColor=[1, 1, 1, 1]",
                                        technique.component + ".m_OutlineWidth=" + width};
    changes.insert(changes.end(), technique.changes.begin(), technique.changes.end());
    ApplyOverrides(asset, changes, assets);
}

void UseTechnique(SceneAsset& asset, const Technique& technique, double width, AssetContext& assets)
{
    UseTechnique(asset, technique, Shortest(width), assets);
}

} // namespace limn::study
