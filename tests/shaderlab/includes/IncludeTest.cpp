#include "Mentions.h"
#include "ShaderTestSupport.h"

#include <gmock/gmock.h>
#include <limn/shaderlab/FindPackages.h>

namespace limn
{
namespace
{

using test::Mentions;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string k_Functions = "\nfloat4 vert() : SV_POSITION { return 0; }\n"
                                "float4 frag() : SV_Target { return VALUE; }\n";

class IncludeOfAFile : public testing::Test
{
protected:
    /// Compiles a shader in project/Assets/Shaders that holds this and asks for the macro VALUE.
    std::vector<std::string> Compile(const std::string& hlsl, ShaderCompilerOptions options = {},
                                     const std::string& file = "project/Assets/Shaders/t.shader")
    {
        PassProgram program = test::Program(hlsl + k_Functions);
        program.file = Path(file);
        ShaderCompiler compiler(options);
        try
        {
            compiler.Compile(program);
            return {};
        }
        catch (const AssetError& error)
        {
            return test::Messages(error.diagnostics());
        }
    }

    std::string Path(const std::string& name) const { return (folder.path() / name).string(); }

    test::TemporaryFolder folder;
};

TEST_F(IncludeOfAFile, FindsNestedFilesFromTheFolderOfTheShader)
{
    folder.Write("project/Assets/Shaders/sub/a.hlsl", "#include \"sub/b.hlsl\"\n");
    folder.Write("project/Assets/Shaders/sub/b.hlsl", "#define VALUE 1\n");
    EXPECT_THAT(Compile("#include \"sub/a.hlsl\""), ElementsAre());
}

TEST_F(IncludeOfAFile, FindsPackagesByTheNameInTheirManifest)
{
    const std::string manifest = "{\"name\": \"com.me.NAME\", \"version\": \"1.0.0\"}";
    const auto manifestOf = [&](const std::string& name)
    {
        return std::string(manifest).replace(manifest.find("NAME"), 4, name);
    };
    folder.Write("project/Packages/src/package.json", manifestOf("own"));
    folder.Write("project/Packages/src/Lib/a.hlsl", "#include \"Packages/com.me.cached/b.hlsl\"\n");
    folder.Write("project/Library/PackageCache/com.me.cached@1.2.3/package.json",
                 manifestOf("cached"));
    folder.Write("project/Library/PackageCache/com.me.cached@1.2.3/b.hlsl", "#define VALUE 1\n");
    folder.Write("project/Packages/broken/package.json", "{\"name\": ");
    EXPECT_THAT(Compile("#include \"Packages/com.me.own/Lib/a.hlsl\""), ElementsAre());
    EXPECT_THAT(Compile("#include \"Packages/com.me.other/a.hlsl\""),
                ElementsAre(HasSubstr("there is no file \"Packages/com.me.other/a.hlsl\"")));
    // What limn stands in for is not mixed with a copy in the cache.
    folder.Write("project/Library/PackageCache/urp/package.json",
                 "{\"name\": \"com.unity.render-pipelines.universal\"}");
    folder.Write("project/Library/PackageCache/urp/Extra.hlsl", "#define VALUE 1\n");
    EXPECT_THAT(Compile("#include \"Packages/com.unity.render-pipelines.universal/Extra.hlsl\""),
                ElementsAre(HasSubstr("there is no file")));
}

// URP 7 to 13 have `positionOS` and `uv` there, later ones the structs of Blit.hlsl.
TEST_F(IncludeOfAFile, IsThatOfTheUrpThatTheProjectAsksFor)
{
    const std::string universal = "com.unity.render-pipelines.universal";
    const std::string common =
        "#include \"Packages/" + universal + "/Shaders/PostProcessing/Common.hlsl\"\n";
    const std::string older = common + "#define VALUE (((Attributes)0).positionOS)\n";
    const std::string later = common + "#define VALUE (((Varyings)0).texcoord.xyxy)\n";
    const auto writeManifest = [&](const std::string& file, const std::string& version)
    {
        folder.Write(file, R"({"dependencies": {")" + universal + "\": \"" + version + "\"}}");
    };
    ShaderCompilerOptions options;
    options.cacheFolder = folder.path() / "cache";
    const auto expect = [&](const std::string& compiles, const std::string& fails)
    {
        EXPECT_THAT(Compile(compiles, options), ElementsAre());
        EXPECT_THAT(Compile(fails, options), testing::Not(testing::IsEmpty()));
    };

    expect(later, older); // nothing is asked for
    for (const char* version : {"7.3.1", "10.3.2", "13.1.9"})
    {
        SCOPED_TRACE(version);
        writeManifest("project/Packages/manifest.json", version);
        expect(older, later);
    }
    for (const char* version : {"14.0.8", "17.3.0", "file:../urp", "x"})
    {
        SCOPED_TRACE(version);
        writeManifest("project/Packages/manifest.json", version);
        expect(later, older);
    }
    // A package says what it was written for. The project that it lies in decides.
    const std::string inPackage = "repository/Shaders/t.shader";
    writeManifest("repository/package.json", "12.1.7");
    folder.Write("repository/Shaders/a.hlsl", "");
    EXPECT_THAT(Compile(later, options, inPackage), ElementsAre()) << "it has no name";
    folder.Write("repository/package.json",
                 R"({"name": "com.me.rays", "dependencies": {")" + universal + R"(": "12.1.7"}})");
    EXPECT_THAT(Compile(older, options, inPackage), ElementsAre());
    folder.Write("project/Packages/rays/package.json",
                 R"({"name": "com.me.rays", "dependencies": {")" + universal + R"(": "12.1.7"}})");
    writeManifest("project/Packages/manifest.json", "14.0.8");
    EXPECT_THAT(Compile(later, options, "project/Packages/rays/t.shader"), ElementsAre());
}

TEST_F(IncludeOfAFile, HasTheDebugMacroOfTheUrpThatTheProjectAsksFor)
{
    const std::string universal = "com.unity.render-pipelines.universal";
    const std::string text = "#include \"Packages/" + universal +
                             "/ShaderLibrary/Debug/DebuggingCommon.hlsl\"\n"
                             "#define VALUE 1; SETUP_DEBUG_TEXTURE_DATA";
    const std::string earlier = text + "(inputData, uv, _BaseMap)\n";
    const std::string later = text + "(inputData, UNDO_TRANSFORM_TEX(uv, _BaseMap))\n";
    const auto writeManifest = [&](const std::string& version)
    {
        folder.Write("project/Packages/manifest.json",
                     R"({"dependencies": {")" + universal + "\": \"" + version + "\"}}");
    };
    writeManifest("14.0.8");
    EXPECT_THAT(Compile(earlier), ElementsAre());
    writeManifest("17.0.3");
    EXPECT_THAT(Compile(later), ElementsAre());
    EXPECT_THAT(Compile(earlier), testing::Not(testing::IsEmpty())) << "of another URP";
}

TEST_F(IncludeOfAFile, IsOfNoProjectWhereTheShaderHasANameOnly)
{
    const std::string universal = "com.unity.render-pipelines.universal";
    folder.Write("project/Packages/manifest.json",
                 R"({"dependencies": {")" + universal + R"(": "10.3.2"}})");
    folder.Write("project/Assets/On.shader", "");
    PassProgram program = test::Program("#include \"Packages/" + universal +
                                        "/Shaders/PostProcessing/Common.hlsl\"\n"
                                        "#define VALUE (((Varyings)0).texcoord.xyxy)\n" +
                                        k_Functions);
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder / "project/Assets");
    for (const char* builtIn : {"Own.shader", "Glow/Own.shader"})
    {
        program.file = builtIn;
        EXPECT_NO_THROW(ShaderCompiler().Compile(program));
    }
    program.file = "On.shader";
    EXPECT_THROW(ShaderCompiler().Compile(program), AssetError) << "it lies in the project";
    std::filesystem::current_path(before);
}

TEST_F(IncludeOfAFile, FindsThePackageThatTheShaderItselfIsPartOf)
{
    folder.Write("MyRepository/package.json", "{\"name\": \"com.me.repository\"}");
    folder.Write("MyRepository/ShaderLibrary/a.hlsl", "#define VALUE 1\n");
    PassProgram program =
        test::Program("#include \"Packages/com.me.repository/ShaderLibrary/a.hlsl\"" + k_Functions);
    program.file = Path("MyRepository/Shaders/t.shader");
    ShaderCompiler compiler;
    EXPECT_NO_THROW(compiler.Compile(program));
}

TEST_F(IncludeOfAFile, TakesTheProjectsOwnPipelineWhateverItsFolderIsCalled)
{
    const std::string universal = "com.unity.render-pipelines.universal";
    const std::string core = "com.unity.render-pipelines.core";
    const auto write = [&](const std::string& at, const std::string& name, const std::string& file,
                           const std::string& text)
    {
        folder.Write(at + "/package.json", "{\"name\": \"" + name + "\"}");
        folder.Write(at + "/" + file, text);
    };
    const std::string include = "#include \"Packages/" + universal + "/ShaderLibrary/Core.hlsl\"\n";
    const std::string coreInclude =
        "#include \"Packages/" + core + "/ShaderLibrary/Common.hlsl\"\n";
    // Unity's own copy in the cache: the library stands in for it.
    write("project/Library/PackageCache/" + core + "@12.1.6", core, "ShaderLibrary/Common.hlsl",
          "#define VALUE 1\n");
    EXPECT_THAT(Compile(coreInclude).size(), testing::Gt(0u));
    // One that the author has taken into the project brings all of them along.
    write("project/Packages/" + universal + "@12.1.6", universal, "ShaderLibrary/Core.hlsl",
          "#define OWN 1\n");
    EXPECT_THAT(Compile(include + "#ifdef OWN\n#define VALUE 1\n#endif\n"), ElementsAre());
    EXPECT_THAT(Compile(coreInclude), ElementsAre());
    // What it lacks is the library's.
    EXPECT_THAT(Compile("#define VALUE 1\n#include \"Packages/" + universal +
                        "/ShaderLibrary/SurfaceData.hlsl\"\n"),
                ElementsAre());
}

TEST_F(IncludeOfAFile, TakesAPipelineThatIsTheRepositoryAndTheOneBesideIt)
{
    folder.Write("repositories/urp/package.json",
                 "{\"name\": \"com.unity.render-pipelines.universal\"}");
    folder.Write(
        "repositories/urp/ShaderLibrary/Core.hlsl",
        "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl\"\n");
    folder.Write("repositories/srp-core/package.json",
                 "{\"name\": \"com.unity.render-pipelines.core\"}");
    folder.Write("repositories/srp-core/ShaderLibrary/Common.hlsl", "#define VALUE 1\n");
    PassProgram program = test::Program(
        "#include \"Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl\"" +
        k_Functions);
    program.file = Path("repositories/urp/Shaders/t.shader");
    ShaderCompiler compiler;
    EXPECT_NO_THROW(compiler.Compile(program));
}

TEST_F(IncludeOfAFile, SeesAPackageThatComesIntoTheProject)
{
    ShaderCompilerOptions options;
    options.cacheFolder = Path("cache");
    const std::string text =
        "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl\"\n"
        "#ifdef OWN\n#error own\n#endif\n#define VALUE 1\n";
    EXPECT_THAT(Compile(text, options), ElementsAre());
    folder.Write("project/Packages/srp/package.json",
                 "{\"name\": \"com.unity.render-pipelines.core\"}");
    folder.Write("project/Packages/srp/ShaderLibrary/Common.hlsl", "#define OWN 1\n");
    EXPECT_THAT(Compile(text, options).size(), 1u);
}

TEST_F(IncludeOfAFile, FindsPackagesInAFolderByTheirNames)
{
    folder.Write("one/package.json", "{\"name\": \"com.me.one\"}");
    folder.Write("one/inner/package.json", "{\"name\": \"com.me.inner\"}");
    folder.Write("many/a@1/package.json", "{\"name\": \"com.me.a\"}");
    folder.Write("many/b/package.json", "{\"name\": \"com.me.b\"}");
    folder.Write("many/c/package.json", "{\"version\": \"1.0.0\"}");
    using testing::Pair;
    EXPECT_THAT(FindPackages(Path("one")), ElementsAre(Pair("com.me.one", Path("one"))));
    EXPECT_THAT(FindPackages(Path("many")),
                ElementsAre(Pair("com.me.a", Path("many/a@1")), Pair("com.me.b", Path("many/b"))));
    EXPECT_THAT(FindPackages(Path("none")), ElementsAre());
}

TEST_F(IncludeOfAFile, FindsFilesBesideInTheProjectAndInPackages)
{
    folder.Write("project/Assets/Shaders/a.hlsl", "#include \"sub/b.hlsl\"\n");
    folder.Write("project/Assets/Shaders/sub/b.hlsl", "#include \"../../Common/c.hlsl\"\n");
    folder.Write("project/Assets/Common/c.hlsl", "#define VALUE 1\n");
    folder.Write("project/Packages/com.me.x/d.hlsl", "#include \"e.hlsl\"\n");
    folder.Write("project/Packages/com.me.x/e.hlsl", "#define VALUE 1\n");
    folder.Write("elsewhere/f.hlsl", "#define VALUE 1\n");
    EXPECT_THAT(Compile("#include \"a.hlsl\""), ElementsAre());
    // The working directory is another one: the file's own Unity project counts as well.
    EXPECT_THAT(Compile("#include \"Assets/Common/c.hlsl\""), ElementsAre());
    EXPECT_THAT(Compile("#include \"Packages/com.me.x/d.hlsl\""), ElementsAre());
    ShaderCompilerOptions options;
    options.projectRoot = Path("project");
    options.packages["com.me.y"] = Path("elsewhere");
    EXPECT_THAT(Compile("#include \"Assets/Common/c.hlsl\"", options), ElementsAre());
    EXPECT_THAT(Compile("#include \"Packages/com.me.x/d.hlsl\"", options), ElementsAre());
    EXPECT_THAT(Compile("#include <Packages/com.me.y/f.hlsl>", options), ElementsAre());
}

TEST_F(IncludeOfAFile, MayDependOnTheStage)
{
    folder.Write("project/Assets/Shaders/a.hlsl", "#ifdef SHADER_STAGE_FRAGMENT\n#define VALUE 1\n"
                                                  "#endif\n");
    EXPECT_THAT(Compile("#include \"a.hlsl\""), ElementsAre());
    folder.Write("project/Assets/Shaders/a.hlsl", "#ifdef SHADER_STAGE_VERTEX\n#define VALUE 1\n"
                                                  "#endif\n");
    EXPECT_THAT(Compile("#include \"a.hlsl\""), ElementsAre(HasSubstr("'VALUE'")));
}

TEST_F(IncludeOfAFile, TakesBackslashesAndNamesThatDifferInCase)
{
    folder.Write("project/Assets/Shaders/Sub/File.hlsl", "#define VALUE 1\n");
    EXPECT_THAT(Compile("#include \"sub\\\\file.HLSL\""), ElementsAre());
    EXPECT_THAT(Compile("#include \"unitycg.CGINC\"\n#define VALUE 1"), ElementsAre());
}

TEST_F(IncludeOfAFile, StaysInTheFoldersItMayReadFrom)
{
    const std::string secret = folder.Write("secret.hlsl", "#define VALUE 1\n").string();
    EXPECT_THAT(Compile("#include \"../../../secret.hlsl\""),
                ElementsAre(Mentions("1: error: #include: \"../../../secret.hlsl\"",
                                     "outside the folders", "--root")));
    EXPECT_THAT(Compile("#include \"" + secret + "\""),
                ElementsAre(Mentions("1: error: #include: \"" + secret + "\"", "absolute path",
                                     "project")));
    EXPECT_THAT(Compile("#include \"C:\\x.hlsl\"").at(0), HasSubstr("is an absolute path"));
    std::filesystem::create_directories(Path("project/Assets/Shaders"));
    std::filesystem::create_symlink(secret, Path("project/Assets/Shaders/link.hlsl"));
    EXPECT_THAT(Compile("#include \"link.hlsl\""),
                ElementsAre(Mentions("1: error: #include: \"link.hlsl\"", "outside the folders",
                                     "--root")));
    ShaderCompilerOptions options;
    options.includeFolders = {folder.path()};
    EXPECT_THAT(Compile("#include \"../../../secret.hlsl\"", options), ElementsAre());
    EXPECT_THAT(Compile("#include \"link.hlsl\"", options), ElementsAre());
}

TEST_F(IncludeOfAFile, MayBeAnywhereInThePackageThatTheShaderIsPartOf)
{
    folder.Write("repository/Common/a.hlsl", "#define VALUE 1\n");
    folder.Write("secret.hlsl", "#define VALUE 1\n");
    const std::string file = "repository/Shaders/Glow/t.shader";
    const auto compile = [&](const std::string& include)
    {
        return Compile("#include \"" + include + "\"", {}, file);
    };
    EXPECT_THAT(compile("../../Common/a.hlsl").at(0), HasSubstr("is outside the folders"));
    folder.Write("repository/package.json", "{\"name\": \"my-page\"}"); // npm's
    EXPECT_THAT(compile("../../Common/a.hlsl").at(0), HasSubstr("is outside the folders"));
    folder.Write("repository/package.json", "{\"name\": \"com.me.effects\"}");
    EXPECT_THAT(compile("../../Common/a.hlsl"), ElementsAre());
    EXPECT_THAT(compile("../../../secret.hlsl").at(0), HasSubstr("is outside the folders"));
}

TEST_F(IncludeOfAFile, StaysThereWhereverTheProgramWasStarted)
{
    folder.Write("secret.hlsl", "#define VALUE 1\n");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    const std::vector<std::string> up = Compile("#include \"../../../secret.hlsl\"");
    const std::vector<std::string> below = Compile("#include \"secret.hlsl\"");
    std::filesystem::current_path(before);
    ASSERT_EQ(up.size(), 1u);
    EXPECT_THAT(up[0], HasSubstr("outside the folders"));
    ASSERT_EQ(below.size(), 1u);
    EXPECT_THAT(below[0], HasSubstr("there is no file \"secret.hlsl\""));
}

TEST_F(IncludeOfAFile, TakesASlashInFrontForTheFolderOfTheProject)
{
    folder.Write("project/Inc/a.hlsl", "#include \"/Inc/b.hlsl\"\n");
    folder.Write("project/Inc/b.hlsl", "#define VALUE 1\n");
    EXPECT_THAT(Compile("#include \"/Inc/a.hlsl\""), ElementsAre());
    EXPECT_THAT(Compile("#include \"/Inc/c.hlsl\"").at(0), HasSubstr("is an absolute path"));
    // Outside of a Unity project it is the folder that is given.
    ShaderCompilerOptions options;
    options.projectRoot = Path("root");
    folder.Write("root/Inc/d.hlsl", "#define VALUE 1\n");
    EXPECT_THAT(Compile("#include \"/Inc/d.hlsl\"", options), ElementsAre());
}

TEST_F(IncludeOfAFile, GoesRoundInACircleNoLongerThanItMust)
{
    folder.Write("project/Assets/Shaders/a.hlsl", "#include \"b.hlsl\"\n#include \"b.hlsl\"\n");
    folder.Write("project/Assets/Shaders/b.hlsl", "\n#include \"a.hlsl\"\n");
    const std::vector<std::string> messages = Compile("#define VALUE 1\n#include \"a.hlsl\"");
    const std::string a = Path("project/Assets/Shaders/a.hlsl");
    const std::string b = Path("project/Assets/Shaders/b.hlsl");
    EXPECT_THAT(messages,
                ElementsAre(Mentions("circle", a + " -> " + b + " -> " + a, "'#pragma once'")));
    folder.Write("project/Assets/Shaders/a.hlsl",
                 "#ifndef A\n#define A\n#include \"b.hlsl\"\n#define VALUE 1\n#endif\n");
    EXPECT_THAT(Compile("#include \"a.hlsl\""), ElementsAre());
    folder.Write("project/Assets/Shaders/a.hlsl",
                 "\xEF\xBB\xBF#  pragma  once\n#include \"b.hlsl\"\n#define VALUE 1\n");
    EXPECT_THAT(Compile("#include \"a.hlsl\"\n#include \"a.hlsl\""), ElementsAre());
}

TEST_F(IncludeOfAFile, MayBeNestedDeeplyButNotWithoutEnd)
{
    for (int i = 0; i < 70; ++i)
    {
        folder.Write("project/Assets/Shaders/" + std::to_string(i) + ".hlsl",
                     "#include \"" + std::to_string(i + 1) + ".hlsl\"\n");
    }
    folder.Write("project/Assets/Shaders/70.hlsl", "#define VALUE 1\n");
    EXPECT_THAT(Compile("#include \"20.hlsl\""), ElementsAre());
    EXPECT_THAT(Compile("#define VALUE 1\n#include \"0.hlsl\"").at(0),
                HasSubstr("more than 64 files"));
}

} // namespace
} // namespace limn
