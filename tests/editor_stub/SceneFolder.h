#pragma once

#include "TemporaryFolder.h"
#include "volume/Problems.h"

#include <limn/editor_stub/SceneFile.h>

namespace limn::test
{

/// A folder with a scene file and what it refers to.
class SceneFolder
{
public:
    SceneFolder()
    {
        Write("on.profile.yaml", "ScreenSpaceOutline: {m_Enable: true, m_OutlineWidth: 4}\n");
    }

    std::filesystem::path Write(const std::string& name, std::string_view text) const
    {
        return m_Folder.Write(name, text);
    }

    /// The scene of this text; `assets` of this folder lives as long as it.
    SceneAsset Load(std::string_view text)
    {
        return LoadScene(Write("s.scene.yaml", text), assets);
    }

    /// A scene with a camera and these lines behind it.
    SceneAsset LoadWithCamera(const std::string& text) { return Load("camera: {}\n" + text); }

    /// What is wrong with the scene of this text: "line:column: message" each, the folder's own
    /// path taken out.
    std::vector<std::string> ProblemsOf(std::string_view text)
    {
        std::vector<std::string> problems = Problems([&] { Load(text); });
        const std::string path = (m_Folder / "").generic_string();
        for (std::string& problem : problems)
        {
            const std::size_t at = problem.find(path);
            problem = at == std::string::npos ? problem : problem.erase(at, path.size());
        }
        return problems;
    }

    std::filesystem::path operator/(const std::string& name) const { return m_Folder / name; }
    const TemporaryFolder& folder() const { return m_Folder; }

    AssetContext assets;

private:
    TemporaryFolder m_Folder;
};

} // namespace limn::test
