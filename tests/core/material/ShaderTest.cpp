#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "Mentions.h"
#include "TemporaryFolder.h"
#include "ThrownMessage.h"
#include "scene/TestScene.h"

namespace limn
{
namespace
{

using test::Mentions;

int QueueOf(const std::string& tag)
{
    return test::ShaderWithModes({"A"}, tag)->renderQueue();
}

TEST(Shader, ReadsItsQueueFromTheTag)
{
    EXPECT_EQ(QueueOf("Background"), 1000);
    EXPECT_EQ(QueueOf("Geometry"), 2000);
    EXPECT_EQ(QueueOf("AlphaTest"), 2450);
    EXPECT_EQ(QueueOf("Transparent"), 3000);
    EXPECT_EQ(QueueOf("Overlay"), 4000);
    EXPECT_EQ(QueueOf("transparent"), 3000);
    EXPECT_EQ(QueueOf("2460"), 2460);
}

TEST(Shader, AddsTheOffsetToItsQueue)
{
    EXPECT_EQ(QueueOf("Transparent+10"), 3010);
    EXPECT_EQ(QueueOf("Geometry-1"), 1999);
    EXPECT_EQ(QueueOf("Geometry + 1"), 2001);
    EXPECT_EQ(QueueOf("Overlay+9999"), 5000);
    EXPECT_EQ(QueueOf("Background-9999"), 0);
    EXPECT_EQ(QueueOf("Geometry+2147483647"), 5000);
}

TEST(Shader, IsGeometryWithoutAQueue)
{
    EXPECT_EQ(test::ShaderOf("Shader \"Test\" { SubShader { Pass { } } }")->renderQueue(), 2000);
}

TEST(Shader, RefusesAQueueThatIsNone)
{
    for (const std::string queue : {"Geometrie", "Transparent+x", "Geometry+", "", "2450.5"})
    {
        const std::string message = test::ThrownMessage<AssetError>([&] { QueueOf(queue); });
        EXPECT_THAT(message, Mentions("Queue", "'" + queue + "'", "no render queue", "Background",
                                      "Overlay", "+N"));
    }
}

TEST(Shader, DrawsWithASubShaderThatTheCompilersDeviceCanRun)
{
    const std::string text = "Shader \"Test\" { SubShader { Pass { Name \"cubes\" HLSLPROGRAM\n"
                             "#pragma vertex V\n#pragma fragment F\n#pragma require cubearray\n"
                             "ENDHLSL } } SubShader { Pass { Name \"plain\" } } }";
    EXPECT_EQ(test::ShaderOf(text)->passName(0), "cubes");
    ShaderCompilerOptions options;
    options.missingFeatures = {"cubearray"};
    const auto compiler = std::make_shared<ShaderCompiler>(options);
    EXPECT_EQ(Shader::FromText(text, "test.shader", compiler)->passName(0), "plain");
}

TEST(Shader, FindsTheFirstPassOfALightMode)
{
    const auto shader = test::ShaderWithModes({"A", "B", "A"});
    EXPECT_EQ(shader->passCount(), 3);
    EXPECT_EQ(shader->FindPassByLightMode(ShaderTagId("A")), 0);
    EXPECT_EQ(shader->FindPassByLightMode(ShaderTagId("B")), 1);
    EXPECT_EQ(shader->FindPassByLightMode(ShaderTagId("C")), -1);
}

TEST(Shader, CountsAPassWithoutLightModeAsSrpDefaultUnlit)
{
    const auto shader = test::ShaderOf("Shader \"Test\" { SubShader {\n"
                                       "Pass { Tags { \"LightMode\" = \"A\" } }\nPass { } } }");
    EXPECT_EQ(shader->FindPassByLightMode(ShaderTagId("SRPDefaultUnlit")), 1);
}

TEST(Shader, FindsAPassByNameWhateverTheCase)
{
    const auto shader = test::ShaderOf("Shader \"Test\" { SubShader {\n"
                                       "Pass { Name \"Outline\" }\nPass { Name \"Fill\" } } }");
    EXPECT_EQ(shader->FindPassByName("FILL"), 1);
    EXPECT_EQ(shader->FindPassByName("outline"), 0);
    EXPECT_EQ(shader->FindPassByName("Glow"), -1);
    EXPECT_EQ(shader->passName(1), "Fill");
    EXPECT_EQ(Material(shader).FindPass("fill"), 1);
}

TEST(Shader, RefusesAPassIndexThatDoesNotExist)
{
    const auto shader = test::ShaderWithModes({"A"});
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { shader->passState(1); }),
                Mentions("'Test/Modes'", "no pass 1", "has 1"));
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { shader->Compile(-1); }),
                Mentions("'Test/Modes'", "no pass -1", "has 1"));
}

TEST(Shader, UsesTheFirstSubShaderForUrp)
{
    const auto shader = test::ShaderOf(
        "Shader \"Test\" {\n"
        "SubShader { Tags { \"RenderPipeline\" = \"HDRenderPipeline\" } Pass { Name \"Hdrp\" } }\n"
        "SubShader { Tags { \"RenderPipeline\" = \"UniversalPipeline\" } Pass { Name \"Urp\" } }\n"
        "SubShader { Pass { Name \"BuiltIn\" } } }");
    EXPECT_EQ(shader->passName(0), "Urp");
}

TEST(Shader, RefusesAFileWithoutAPassToDraw)
{
    const std::string message = test::ThrownMessage<AssetError>(
        [] { test::ShaderOf("Shader \"Test/Empty\" { Fallback Off }"); });
    EXPECT_THAT(message, Mentions("test.shader", "Test/Empty", "no SubShader", "RenderPipeline",
                                  "UniversalPipeline"));
}

TEST(Shader, CompilesAPassOnceAndKeepsIt)
{
    const auto compiler = std::make_shared<ShaderCompiler>();
    const auto shader =
        Shader::FromText("Shader \"Test\" { SubShader { Pass { " + test::Program() + " } } }",
                         "test.shader", compiler);
    EXPECT_EQ(compiler->statistics().compiled, 0);
    const auto first = shader->Compile(0);
    EXPECT_EQ(shader->Compile(0), first);
    EXPECT_EQ(compiler->statistics().compiled, 1);
    EXPECT_FALSE(first->vertexSpirv.empty());
    EXPECT_FALSE(first->fragmentSpirv.empty());
}

TEST(Shader, TriesAPassThatDoesNotCompileOnce)
{
    const test::TemporaryFolder folder;
    const auto shader = Shader::FromText(
        "Shader \"Test\" { SubShader { Pass { HLSLPROGRAM\n#include \"Late.hlsl\"\n" +
            test::Program().substr(std::string("HLSLPROGRAM").size()) + " } } }",
        (folder.path() / "test.shader").string(), std::make_shared<ShaderCompiler>());
    const auto compile = [&shader]
    {
        shader->Compile(0);
    };
    const std::string first = test::ThrownMessage<AssetError>(compile);
    EXPECT_NE(first.find("Late.hlsl"), std::string::npos);
    folder.Write("Late.hlsl", "\n"); // it is not looked at before the shader is loaded anew
    EXPECT_EQ(test::ThrownMessage<AssetError>(compile), first);
}

TEST(Shader, CompilesAPassOnceForManyThreads)
{
    const auto compiler = std::make_shared<ShaderCompiler>();
    const auto shader =
        Shader::FromText("Shader \"Test\" { SubShader { Pass { " + test::Program() + " } } }",
                         "test.shader", compiler);
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
    {
        threads.emplace_back([&] { shader->Compile(0); });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    EXPECT_EQ(compiler->statistics().compiled, 1);
}

TEST(Shader, SaysWhichFixedFunctionPassItCannotDraw)
{
    const std::string message =
        test::ThrownMessage<AssetError>([] { test::ShaderWithModes({"A"})->Compile(0); });
    EXPECT_THAT(message, Mentions("Test/Modes", "no program", "fixed-function", "HLSLPROGRAM"));
}

TEST(Shader, LoadsFromAFile)
{
    const test::TemporaryFolder folder;
    const auto path =
        folder.Write("mask.shader", "Shader \"Test/Mask\" { SubShader { Pass { } } }");
    EXPECT_EQ(Shader::Load(path, test::Compiler())->name(), "Test/Mask");
    EXPECT_THROW(Shader::Load(folder / "missing.shader", test::Compiler()), AssetError);
}

/// A program that takes the compiler a while.
std::string LongProgram()
{
    std::string functions = "float F0(float x) { return x; }\n";
    for (int i = 1; i <= 600; ++i)
    {
        const std::string before = "F" + std::to_string(i - 1) + "(x";
        functions += "float F" + std::to_string(i) + "(float x) { return sin(" + before +
                     " * 1.5)) + " + std::to_string(i) + "; }\n";
    }
    return test::Program(functions + "float _Value;", "F600(_Value)");
}

TEST(Shader, GivesOutOnePassWhileAnotherIsCompiled)
{
    const auto shader = Shader::FromText("Shader \"Test\" { SubShader { Pass { " + test::Program() +
                                             " } Pass { " + LongProgram() + " } } }",
                                         "test.shader", std::make_shared<ShaderCompiler>());
    shader->Compile(0);
    std::atomic<bool> isDone = false;
    std::thread compiling(
        [&]
        {
            shader->Compile(1);
            isDone = true;
        });
    int given = 0; // how often the first pass could be had before the second was there
    while (!isDone)
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        shader->Compile(0);
        given += isDone ? 0 : 1;
    }
    compiling.join();
    EXPECT_GE(given, 5);
}

} // namespace
} // namespace limn
