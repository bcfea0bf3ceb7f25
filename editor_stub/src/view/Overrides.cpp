#include "assets/FileKind.h"
#include "assets/References.h"
#include "scene/ProfileContext.h"
#include "settings/SettingsReader.h"

#include <algorithm>
#include <limits>
#include <limn/base/Lists.h>
#include <limn/editor_stub/Overrides.h>
#include <limn/volume/ProfileEdit.h>
#include <set>

namespace limn
{

namespace
{

std::vector<std::filesystem::path> SearchFolders(const SceneAsset& asset)
{
    return {{}, asset.path.parent_path()};
}

/// A global volume whose layer the camera looks at.
Volume& AddGlobalVolume(SceneAsset& asset, const std::string& name, const std::string& reason)
{
    const std::uint32_t mask = asset.camera.volumeLayerMask.bits;
    if (mask == 0)
    {
        throw AssetError(reason, {},
                         "the camera's volumeLayerMask is Nothing, so no volume has an effect");
    }
    Volume& volume = asset.volumes.emplace_back();
    volume.name = name;
    while (((mask >> volume.layer) & 1u) == 0)
    {
        ++volume.layer;
    }
    return volume;
}

class Overrider
{
public:
    Overrider(SceneAsset& asset, AssetContext& assets) : m_Asset(asset), m_Assets(assets)
    {
        m_Profile->name = "--set";
    }

    void Apply(const std::string& text)
    {
        const std::string file = "--set " + text;
        const ValueAssignment assignment = ValueAssignment::Parse(text, file);
        const ValuePath path = ValuePath::Split(assignment.path, KnownNames());
        const YamlNode map = path.AsMap(ParseTypedValue(assignment.value, file));
        AssetDiagnostics diagnostics(file);
        References references(m_Assets, SearchFolders(m_Asset), diagnostics,
                              ReferenceScope::Anywhere);
        if (m_Assets.volumeComponents().Find(path.name))
        {
            SetParameter(path.name, map, diagnostics);
        }
        else if (!SetFeatures(path.name, map, references, diagnostics))
        {
            diagnostics.Error({}, "unknown name " + UnknownName(path.name, KnownNames()));
        }
        references.ThrowIfErrors();
    }

    /// Adds a volume above all others for the parameters that were set.
    /// @throws AssetError where features cannot be as they are set
    void Finish()
    {
        AssetDiagnostics diagnostics("--set");
        for (ScriptableRendererFeature* feature : m_Changed)
        {
            TryCreate(*feature, m_Assets.shaderSource(), {}, "", diagnostics);
        }
        diagnostics.ThrowIfErrors();
        if (!m_Components.empty())
        {
            Volume& volume = AddGlobalVolume(m_Asset, "--set", "--set");
            volume.priority = std::numeric_limits<float>::max();
            volume.sharedProfile = m_Profile;
        }
    }

private:
    std::vector<std::string_view> KnownNames() const
    {
        std::vector<std::string_view> names = m_Assets.volumeComponents().names();
        const RendererAsset& renderer = m_Asset.renderer;
        for (std::size_t i = 0; i < renderer.features.size(); ++i)
        {
            AddOnce(renderer.features[i]->name, names);
            AddOnce(renderer.featureTypes[i], names);
        }
        return names;
    }

    void SetParameter(const std::string& name, const YamlNode& value, AssetDiagnostics& diagnostics)
    {
        VolumeComponent& component = Component(name);
        const SceneProfileContext context(m_Assets, {}, m_Asset.layers);
        YamlMapReader map(value, name, diagnostics, "parameter");
        for (VolumeParameter* parameter : component.parameters())
        {
            if (const YamlNode* node = map.Find(parameter->name()))
            {
                parameter->ReadYaml(*node, map.SubjectOf(parameter->name()), diagnostics, context);
                parameter->SetOverrideState(true);
            }
        }
        map.Finish();
    }

    VolumeComponent& Component(const std::string& type)
    {
        VolumeComponent*& component = m_Components[type];
        if (!component)
        {
            component = &m_Profile->Add(m_Assets.volumeComponents().Create(type));
        }
        return *component;
    }

    SettingsContext ContextOf(References& references, AssetDiagnostics& diagnostics) const
    {
        AssetReaders assets = ReadersOfFiles(references);
        assets.material = [&diagnostics](const YamlNode& node, const std::string& subject)
        {
            diagnostics.Error(node.location(),
                              subject + ": a material can be chosen in the scene file only");
            return nullptr;
        };
        return {m_Asset.layers, m_Asset.renderingLayers, std::move(assets)};
    }

    /// Returns whether there is a feature of that name or, if there is none, of that type.
    bool SetFeatures(const std::string& name, const YamlNode& value, References& references,
                     AssetDiagnostics& diagnostics)
    {
        RendererAsset& renderer = m_Asset.renderer;
        const bool isName = std::ranges::any_of(renderer.features, [&name](const auto& feature)
                                                { return feature->name == name; });
        bool isFound = false;
        for (std::size_t i = 0; i < renderer.features.size(); ++i)
        {
            ScriptableRendererFeature& feature = *renderer.features[i];
            if ((isName ? feature.name : renderer.featureTypes[i]) == name)
            {
                YamlMapReader map(value, name, diagnostics, "setting");
                ReadFeatureSettings(map, feature, ContextOf(references, diagnostics), diagnostics);
                m_Changed.insert(&feature);
                isFound = true;
            }
        }
        return isFound;
    }

    SceneAsset& m_Asset;
    AssetContext& m_Assets;
    const std::shared_ptr<VolumeProfile> m_Profile = std::make_shared<VolumeProfile>();
    std::map<std::string, VolumeComponent*> m_Components; ///< of m_Profile, by type
    std::set<ScriptableRendererFeature*> m_Changed;
};

/// Places in a value typed on a command line say nothing; those in files stay.
void AddWithoutPlace(const AssetError& error, const std::string& override,
                     std::vector<Diagnostic>& problems)
{
    for (Diagnostic diagnostic : error.diagnostics())
    {
        diagnostic.location =
            diagnostic.file == "--set " + override ? SourceLocation{} : diagnostic.location;
        problems.push_back(std::move(diagnostic));
    }
}

} // namespace

void ApplyOverrides(SceneAsset& asset, std::span<const std::string> overrides, AssetContext& assets)
{
    Overrider overrider(asset, assets);
    std::vector<Diagnostic> problems;
    for (const std::string& text : overrides)
    {
        try
        {
            overrider.Apply(text);
        }
        catch (const AssetError& error)
        {
            AddWithoutPlace(error, text, problems);
        }
    }
    if (!problems.empty())
    {
        throw AssetError(std::move(problems));
    }
    overrider.Finish();
}

void ReplaceProfile(SceneAsset& asset, const std::string& file, AssetContext& assets)
{
    AssetDiagnostics diagnostics("--profile");
    const References references(assets, SearchFolders(asset), diagnostics);
    const std::filesystem::path path = references.Resolve(file);
    RequireKind(path, {FileKind::Profile}, "--profile");
    const VolumeProfileLoadResult& result = assets.LoadProfile(path, asset.layers);
    asset.notes.insert(asset.notes.end(), result.notes.begin(), result.notes.end());
    bool isAnyGlobal = false;
    for (Volume& volume : asset.volumes)
    {
        volume.sharedProfile = volume.isGlobal ? result.profile : volume.sharedProfile;
        isAnyGlobal = isAnyGlobal || volume.isGlobal;
    }
    if (!isAnyGlobal)
    {
        AddGlobalVolume(asset, "--profile", "--profile " + file).sharedProfile = result.profile;
    }
}

} // namespace limn
