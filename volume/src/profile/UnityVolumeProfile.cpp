#include "profile/UnityVolumeProfile.h"

#include <algorithm>
#include <limn/base/WordList.h>
#include <set>
#include <unordered_map>

namespace limn
{

namespace
{

/// The parameters of a volume component that URP comes with; null for another. (URP 7 to 17)
const WordList* FindUrpComponent(std::string_view name)
{
    static const std::unordered_map<std::string_view, WordList> s_Components = {
        {"Bloom", WordList("skipIterations threshold intensity scatter clamp tint filter downscale "
                           "maxIterations dirtTexture dirtIntensity highQualityFiltering")},
        {"ChannelMixer",
         WordList("redOutRedIn redOutGreenIn redOutBlueIn greenOutRedIn greenOutGreenIn "
                  "greenOutBlueIn blueOutRedIn blueOutGreenIn blueOutBlueIn")},
        {"ChromaticAberration", WordList("intensity")},
        {"ColorAdjustments", WordList("postExposure contrast colorFilter hueShift saturation")},
        {"ColorCurves", WordList("master red green blue hueVsHue hueVsSat satVsSat lumVsSat")},
        {"ColorLookup", WordList("texture contribution")},
        {"DepthOfField",
         WordList("mode gaussianStart gaussianEnd gaussianMaxRadius highQualitySampling "
                  "focusDistance aperture focalLength bladeCount bladeCurvature bladeRotation")},
        {"FilmGrain", WordList("type intensity response texture")},
        {"LensDistortion", WordList("intensity xMultiplier yMultiplier center scale")},
        {"LiftGammaGain", WordList("lift gamma gain")},
        {"MotionBlur", WordList("mode quality intensity clamp")},
        {"PaniniProjection", WordList("distance cropToFit")},
        {"ProbeVolumesOptions", WordList("")},
        {"ScreenSpaceLensFlare",
         WordList("intensity tintColor bloomMip firstFlareIntensity secondaryFlareIntensity "
                  "warpedFlareIntensity warpedFlareScale samples sampleDimmer vignetteEffect "
                  "startingPosition scale streaksIntensity streaksLength streaksOrientation "
                  "streaksThreshold resolution chromaticAbberationIntensity "
                  "chromaticAbberationSampleCount")},
        {"ShadowsMidtonesHighlights",
         WordList("shadows midtones highlights shadowsStart shadowsEnd highlightsStart "
                  "highlightsEnd")},
        {"SplitToning", WordList("shadows highlights balance")},
        {"Tonemapping",
         WordList("mode neutralHDRRangeReductionMode acesPreset hueShiftAmount paperWhite "
                  "detectPaperWhite minNits maxNits detectBrightnessLimits")},
        {"Vignette", WordList("color center intensity smoothness rounded")},
        {"WhiteBalance", WordList("temperature tint")}};
    const auto found = s_Components.find(name);
    return found == s_Components.end() ? nullptr : &found->second;
}

bool isHeaderField(std::string_view name)
{
    return isUnityHeaderField(name) || name == "active" ||
           name == "m_AdvancedMode"; // of the inspector alone, until URP 11
}

void ReadParameter(const YamlEntry& entry, const std::string& subject, VolumeParameter& parameter,
                   AssetDiagnostics& diagnostics, const ProfileContext& context)
{
    const YamlNode* state = entry.value.Find("m_OverrideState");
    const YamlNode* value = entry.value.Find("m_Value");
    if (!state || !value)
    {
        diagnostics.Error(entry.keyLocation, subject +
                                                 ": m_OverrideState or m_Value is missing; Unity "
                                                 "writes both for a parameter");
        return;
    }
    const bool isOverridden =
        ReadBool(*state, subject + ".m_OverrideState", diagnostics).value_or(false);
    // Unity writes every parameter; what none overrides need not be loaded, nor be there.
    const ProfileContext plain;
    parameter.ReadYaml(*value, subject, diagnostics, isOverridden ? context : plain);
    parameter.SetOverrideState(isOverridden);
}

bool IsOverridden(const YamlNode& parameter)
{
    const YamlNode* state = parameter.Find("m_OverrideState");
    return state && state->scalar() != "0";
}

/// Returns whether the profile changes anything by the component.
bool HasEffect(const UnityObject& object)
{
    const YamlNode* active = object.fields.Find("active");
    const bool isActive = !active || active->scalar() != "0";
    return isActive && std::ranges::any_of(object.fields.entries(), [](const YamlEntry& entry)
                                           { return IsOverridden(entry.value); });
}

void NoteUnknownComponent(const UnityObject& object, AssetDiagnostics& diagnostics)
{
    const bool isUrp = FindUrpComponent(object.name) != nullptr;
    if (!isUrp || HasEffect(object))
    {
        diagnostics.Note(object.location,
                         object.name +
                             (isUrp ? ": it is left out; limn does not draw this component of URP"
                                    : ": it is left out; no such volume component is known"));
    }
}

/// A parameter that URP has and limn does not matters where the profile overrides it: `undrawn`
/// gets its name. Any other unknown parameter may be misspelt.
void NoteUnknownParameter(const UnityObject& object, const YamlEntry& entry, std::string& undrawn,
                          AssetDiagnostics& diagnostics)
{
    const WordList* known = FindUrpComponent(object.name);
    if (!known || !known->Has(entry.key))
    {
        diagnostics.Note(entry.keyLocation, object.name + "." + entry.key +
                                                ": it is left out; no such parameter is known");
    }
    else if (IsOverridden(entry.value))
    {
        undrawn += (undrawn.empty() ? "" : ", ") + entry.key;
    }
}

void ReadComponent(const UnityObject& object, VolumeComponent& component,
                   AssetDiagnostics& diagnostics, const ProfileContext& context)
{
    std::string undrawn;
    if (const YamlNode* active = object.fields.Find("active"))
    {
        component.active =
            ReadBool(*active, object.name + ".active", diagnostics).value_or(component.active);
    }
    for (const YamlEntry& entry : object.fields.entries())
    {
        if (isHeaderField(entry.key))
        {
            continue;
        }
        const std::string subject = object.name + "." + entry.key;
        const std::span<VolumeParameter* const> parameters = component.parameters();
        const auto parameter = std::ranges::find(parameters, entry.key, &VolumeParameter::name);
        if (parameter == parameters.end())
        {
            NoteUnknownParameter(object, entry, undrawn, diagnostics);
            continue;
        }
        ReadParameter(entry, subject, **parameter, diagnostics, context);
    }
    if (!undrawn.empty())
    {
        diagnostics.Note(object.location,
                         object.name + ": limn does not draw what URP does with " + undrawn);
    }
}

/// The objects that the list `components` refers to, in its order.
std::vector<UnityObject> ReferredComponents(const UnityAsset& asset, const YamlNode& references,
                                            AssetDiagnostics& diagnostics)
{
    std::vector<UnityObject> components;
    for (const YamlNode& reference : references.items())
    {
        const std::optional<std::int64_t> fileID = ReadFileID(reference);
        if (!fileID)
        {
            diagnostics.Error(reference.location(),
                              "components: found " + reference.Describe() +
                                  "; a reference is expected, {fileID: 11400000}");
        }
        else if (const UnityHeader* header = asset.FindHeader(*fileID))
        {
            try
            {
                components.push_back(asset.Read(*header));
            }
            catch (const AssetError& error)
            {
                diagnostics.Add(error);
            }
        }
        else
        {
            // Unity drops these as well: 0 is left where a component's script was deleted.
            diagnostics.Note(reference.location(),
                             "components: a component is left out; there is no object " +
                                 std::to_string(*fileID) + " in this file");
        }
    }
    return components;
}

} // namespace

std::shared_ptr<VolumeProfile> ReadUnityVolumeProfile(const UnityAsset& asset,
                                                      const VolumeComponentRegistry& registry,
                                                      AssetDiagnostics& diagnostics,
                                                      const ProfileContext& context)
{
    auto profile = std::make_shared<VolumeProfile>();
    const std::optional<UnityObject> root = asset.FindWithField("components");
    if (!root || !root->fields.Find("components")->isSequence())
    {
        diagnostics.Error({}, "no volume profile in this Unity asset; one is a MonoBehaviour with "
                              "a list 'components'");
        return profile;
    }
    profile->name = root->name;
    std::set<std::string> seen;
    for (const UnityObject& object :
         ReferredComponents(asset, *root->fields.Find("components"), diagnostics))
    {
        if (!registry.Find(object.name))
        {
            NoteUnknownComponent(object, diagnostics);
        }
        else if (!seen.insert(object.name).second)
        {
            diagnostics.Error(object.location,
                              object.name + ": the profile has two components of this type");
        }
        else
        {
            VolumeComponent& component = profile->Add(registry.Create(object.name));
            ReadComponent(object, component, diagnostics, context);
        }
    }
    return profile;
}

} // namespace limn
