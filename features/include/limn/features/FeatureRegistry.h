#pragma once

#include <concepts>
#include <functional>
#include <limn/core/PluginCallSite.h>
#include <limn/core/ScriptableRendererFeature.h>
#include <limn/features/Technique.h>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The renderer features that files can name. Unity finds them by reflection; here a program
/// registers them once, before it loads scenes.
class FeatureRegistry
{
public:
    FeatureRegistry() = default;
    FeatureRegistry(const FeatureRegistry&) = delete;
    FeatureRegistry& operator=(const FeatureRegistry&) = delete;

    /// Registers a type of feature.
    /// @param name  its name in files: "ScreenSpaceOutlineRenderFeature"
    /// @param techniques  the ways in which it draws outlines
    /// @throws ContractError if a name is empty or registered already
    template <std::derived_from<ScriptableRendererFeature> T>
    void Register(std::string_view name, std::vector<Technique> techniques = {})
    {
        Add({std::string(name), [] { return std::make_unique<T>(); }, &typeid(T)},
            std::move(techniques));
    }

    /// Returns a new feature with default settings, before its Create; returns null if the name is
    /// not registered.
    std::unique_ptr<ScriptableRendererFeature> Create(std::string_view name) const;

    /// Returns the names in the order of registration.
    std::vector<std::string_view> names() const;

    /// Returns the techniques ordered by their place; those of equal place are in the order of
    /// registration.
    const std::vector<Technique>& techniques() const { return m_Techniques; }

private:
    struct Entry
    {
        std::string name;
        std::function<std::unique_ptr<ScriptableRendererFeature>()> create;
        const std::type_info* type; ///< the type that it creates
    };

    void Add(Entry entry, std::vector<Technique> techniques);

    std::vector<std::unique_ptr<const Entry>> m_Entries; ///< their names stay where they are
    std::vector<Technique> m_Techniques;
};

/// Returns the technique of that name, or null if there is none. Ignores the case of letters.
const Technique* FindTechnique(std::span<const Technique> techniques, std::string_view name);

} // namespace limn
