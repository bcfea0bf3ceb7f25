#include "Mentions.h"
#include "ShaderTestSupport.h"

#include <limn/shaderlab/ShaderDatabase.h>

namespace limn
{

namespace
{

std::string ShaderText(const std::string& name, const std::string& pass = "P")
{
    return "Shader \"" + name + "\" { SubShader { Pass { Name \"" + pass + "\" } } }";
}

std::shared_ptr<const ShaderLabDocument> Document(const std::string& name, const char* file)
{
    return std::make_shared<const ShaderLabDocument>(
        ParseShaderLab(ShaderText(name), file).document);
}

/// What FindShaderFiles gives, relative to the folder.
std::vector<std::string> FoundFiles(const std::filesystem::path& folder)
{
    std::vector<std::string> files;
    for (const std::filesystem::path& file : FindShaderFiles(folder))
    {
        files.push_back(file.lexically_relative(folder).string());
    }
    return files;
}

} // namespace

TEST(ShaderDatabase, TakesTheFirstByPathOfEqualNames)
{
    test::TemporaryFolder folder;
    folder.Write("b/first.shader", ShaderText("Same"));
    folder.Write("z.shader", ShaderText("Same"));
    folder.Write("a/only.shader", ShaderText("Other"));
    ShaderDatabase database;
    database.AddFolder(folder.path());
    EXPECT_EQ(database.size(), 2U);
    ASSERT_NE(database.Find("Same"), nullptr);
    EXPECT_EQ(database.Find("Same")->file, (folder.path() / "b/first.shader").string());
    ASSERT_NE(database.Find("Other"), nullptr);
    EXPECT_EQ(database.Find("Other")->file, (folder.path() / "a/only.shader").string());
}

TEST(ShaderDatabase, KeepsWhatWasAddedBeforeAFolder)
{
    test::TemporaryFolder folder;
    folder.Write("a.shader", ShaderText("Same"));
    ShaderDatabase database;
    database.Add(Document("Same", "before.shader"));
    database.AddFolder(folder.path());
    database.Add(Document("Same", "after.shader"));
    EXPECT_EQ(database.size(), 1U);
    EXPECT_EQ(database.Find("Same")->file, "before.shader");
}

TEST(ShaderDatabase, PassesOverFilesWithErrors)
{
    test::TemporaryFolder folder;
    folder.Write("a.shader", "Shader \"Same\" { Oops }");
    folder.Write("b.shader", ShaderText("Same"));
    folder.Write("c.shader", "");
    ShaderDatabase database;
    database.AddFolder(folder.path());
    EXPECT_EQ(database.size(), 1U);
    ASSERT_NE(database.Find("Same"), nullptr) << "the broken file must not take the name";
    EXPECT_EQ(database.Find("Same")->file, (folder.path() / "b.shader").string());
}

TEST(ShaderDatabase, FindsByTheExactNameOnly)
{
    ShaderDatabase database;
    database.Add(Document("My/Toon", "t.shader"));
    EXPECT_NE(database.Find("My/Toon"), nullptr);
    for (const char* name : {"my/toon", "My/Toon ", "Toon", "My/Toons", "My/", ""})
    {
        EXPECT_EQ(database.Find(name), nullptr) << name;
    }
}

TEST(ShaderDatabase, NamesWhatIsCompiledInAsTheFilesThemselvesDo)
{
    const std::string toon = ShaderText("My/Toon"), water = ShaderText("Water");
    const EmbeddedFile files[] = {{"surfaces/T.shader", toon}, {"W.shader", water}};
    ShaderDatabase database;
    database.Add(files);
    EXPECT_EQ(database.names(), (std::vector<std::string_view>{"My/Toon", "Water"}));
    EXPECT_EQ(database.Find("My/Toon")->file, "T.shader");
    EXPECT_EQ(database.FindFile("T.shader"), database.Find("My/Toon"));
    EXPECT_EQ(database.FindFile("Toon.shader"), nullptr);
    const EmbeddedFile broken[] = {{"B.shader", "Shader {"}};
    EXPECT_THROW(database.Add(broken), AssetError);
}

TEST(ShaderDatabase, KeepsItsOwnShaderWhereAnotherDatabaseHasTheName)
{
    ShaderDatabase own, other;
    own.Add(Document("Toon", "own.shader"));
    other.Add(Document("Toon", "other.shader"));
    other.Add(Document("Water", "w.shader"));
    own.Add(other);
    EXPECT_EQ(own.Find("Toon")->file, "own.shader");
    EXPECT_EQ(own.Find("Water"), other.Find("Water"));
}

TEST(ShaderDatabase, SuggestsTheNearestNameWhereOneIsNear)
{
    ShaderDatabase database;
    EXPECT_THAT(database.UnknownShader("Toom"), test::Mentions("'Toom'", "0 known"));
    database.Add(Document("Toon", "t.shader"));
    database.Add(Document("Water", "w.shader"));
    EXPECT_EQ(database.UnknownShader("Toom"), "'Toom'; did you mean 'Toon'?");
    EXPECT_EQ(database.UnknownShader("waters"), "'waters'; did you mean 'Water'?");
    EXPECT_THAT(database.UnknownShader("Quicksilver"), test::Mentions("'Quicksilver'", "2 known"));
}

TEST(ShaderDatabase, RefusesANullDocumentAndAFolderThatIsNotThere)
{
    test::TemporaryFolder folder;
    ShaderDatabase database;
    EXPECT_THROW(database.Add(nullptr), ContractError);
    EXPECT_THROW(database.AddFolder(folder.path() / "absent"), AssetError);
}

TEST(FindShaderFiles, SortsByPathAndTakesTheExtensionOnly)
{
    test::TemporaryFolder folder;
    for (const char* name : {"b.shader", "a/z.shader", "a/deep/er/y.shader", "c.SHADER",
                             "d.shader.txt", "e.hlsl", "shader"})
    {
        folder.Write(name, "");
    }
    std::filesystem::create_directories(folder.path() / "folder.shader");
    EXPECT_EQ(FoundFiles(folder.path()),
              (std::vector<std::string>{"a/deep/er/y.shader", "a/z.shader", "b.shader"}));
}

TEST(FindShaderFiles, FollowsLinksToFilesButNotToFolders)
{
    test::TemporaryFolder folder;
    folder.Write("searched/own.shader", "");
    folder.Write("elsewhere/other.shader", "");
    const std::filesystem::path searched = folder.path() / "searched";
    std::filesystem::create_directory_symlink(folder.path() / "elsewhere", searched / "away");
    std::filesystem::create_directory_symlink(searched, searched / "circle");
    std::filesystem::create_symlink(folder.path() / "elsewhere/other.shader",
                                    searched / "linked.shader");
    std::filesystem::create_symlink(folder.path() / "nowhere", searched / "dangling.shader");
    EXPECT_EQ(FoundFiles(searched), (std::vector<std::string>{"linked.shader", "own.shader"}));
}

} // namespace limn
