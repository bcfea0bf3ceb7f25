#include <limn/volume/ProfileContext.h>

#include <algorithm>
#include <array>
#include <limn/base/Lists.h>

namespace limn
{

namespace
{

struct NamedLayer
{
    std::string_view name;
    int index;
};

constexpr std::array<NamedLayer, 5> k_BuiltInLayers{
    {{"Default", 0}, {"TransparentFX", 1}, {"Ignore Raycast", 2}, {"Water", 4}, {"UI", 5}}};

} // namespace

std::optional<int> ProfileContext::FindLayer(std::string_view name) const
{
    const auto named = std::ranges::find(k_BuiltInLayers, name, &NamedLayer::name);
    return named == k_BuiltInLayers.end() ? std::nullopt : std::optional(named->index);
}

std::vector<std::string_view> ProfileContext::layerNames() const
{
    return NamesOf(k_BuiltInLayers, &NamedLayer::name);
}

LoadedAsset<Texture> ProfileContext::LoadTexture(const AssetLocation&) const
{
    return {};
}

LoadedAsset<Material> ProfileContext::LoadMaterial(const AssetLocation&) const
{
    return {};
}

} // namespace limn
