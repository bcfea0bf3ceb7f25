#include "FuzzSupport.h"
#include "unity_scene/UnityHierarchy.h"

using namespace limn;

namespace
{

/// Files that follow each other, each behind a line "=== GUID" of its own but the first.
std::vector<std::pair<std::string, std::string>> FilesIn(std::string_view text)
{
    constexpr std::string_view k_Mark = "=== ";
    std::vector<std::pair<std::string, std::string>> files(1);
    while (!text.empty())
    {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        const std::string_view line = text.substr(0, end);
        if (line.starts_with(k_Mark))
        {
            files.emplace_back(line.substr(k_Mark.size(), 32), "");
        }
        else
        {
            files.back().second += line;
        }
        text.remove_prefix(end);
    }
    return files;
}

void Expand(const std::vector<std::pair<std::string, std::string>>& files)
{
    const auto find = [&](const std::string& guid) -> std::shared_ptr<const UnityFile>
    {
        for (const auto& [own, text] : files)
        {
            if (own == guid && !guid.empty())
            {
                return std::make_shared<const UnityFile>(text, guid + ".prefab");
            }
        }
        return nullptr;
    };
    const UnityExpansion expansion(
        std::make_shared<const UnityFile>(files.front().second, "fuzz.unity"), find);
    UnityNotes notes;
    const UnityHierarchy hierarchy(expansion, notes);
    for (const UnityGameObject* object : hierarchy.objects())
    {
        for (const UnityInstance* component : object->components)
        {
            const UnityReader reader(*component, object->path, notes);
            glm::vec3 vector(0.0f);
            bool isOn = false;
            reader.Read("m_LocalPosition", vector);
            reader.Read("m_Enabled", isOn);
            reader.Count("m_Materials");
            reader.Reference("m_Materials.Array.data[0]");
            reader.Reference("m_Mesh");
        }
    }
    notes.Finish("fuzz.unity");
}

} // namespace

/// Any bytes are a scene and the prefabs in it, or there is a complaint.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto files = FilesIn(test::FuzzText(data, size));
    test::OrSentence([&] { Expand(files); });
    return 0;
}
