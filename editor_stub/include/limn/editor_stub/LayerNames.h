#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

/// The names of 32 layers, or of 32 rendering layers; number 0 is "Default".
/// Unity: the Tags and Layers settings (2022.3).
class LayerNames
{
public:
    LayerNames() { m_Names[0] = "Default"; }

    /// @param index  0...31
    void SetName(int index, std::string name)
    {
        m_Names.at(static_cast<std::size_t>(index)) = std::move(name);
    }

    /// Returns the name of a layer, or "" if it has none.
    const std::string& Name(int index) const { return m_Names.at(static_cast<std::size_t>(index)); }

    std::optional<int> Find(std::string_view name) const;

    /// Returns the names there are, by ascending number.
    std::vector<std::string_view> names() const;

    bool operator==(const LayerNames&) const = default;

private:
    std::array<std::string, 32> m_Names;
};

} // namespace limn
