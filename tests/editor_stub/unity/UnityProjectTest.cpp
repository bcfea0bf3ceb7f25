#include "unity/UnityProject.h"

#include "TemporaryFolder.h"
#include "commands/WorkingFolder.h"

#include <fstream>
#include <gmock/gmock.h>

namespace limn::test
{
namespace
{

const std::string k_GuidA(32, 'a');
const std::string k_GuidB(32, 'b');

TEST(UnityProjectAround, TakesTheProjectThoughItsAssetsHaveAFolderAssets)
{
    const TemporaryFolder folder;
    folder.Write("Project/ProjectSettings/TagManager.asset", "");
    folder.Write("Project/Assets/Assets/a.mat", "");
    EXPECT_EQ(UnityProjectAround(folder / "Project/Assets/Assets/a.mat"), folder / "Project");
    EXPECT_EQ(UnityProjectAround(folder / "Project/Assets/a.unity"), folder / "Project");
}

TEST(UnityProjectAround, TakesTheNearestAssetsWhereNoFolderHasProjectSettings)
{
    const TemporaryFolder folder;
    folder.Write("A/Assets/B/Assets/a.mat", "");
    EXPECT_EQ(UnityProjectAround(folder / "A/Assets/B/Assets/a.mat"), folder / "A/Assets/B");
}

/// Returns the path of the file with guid A, and the project's, found around an asset.
std::pair<std::string, std::string> NamesAround(const std::filesystem::path& asset)
{
    const UnityProject project(asset);
    const std::filesystem::path* path = project.Find(k_GuidA);
    return {path != nullptr ? path->string() : "", project.root().string()};
}

TEST(UnityProject, NamesFilesFromWhereTheAssetWasNamed)
{
    using testing::Pair;
    const WorkingFolder working;
    working.folder.Write("Project/Assets/Deep/A.fbx.meta",
                         "fileFormatVersion: 2\nguid: " + k_GuidA);
    EXPECT_THAT(NamesAround("Project/Assets/x.unity"),
                Pair("Project/Assets/Deep/A.fbx", "Project"));
    EXPECT_THAT(NamesAround(working.folder / "Project/./Assets/x.unity"),
                Pair(working.folder / "Project/Assets/Deep/A.fbx", working.folder / "Project"));
    std::filesystem::current_path("Project");
    EXPECT_THAT(NamesAround("./Assets/x.unity"), Pair("Assets/Deep/A.fbx", "."));
    std::filesystem::current_path("Assets/Deep");
    EXPECT_THAT(NamesAround("x.unity"), Pair("../../Assets/Deep/A.fbx", "../.."));
}

/// A project whose .meta files were last changed an hour ago.
class KeptGuids : public testing::Test
{
protected:
    void WriteMeta(const std::string& name, const std::string& guid, int hoursAgo = 1)
    {
        const std::filesystem::path path = m_Folder.Write(
            "Project/Assets/" + name + ".meta", "fileFormatVersion: 2\nguid: " + guid + "\n");
        std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() -
                                                   std::chrono::hours(hoursAgo));
        if (hoursAgo == 1)
        {
            m_Time = std::filesystem::last_write_time(path);
        }
    }
    /// Writes another guid as if nobody had.
    void WriteUnseen(const std::string& name, const std::string& guid)
    {
        WriteMeta(name, guid, 2);
        std::filesystem::last_write_time(m_Folder / ("Project/Assets/" + name + ".meta"), m_Time);
    }
    std::string PathOf(const std::string& guid, const std::string& cache = "cache") const
    {
        const UnityProject project(m_Folder / "Project/Assets/x",
                                   cache.empty() ? std::filesystem::path() : m_Folder / cache);
        const std::filesystem::path* path = project.Find(guid);
        return path != nullptr ? path->filename().string() : "";
    }

    TemporaryFolder m_Folder;
    std::filesystem::file_time_type m_Time;
};

TEST_F(KeptGuids, AreNotReadAgain)
{
    WriteMeta("A.fbx", k_GuidA);
    EXPECT_EQ(PathOf(k_GuidA), "A.fbx");
    WriteUnseen("A.fbx", k_GuidB);
    EXPECT_EQ(PathOf(k_GuidA), "A.fbx") << "size and time are those that were kept";
    EXPECT_EQ(PathOf(k_GuidA, ""), "") << "without a cache the file is read";
}

TEST_F(KeptGuids, AreReadAgainWhereAFileHasChanged)
{
    WriteMeta("A.fbx", k_GuidA);
    EXPECT_EQ(PathOf(k_GuidA), "A.fbx");
    WriteMeta("A.fbx", k_GuidB, 3);
    EXPECT_EQ(PathOf(k_GuidB), "A.fbx");
    EXPECT_EQ(PathOf(k_GuidA), "");
    WriteMeta("C.fbx", k_GuidA);
    EXPECT_EQ(PathOf(k_GuidA), "C.fbx");
    std::filesystem::remove(m_Folder / "Project/Assets/A.fbx.meta");
    EXPECT_EQ(PathOf(k_GuidB), "");
}

TEST_F(KeptGuids, AreNotKeptOfAFileThatHasJustBeenWritten)
{
    WriteMeta("A.fbx", k_GuidA, 0);
    const auto time = std::filesystem::last_write_time(m_Folder / "Project/Assets/A.fbx.meta");
    EXPECT_EQ(PathOf(k_GuidA), "A.fbx");
    WriteMeta("A.fbx", k_GuidB, 0);
    std::filesystem::last_write_time(m_Folder / "Project/Assets/A.fbx.meta", time);
    EXPECT_EQ(PathOf(k_GuidB), "A.fbx") << "it changed within a tick of the clock";
}

TEST_F(KeptGuids, AreReadWhereTheIndexIsDamaged)
{
    WriteMeta("A.fbx", k_GuidA);
    EXPECT_EQ(PathOf(k_GuidA), "A.fbx");
    for (const auto& entry : std::filesystem::directory_iterator(m_Folder / "cache"))
    {
        std::filesystem::resize_file(entry.path(), entry.file_size() - 3);
    }
    WriteUnseen("A.fbx", k_GuidB);
    EXPECT_EQ(PathOf(k_GuidB), "A.fbx");
    WriteUnseen("A.fbx", k_GuidA);
    EXPECT_EQ(PathOf(k_GuidB), "A.fbx") << "the index was replaced";
}

} // namespace
} // namespace limn::test
