#pragma once

#include <concepts>
#include <functional>
#include <limn/core/PluginCallSite.h>
#include <limn/volume/VolumeComponent.h>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

namespace limn
{

/// The volume components a program knows, by name and by type. Unity finds them by reflection; here
/// a program registers them once, before it loads profiles and creates stacks.
class VolumeComponentRegistry
{
public:
    /// A registered type.
    struct Entry
    {
        std::string name; ///< its name in files: "ScreenSpaceOutline"
        std::type_index type;
        std::function<std::unique_ptr<VolumeComponent>()> create;
        /// A component with the values of its constructor, which a stack shows where no volume
        /// counts.
        std::unique_ptr<const VolumeComponent> defaults;
    };

    VolumeComponentRegistry() = default;
    VolumeComponentRegistry(const VolumeComponentRegistry&) = delete;
    VolumeComponentRegistry& operator=(const VolumeComponentRegistry&) = delete;

    /// @throws ContractError if the name or the type is registered already
    template <std::derived_from<VolumeComponent> T>
    void Register(std::string_view name)
    {
        const auto create = [name = std::string(name)]
        {
            return RunPluginCode(typeid(T), name, "its constructor",
                                 [] { return std::make_unique<T>(); });
        };
        Add({std::string(name), typeid(T), create, nullptr});
    }

    /// @throws ContractError for a name that is not registered
    std::unique_ptr<VolumeComponent> Create(std::string_view name) const;
    /// @throws ContractError for a type that is not registered
    std::unique_ptr<VolumeComponent> Create(std::type_index type) const;

    /// Returns the entry of that name or type, or null if there is none. Entries keep their address
    /// while the registry lives.
    const Entry* Find(std::string_view name) const;
    const Entry* Find(std::type_index type) const;

    /// Returns the names in the order of registration.
    std::vector<std::string_view> names() const;
    std::span<const std::unique_ptr<const Entry>> entries() const { return m_Entries; }

private:
    void Add(Entry entry);

    std::vector<std::unique_ptr<const Entry>> m_Entries;
};

} // namespace limn
