#pragma once

#include "settings/Keys.h"

#include <glm/gtc/quaternion.hpp>
#include <limn/volume/YamlMapReader.h>
#include <span>

namespace limn
{

/// Reads a map of a scene file by the list of its keys. Numbers must be within their ranges, and
/// required keys must be there. The list and the reading code must agree: a key that one of them
/// lacks is a ContractError.
class SceneMapReader : YamlMapReader
{
public:
    SceneMapReader(const YamlNode& node, std::string subject, SceneKeys keys,
                   AssetDiagnostics& diagnostics);

    using YamlMapReader::node;
    using YamlMapReader::SubjectOf;

    const YamlNode* Find(std::string_view key);
    template <typename T>
    bool Read(std::string_view key, T& value)
    {
        Ask(key);
        return YamlMapReader::Read(key, value);
    }
    bool Read(std::string_view key, float& value);
    bool Read(std::string_view key, glm::vec3& value);
    /// Reads a member of an enum by its name or its number.
    template <typename Enum>
    void Read(std::string_view key, std::span<const EnumEntry> entries, Enum& value)
    {
        value = static_cast<Enum>(ReadNumber(key, entries, static_cast<int>(value)));
    }
    /// Reads Euler angles in degrees.
    bool Read(std::string_view key, glm::quat& rotation);
    /// Reads a number that must be at least `least`, instead of the key's own lower limit.
    bool ReadFrom(double least, std::string_view key, float& value);
    void Finish();

private:
    const SceneKey& Ask(std::string_view key);
    int ReadNumber(std::string_view key, std::span<const EnumEntry> entries, int otherwise);

    AssetDiagnostics& m_Diagnostics;
    SceneKeys m_Keys;
    std::uint32_t m_Asked = 0; ///< a bit for each key
};

} // namespace limn
