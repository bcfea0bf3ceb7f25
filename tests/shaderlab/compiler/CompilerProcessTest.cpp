#include "Mentions.h"
#include "ShaderTestSupport.h"

#include <limn/base/WorkerProcess.h>
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <future>
#include <pthread.h>

namespace limn
{
namespace
{

using testing::ElementsAre;
using namespace std::chrono_literals;

const std::string k_IsolatedVertex =
    "float4 vert(float4 p : POSITION) : SV_Position { return p; }\n";

ShaderCompilerOptions IsolatedOptions(std::chrono::milliseconds limit = 30s)
{
    ShaderCompilerOptions options;
    options.process = std::make_shared<WorkerProcess>();
    options.timeLimit = limit;
    return options;
}

std::vector<std::string> IsolatedMessages(ShaderCompiler& compiler, const PassProgram& program)
{
    try
    {
        compiler.Compile(program);
    }
    catch (const AssetError& error)
    {
        return test::Messages(error.diagnostics());
    }
    return {};
}

} // namespace

TEST(CompilerProcess, GivesWhatThisProcessGives)
{
    test::TemporaryFolder folder;
    folder.Write("color.hlsl", "float4 _Color;");
    PassProgram program =
        test::Program(k_IsolatedVertex +
                      "#include \"color.hlsl\"\n#warning look\n"
                      "Texture2D _T; SamplerState sampler_T;\n"
                      "float4 frag() : SV_Target { return _Color * _T.Sample(sampler_T, 0); }");
    program.file = (folder.path() / "t.shader").string();
    ShaderCompiler here;
    ShaderCompiler isolated(IsolatedOptions());
    EXPECT_EQ(*here.Compile(program), *isolated.Compile(program));
    EXPECT_EQ(here.includeFiles(), isolated.includeFiles());
    EXPECT_FALSE(isolated.includeFiles().empty());
}

TEST(CompilerProcess, PassesOnWhatIsWrongWithTheProgram)
{
    ShaderCompiler compiler(IsolatedOptions());
    EXPECT_THAT(
        IsolatedMessages(
            compiler, test::Program(k_IsolatedVertex + "float4 frag() : SV_Target { return _A; }")),
        ElementsAre("2:36: error: '_A': unknown variable"));
    EXPECT_THROW(compiler.Compile(test::Program("#include \"no.hlsl\"\n")), MissingIncludeError);
    EXPECT_THROW(compiler.Compile(test::Program(
                     k_IsolatedVertex + "RWTexture2D<float4> _T;\n"
                                        "float4 frag() : SV_Target { return _T[uint2(0, 0)]; }")),
                 UnsupportedProgramError);
}

TEST(CompilerProcess, MayDieWhileOthersGoOn)
{
    setenv("LIMN_TEST_ABORT", "dies.shader", 1);
    PassProgram dies = test::Program(k_IsolatedVertex + "float4 frag() : SV_Target { return 1; }");
    const PassProgram lives = dies;
    dies.file = "dies.shader";
    ShaderCompiler compiler(IsolatedOptions());
    ShaderCompiler dying(IsolatedOptions());
    const auto live = [&]
    {
        return compiler.Compile(lives);
    };
    std::vector<std::future<std::shared_ptr<const ShaderProgram>>> others;
    for (int i = 0; i < 4; ++i)
    {
        others.push_back(std::async(std::launch::async, live));
        EXPECT_THAT(IsolatedMessages(dying, dies),
                    ElementsAre(test::Mentions("1:1: error: program", "crashes", "Aborted", "6")));
    }
    for (auto& other : others)
    {
        EXPECT_FALSE(other.get()->fragmentSpirv.empty());
    }
    unsetenv("LIMN_TEST_ABORT");
}

TEST(CompilerProcess, IsForkedOffOnceBeforeThereAreThreads)
{
    static int forks = 0;
    pthread_atfork([] { ++forks; }, nullptr, nullptr);
    ShaderCompiler compiler(IsolatedOptions());
    EXPECT_EQ(1, forks);
    const PassProgram program =
        test::Program(k_IsolatedVertex + "float4 frag() : SV_Target { return 1; }");
    auto other = std::async(std::launch::async, [&] { return compiler.Compile(program); });
    EXPECT_EQ(*compiler.Compile(program), *other.get());
    EXPECT_EQ(1, forks) << "a child of a process with threads may wait for a lock of one of them";
}

TEST(CompilerProcess, EndsWhenItsTimeIsOver)
{
    ShaderCompiler compiler(IsolatedOptions(1ms));
    EXPECT_THAT(
        IsolatedMessages(
            compiler, test::Program(k_IsolatedVertex + "float4 frag() : SV_Target { return 1; }")),
        ElementsAre(test::Mentions("1:1: error: program", "longer than 1 ms", "smaller")));
}

} // namespace limn
