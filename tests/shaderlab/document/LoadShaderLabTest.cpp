#include "Mentions.h"
#include "ShaderTestSupport.h"

namespace limn
{
namespace
{

std::string LoadMessage(const std::filesystem::path& path)
{
    try
    {
        LoadShaderLab(path);
    }
    catch (const AssetError& error)
    {
        return error.what();
    }
    return "no error";
}

TEST(LoadShaderLab, ReadsAFile)
{
    test::TemporaryFolder folder;
    const auto path = folder.Write("a.shader", "Shader \"A\" { SubShader { Pass { } } }");
    const ShaderLabDocument document = LoadShaderLab(path);
    EXPECT_EQ(document.name, "A");
    EXPECT_EQ(document.file, path.string());
}

TEST(LoadShaderLab, SaysThatAFileIsMissing)
{
    EXPECT_THAT(LoadMessage("/nowhere/a.shader"),
                test::Mentions("/nowhere/a.shader: error", "no such file"));
}

TEST(LoadShaderLab, SaysThatAFileIsEmpty)
{
    test::TemporaryFolder folder;
    const auto path = folder.Write("a.shader", "");
    EXPECT_THAT(LoadMessage(path),
                test::Mentions(path.string() + ": error: file", "empty", "Shader \"name\""));
}

TEST(LoadShaderLab, SaysThatAFileIsBinary)
{
    test::TemporaryFolder folder;
    const auto path = folder.Write("a.shader", std::string_view("Shader\0x", 8));
    EXPECT_THAT(LoadMessage(path),
                test::Mentions(path.string() + ": error: file", "binary", "UTF-8"));
}

TEST(LoadShaderLab, SaysThatAFileIsInUtf16)
{
    test::TemporaryFolder folder;
    const auto path = folder.Write("a.shader", std::string_view("\xFF\xFES\0h\0", 6));
    EXPECT_THAT(LoadMessage(path),
                test::Mentions(path.string() + ": error: file", "UTF-16", "UTF-8"));
}

TEST(LoadShaderLab, GivesWarningsAndErrorsBesideTheDocument)
{
    test::TemporaryFolder folder;
    const auto path =
        folder.Write("a.shader", "Shader \"A\" { SubShader { Pass { Cull Bak ZTest [_A b] } } }");
    const ShaderLabParseResult result = LoadShaderLabWithDiagnostics(path);
    EXPECT_EQ(result.document.name, "A");
    ASSERT_EQ(result.diagnostics.size(), 2u);
    EXPECT_EQ(result.diagnostics[0].severity, Severity::Error);
    EXPECT_EQ(result.diagnostics[1].severity, Severity::Warning);
    EXPECT_THROW(LoadShaderLabWithDiagnostics(folder.path() / "none.shader"), AssetError);
}

TEST(LoadShaderLab, SaysThatAFolderCannotBeRead)
{
    test::TemporaryFolder folder;
    EXPECT_THAT(LoadMessage(folder.path()),
                test::Mentions(folder.path().string() + ": error", "is a folder"));
}

TEST(LoadShaderLab, ThrowsAllErrorsOfTheFile)
{
    test::TemporaryFolder folder;
    const auto path =
        folder.Write("a.shader", "Shader \"A\" { SubShader { Pass {\nCull Bak\nZWrite Onn\n} } }");
    EXPECT_THAT(LoadMessage(path),
                test::Mentions(path.string() + ":2:6: error: Cull", "'Bak'", "'Back'",
                               "\n" + path.string() + ":3:8: error: ZWrite", "'Onn'", "'On'"));
}

} // namespace
} // namespace limn
