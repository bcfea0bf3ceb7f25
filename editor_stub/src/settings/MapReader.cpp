#include "settings/MapReader.h"

#include "settings/ReadValues.h"

#include <algorithm>
#include <limn/base/Diagnostic.h>
#include <limn/core/Transform.h>

namespace limn
{

SceneMapReader::SceneMapReader(const YamlNode& node, std::string subject, SceneKeys keys,
                               AssetDiagnostics& diagnostics)
    : YamlMapReader(node, std::move(subject), diagnostics), m_Diagnostics(diagnostics), m_Keys(keys)
{
    for (const SceneKey& key : keys)
    {
        YamlMapReader::Find(key.name); // so that messages list them in this order
    }
}

const SceneKey& SceneMapReader::Ask(std::string_view key)
{
    const auto found = std::ranges::find(m_Keys, key, &SceneKey::name);
    if (found == m_Keys.end())
    {
        throw ContractError(SubjectOf(key) + " is read, and settings/Keys.h does not have the key");
    }
    m_Asked |= std::uint32_t{1} << (found - m_Keys.begin());
    return *found;
}

const YamlNode* SceneMapReader::Find(std::string_view key)
{
    Ask(key);
    return YamlMapReader::Find(key);
}

bool SceneMapReader::Read(std::string_view key, float& value)
{
    return YamlMapReader::Read(key, value, Ask(key).range);
}

bool SceneMapReader::Read(std::string_view key, glm::vec3& value)
{
    return YamlMapReader::Read(key, value, Ask(key).range);
}

bool SceneMapReader::Read(std::string_view key, glm::quat& rotation)
{
    glm::vec3 degrees(0.0f);
    const bool isRead = Read(key, degrees);
    rotation = isRead ? EulerToRotation(degrees) : rotation;
    return isRead;
}

int SceneMapReader::ReadNumber(std::string_view key, std::span<const EnumEntry> entries,
                               int otherwise)
{
    const YamlNode* node = Find(key);
    return node ? ReadEnum(*node, entries, SubjectOf(key), m_Diagnostics).value_or(otherwise)
                : otherwise;
}

bool SceneMapReader::ReadFrom(double least, std::string_view key, float& value)
{
    return YamlMapReader::Read(key, value, {least, Ask(key).range.max});
}

void SceneMapReader::Finish()
{
    for (std::size_t i = 0; i < m_Keys.size(); ++i)
    {
        if (((m_Asked >> i) & 1u) == 0)
        {
            throw ContractError(SubjectOf(m_Keys[i].name) +
                                " is in settings/Keys.h, and nothing reads it");
        }
        if (m_Keys[i].isRequired)
        {
            Require(m_Keys[i].name);
        }
    }
    YamlMapReader::Finish();
}

} // namespace limn
