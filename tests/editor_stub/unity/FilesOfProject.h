#pragma once

#include "unity/UnityReader.h"

#include <map>
#include <memory>
#include <string>

namespace limn::test
{

/// Text assets by guid.
class FilesOfProject
{
public:
    void Add(const std::string& guid, const std::string& text)
    {
        m_Files[guid] = std::make_shared<const UnityFile>(text, guid + ".prefab");
    }
    std::unique_ptr<UnityExpansion> Expand(const std::string& guid) const
    {
        return std::make_unique<UnityExpansion>(m_Files.at(guid),
                                                [this](const std::string& wanted)
                                                {
                                                    const auto found = m_Files.find(wanted);
                                                    return found == m_Files.end() ? nullptr
                                                                                  : found->second;
                                                });
    }

private:
    std::map<std::string, std::shared_ptr<const UnityFile>> m_Files;
};

/// A GameObject of that id with a Transform of ten times the id.
inline std::string ObjectText(long id, const std::string& name, long father = 0)
{
    const std::string own = std::to_string(id);
    return "--- !u!1 &" + own + "\nGameObject:\n  m_Name: " + name + "\n  m_Layer: 0\n--- !u!4 &" +
           own + "0\nTransform:\n  m_GameObject: {fileID: " + own +
           "}\n  m_LocalPosition: {x: 1, y: 2, z: 3}\n  m_Father: {fileID: " +
           std::to_string(father) + "}\n";
}

inline std::string InstanceText(std::int64_t id, const std::string& source,
                                const std::string& changes, const std::string& more = "")
{
    return "--- !u!1001 &" + std::to_string(id) +
           "\nPrefabInstance:\n  m_Modification:\n    m_TransformParent: {fileID: 0}\n"
           "    m_Modifications:\n" +
           changes + "    m_RemovedComponents: []\n" + more +
           "  m_SourcePrefab: {fileID: 100100000, guid: " + source + ", type: 3}\n";
}

} // namespace limn::test
