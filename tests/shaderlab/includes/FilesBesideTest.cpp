#include "includes/FilesBeside.h"

#include "TemporaryFolder.h"

#include <gmock/gmock.h>
#include <limn/base/WorkerProcess.h>
#include <limn/shaderlab/EmbeddedIncludes.h>
#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/ShaderCompiler.h>
#include <limn/shaderlab/ShaderLabParser.h>

namespace limn::test
{

namespace
{

/// A pass that calls what an include defines.
PassProgram ProgramOf(const std::string& file, const std::string& include)
{
    const auto parsed = ParseShaderLab(
        "Shader \"X\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex V\n#pragma fragment F\n"
        "#include \"" +
            include +
            "\"\nfloat4 V(float4 p : POSITION) : SV_POSITION { return p; }\n"
            "float4 F() : SV_Target { return Tint(); }\nENDHLSL } } }",
        file);
    return parsed.document.subShaders.at(0).passes.at(0).program.value();
}

constexpr EmbeddedFile k_Files[] = {
    {"shaders/X.shader", ""},
    {"shaders/Tint.hlsl", "#include \"../common/One.cginc\"\nfloat4 Tint() { return One(); }"},
    {"common/One.cginc", "float4 One() { return 1; }"},
    {"common/Wrong.hlsl", "float4 Tint()\n{\n    return nothing;\n}"}};

} // namespace

TEST(FilesBeside, AreIncludedFromWhereTheyLie)
{
    SetEmbeddedIncludes("beside", k_Files);
    for (const bool isIsolated : {false, true})
    {
        ShaderCompilerOptions options;
        options.process = isIsolated ? std::make_shared<WorkerProcess>() : nullptr;
        ShaderCompiler compiler(options);
        for (const char* include :
             {"Tint.hlsl", "tint.HLSL", "../shaders/Tint.hlsl", "Assets/Effects/Tint.hlsl"})
        {
            EXPECT_NO_THROW(compiler.Compile(ProgramOf("beside/shaders/X.shader", include)))
                << include;
        }
        EXPECT_THROW(compiler.Compile(ProgramOf("beside/shaders/X.shader", "One.cginc")),
                     MissingIncludeError);
        EXPECT_THROW(compiler.Compile(ProgramOf("other/shaders/X.shader", "Tint.hlsl")),
                     MissingIncludeError);
        EXPECT_TRUE(compiler.includeFiles().count("beside/shaders/Tint.hlsl") == 0);
    }
}

TEST(FilesBeside, AMistakeInOneIsAtItsLine)
{
    SetEmbeddedIncludes("beside", k_Files);
    ShaderCompiler compiler;
    try
    {
        compiler.Compile(ProgramOf("beside/shaders/X.shader", "../common/Wrong.hlsl"));
        FAIL() << "it compiles";
    }
    catch (const AssetError& error)
    {
        EXPECT_THAT(error.what(), testing::HasSubstr("beside/common/Wrong.hlsl:3:"));
    }
}

TEST(FilesBeside, OthersInTheirPlaceAreCompiledAnew)
{
    const TemporaryFolder folder;
    ShaderCompilerOptions options;
    options.cacheFolder = folder.path();
    ShaderCompiler compiler(options);
    const PassProgram program = ProgramOf("anew/X.shader", "Tint.hlsl");
    constexpr EmbeddedFile first[] = {{"Tint.hlsl", "float4 Tint() { return 1; }"}};
    constexpr EmbeddedFile second[] = {{"Tint.hlsl", "float4 Tint() { return 2; }"}};
    SetEmbeddedIncludes("anew", first);
    const auto one = compiler.Compile(program)->fragmentSpirv;
    EXPECT_EQ(one, compiler.Compile(program)->fragmentSpirv);
    EXPECT_EQ(1, compiler.statistics().loadedFromCache);
    SetEmbeddedIncludes("anew", second);
    EXPECT_NE(one, compiler.Compile(program)->fragmentSpirv);
}

TEST(FilesBeside, AreFoundByTheirLastNameInAProjectWhereThereIsOne)
{
    const FilesBeside files = {
        {"a/x/Noise.hlsl", ""}, {"a/y/Blur.hlsl", ""}, {"a/z/Blur.hlsl", ""}};
    EXPECT_EQ(&files[0], FindFileOfProject(files, "Assets/Any/noise.hlsl"));
    EXPECT_EQ(&files[0], FindFileOfProject(files, "Packages/com.x.y/Noise.hlsl"));
    EXPECT_EQ(nullptr, FindFileOfProject(files, "Assets/Blur.hlsl"));
    EXPECT_EQ(nullptr, FindFileOfProject(files, "Noise.hlsl"));
}

} // namespace limn::test
