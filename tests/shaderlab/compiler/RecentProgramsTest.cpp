#include "compiler/RecentPrograms.h"

#include "ShaderTestSupport.h"

namespace limn
{
namespace
{

ShaderProgram WithCode(std::uint32_t word)
{
    ShaderProgram program;
    program.vertexSpirv = {word};
    return program;
}

TEST(RecentPrograms, AreTheSameObjectWhileTheyAreEqual)
{
    RecentPrograms recent;
    const auto first = recent.Share("a", WithCode(1));
    EXPECT_EQ(recent.Share("a", WithCode(1)), first);
    const auto changed = recent.Share("a", WithCode(2));
    EXPECT_EQ(changed->vertexSpirv, std::vector<std::uint32_t>{2});
    EXPECT_EQ(first->vertexSpirv, std::vector<std::uint32_t>{1}) << "callers have it still";
    EXPECT_NE(recent.Share("b", WithCode(2)), changed) << "of another pass";
}

TEST(RecentPrograms, AreThe128UsedLast)
{
    RecentPrograms recent;
    const std::weak_ptr<const ShaderProgram> used = recent.Share("used", WithCode(1));
    const std::weak_ptr<const ShaderProgram> left = recent.Share("left", WithCode(1));
    for (std::uint32_t i = 0; i < 127; ++i)
    {
        EXPECT_FALSE(left.expired()) << i;
        recent.Share(std::to_string(i), WithCode(i));
        recent.Share("used", WithCode(1));
    }
    EXPECT_TRUE(left.expired());
    EXPECT_FALSE(used.expired());
}

TEST(RecentPrograms, OfACompilerFollowTheFilesThatTheyInclude)
{
    const test::TemporaryFolder folder;
    folder.Write("a.hlsl", "#define VALUE 1\n");
    PassProgram program = test::Program("#include \"a.hlsl\"\n"
                                        "float4 vert() : SV_Position { return VALUE; }\n"
                                        "float4 frag() : SV_Target { return VALUE; }\n");
    program.file = (folder.path() / "t.shader").string();
    for (const auto& cache : {std::filesystem::path(), folder.path() / "cache"})
    {
        ShaderCompiler compiler({cache, {}, {}});
        folder.Write("a.hlsl", "#define VALUE 1\n");
        const auto first = compiler.Compile(program);
        EXPECT_EQ(compiler.Compile(program), first);
        folder.Write("a.hlsl", "#define VALUE 2\n");
        const auto second = compiler.Compile(program);
        EXPECT_NE(second->fragmentSpirv, first->fragmentSpirv);
        EXPECT_EQ(compiler.Compile(program), second);
    }
}

} // namespace
} // namespace limn
