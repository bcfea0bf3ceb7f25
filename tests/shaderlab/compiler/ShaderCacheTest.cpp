#include "ShaderTestSupport.h"

namespace limn
{
namespace
{

constexpr const char* k_Program =
    "cbuffer UnityPerMaterial { float4 _Color; float4x4 _M; };\n"
    "Texture2D _T; SamplerState sampler_T; StructuredBuffer<float4> _S;\n"
    "float4 vert(float4 p : POSITION) : SV_Position { return p + _S[0]; }\n"
    "float4 frag() : SV_Target { return _T.Sample(sampler_T, 0) * _Color; }\n";

/// One compilation by a fresh compiler: what it gave and whether the cache answered.
struct Result
{
    std::shared_ptr<const ShaderProgram> pass;
    bool fromCache = false;
};

Result CompileWith(const std::filesystem::path& cache, const PassProgram& program,
                   const std::vector<std::string>& keywords = {})
{
    ShaderCompiler compiler({cache, {}, {}});
    const auto pass = compiler.Compile(program, keywords);
    const ShaderCompiler::Statistics statistics = compiler.statistics();
    EXPECT_EQ(statistics.compiled + statistics.loadedFromCache, 1);
    return {pass, statistics.loadedFromCache == 1};
}

std::filesystem::path OnlyFile(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        files.push_back(entry.path());
    }
    EXPECT_EQ(files.size(), 1u);
    return files.at(0);
}

TEST(ShaderCache, AnswersTheSecondCompilerWithTheSamePass)
{
    test::TemporaryFolder folder;
    const auto cache = folder.path() / "made/on/first/use";
    const Result first = CompileWith(cache, test::Program(k_Program));
    const Result second = CompileWith(cache, test::Program(k_Program));
    EXPECT_FALSE(first.fromCache);
    EXPECT_TRUE(second.fromCache);
    EXPECT_EQ(*first.pass, *second.pass);
}

TEST(ShaderCache, WritesThroughNoLink)
{
    test::TemporaryFolder folder;
    const auto victim = folder.Write("victim", "precious");
    const auto cache = folder.path() / "cache";
    CompileWith(cache, test::Program(k_Program));
    const std::filesystem::path entry = OnlyFile(cache);
    std::filesystem::remove(entry);
    std::filesystem::create_symlink(victim, entry);
    EXPECT_FALSE(CompileWith(cache, test::Program(k_Program)).fromCache);
    EXPECT_EQ(std::filesystem::file_size(victim), 8u);
    EXPECT_TRUE(CompileWith(cache, test::Program(k_Program)).fromCache);
}

TEST(ShaderCache, KnowsKeywordsApartButNotTheirOrder)
{
    test::TemporaryFolder folder;
    const PassProgram program = test::Program(k_Program);
    EXPECT_FALSE(CompileWith(folder.path(), program, {"A", "B"}).fromCache);
    EXPECT_TRUE(CompileWith(folder.path(), program, {"B", "A"}).fromCache);
    EXPECT_FALSE(CompileWith(folder.path(), program, {"A"}).fromCache);
}

TEST(ShaderCache, CompilesAgainWhenTheTextChangesButNotWhenItMoves)
{
    test::TemporaryFolder folder;
    PassProgram program = test::Program(k_Program);
    CompileWith(folder.path(), program);
    program.chunks[0].firstLine = 50;
    EXPECT_TRUE(CompileWith(folder.path(), program).fromCache);
    program.chunks[0].text += " ";
    EXPECT_FALSE(CompileWith(folder.path(), program).fromCache);
}

TEST(ShaderCache, CompilesAgainWhenAnIncludedFileChangesOrAppears)
{
    test::TemporaryFolder folder;
    const auto cache = folder.path() / "cache";
    folder.Write("a.hlsl", "#define VALUE 1\n");
    PassProgram program = test::Program("#include \"a.hlsl\"\n"
                                        "float4 vert() : SV_Position { return VALUE; }\n"
                                        "float4 frag() : SV_Target { return VALUE; }\n");
    program.file = (folder.path() / "sub/t.shader").string();
    EXPECT_THROW(CompileWith(cache, program), AssetError);
    program.file = (folder.path() / "t.shader").string();
    const Result first = CompileWith(cache, program);
    EXPECT_TRUE(CompileWith(cache, program).fromCache);
    folder.Write("a.hlsl", "#define VALUE 2\n");
    const Result changed = CompileWith(cache, program);
    EXPECT_FALSE(changed.fromCache);
    EXPECT_NE(changed.pass->fragmentSpirv, first.pass->fragmentSpirv);
    EXPECT_TRUE(CompileWith(cache, program).fromCache);
}

TEST(ShaderCache, NoticesAFileThatTakesThePlaceOfABuiltInOne)
{
    test::TemporaryFolder folder;
    const auto cache = folder.path() / "cache";
    PassProgram program = test::Program("#include \"UnityCG.cginc\"\n"
                                        "float4 vert() : SV_Position { return UNITY_PI; }\n"
                                        "float4 frag() : SV_Target { return 1; }\n");
    program.file = (folder.path() / "t.shader").string();
    CompileWith(cache, program);
    EXPECT_TRUE(CompileWith(cache, program).fromCache);
    folder.Write("UnityCG.cginc", "#define UNITY_PI 3\n");
    EXPECT_FALSE(CompileWith(cache, program).fromCache);
}

TEST(ShaderCache, RebuildsEntriesThatAreTornOrForeign)
{
    test::TemporaryFolder folder;
    const PassProgram program = test::Program(k_Program);
    const Result good = CompileWith(folder.path(), program);
    const auto file = OnlyFile(folder.path());
    const auto size = std::filesystem::file_size(file);
    for (const std::uintmax_t kept : {std::uintmax_t{0}, std::uintmax_t{5}, size / 2, size - 1})
    {
        std::filesystem::resize_file(file, kept);
        const Result rebuilt = CompileWith(folder.path(), program);
        EXPECT_FALSE(rebuilt.fromCache) << kept;
        EXPECT_EQ(*rebuilt.pass, *good.pass);
        EXPECT_TRUE(CompileWith(folder.path(), program).fromCache) << kept;
    }
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(size / 2));
    stream.put('\x5a').put('\xa5').put('\x5a');
    stream.close();
    EXPECT_EQ(*CompileWith(folder.path(), program).pass, *good.pass);
}

TEST(ShaderCache, DoesNotBelieveAnEntryUnderTheNameOfAnother)
{
    test::TemporaryFolder folder;
    const PassProgram program = test::Program(k_Program);
    const Result a = CompileWith(folder.path() / "a", program, {"A"});
    PassProgram other = program;
    other.chunks[0].text += "float4 unused;\n";
    other.chunks[0].text.replace(other.chunks[0].text.find("* _Color"), 8, "+ _Color");
    const Result b = CompileWith(folder.path() / "b", other, {"A"});
    ASSERT_NE(*a.pass, *b.pass);
    std::filesystem::copy_file(OnlyFile(folder.path() / "a"), OnlyFile(folder.path() / "b"),
                               std::filesystem::copy_options::overwrite_existing);
    const Result again = CompileWith(folder.path() / "b", other, {"A"});
    EXPECT_FALSE(again.fromCache);
    EXPECT_EQ(*again.pass, *b.pass);
}

TEST(ShaderCache, CompilesWhereAFolderHasTheNameOfAnEntry)
{
    test::TemporaryFolder folder;
    const PassProgram program = test::Program(k_Program);
    const Result good = CompileWith(folder.path(), program);
    const auto file = OnlyFile(folder.path());
    std::filesystem::remove(file);
    std::filesystem::create_directories(file / "full");
    for (int i = 0; i < 2; ++i)
    {
        const Result again = CompileWith(folder.path(), program);
        EXPECT_FALSE(again.fromCache);
        EXPECT_EQ(*again.pass, *good.pass);
    }
}

TEST(ShaderCache, WorksWithoutAFolderThatCanBeWritten)
{
    test::TemporaryFolder folder;
    const auto file = folder.Write("file", "no folder");
    EXPECT_FALSE(CompileWith(file / "cache", test::Program(k_Program)).fromCache);
    EXPECT_FALSE(CompileWith(file / "cache", test::Program(k_Program)).fromCache);
}

TEST(ShaderCache, LeavesNothingButItsEntries)
{
    test::TemporaryFolder folder;
    CompileWith(folder.path(), test::Program(k_Program));
    EXPECT_EQ(OnlyFile(folder.path()).extension(), ".limnpass");
}

} // namespace
} // namespace limn
