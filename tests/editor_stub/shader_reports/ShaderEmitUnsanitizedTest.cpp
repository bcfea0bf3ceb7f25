#include "Mentions.h"
#include "Paths.h"
#include "commands/CommandRun.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <map>
#include <regex>

namespace limn::test
{

namespace
{

/// A shader that comes with limn, and the name its emitted files begin with.
struct Sample
{
    const char* file;
    const char* stem;
};

constexpr Sample k_Samples[] = {
    {"core/shaders/HalfLambert.shader", "Limn_Half_Lambert.0"},
    {"core/shaders/CoreBlit.shader", "Hidden_Universal_CoreBlit.0"},
    {"features/screen_space_outline/ScreenSpaceOutline.shader", "Hidden_ScreenSpaceOutline.1"}};

class ShaderEmit : public testing::Test
{
protected:
    /// The files of one language, in the order they were written.
    std::vector<std::string> Emit(const Sample& sample, const std::string& language)
    {
        const CommandRun run = RunCommand({"shader", test::SourcePath(sample.file), "--emit",
                                           language, "-o", (folder / language).string()});
        EXPECT_EQ(0, run.exitCode) << run.err;
        std::vector<std::string> files;
        std::istringstream lines(run.out);
        for (std::string line; std::getline(lines, line);)
        {
            files.push_back(line);
        }
        return files;
    }

    /// Runs a tool that judges each emitted file by itself.
    void ExpectAccepted(const std::string& language, const std::string& tool)
    {
        for (const Sample& sample : k_Samples)
        {
            const std::vector<std::string> files = Emit(sample, language);
            EXPECT_FALSE(files.empty());
            for (const std::string& file : files)
            {
                const bool isVertex = file.find(".vert.") != std::string::npos;
                const std::string command = tool + (language == "spirv" ? "" : " -S ") +
                                            (language == "spirv" ? ""
                                             : isVertex          ? "vert"
                                                                 : "frag") +
                                            " '" + file + "' >'" + file + ".log'";
                EXPECT_EQ(0, std::system(command.c_str())) << command << "\n"
                                                           << ReadText(file + ".log");
            }
        }
    }

    TemporaryFolder folder;
};

/// The text with the numbers of SPIRV-Cross's temporaries counted from 1: they follow from whatever
/// else stands in the shader library.
std::string Renumbered(const std::string& text)
{
    static const std::regex temporary("\\b_[0-9]+\\b");
    std::map<std::string, std::string> names;
    std::string result;
    auto end = text.cbegin();
    for (std::sregex_iterator match(text.begin(), text.end(), temporary), none; match != none;
         ++match)
    {
        const auto [entry, isNew] = names.try_emplace(match->str());
        if (isNew)
        {
            entry->second = "_" + std::to_string(names.size());
        }
        result.append(end, (*match)[0].first).append(entry->second);
        end = (*match)[0].second;
    }
    return result.append(end, text.cend());
}

/// Compares with a text of tests/editor_stub/data/emitted; LIMN_UPDATE_GOLDEN=1 writes it instead.
void ExpectGolden(const std::string& text, const std::string& name)
{
    const std::string path = test::SourcePath("tests/editor_stub/data/emitted/" + name);
    if (std::getenv("LIMN_UPDATE_GOLDEN") != nullptr)
    {
        std::ofstream(path) << text;
        return;
    }
    EXPECT_EQ(ReadText(path), text) << name;
}

} // namespace

TEST_F(ShaderEmit, GivesSpirvThatIsValid)
{
    ExpectAccepted("spirv", "spirv-val --target-env vulkan1.1");
}

TEST_F(ShaderEmit, GivesGlslThatGlslangCompiles)
{
    ExpectAccepted("glsl", "glslangValidator -V --target-env vulkan1.1 -o /dev/null");
}

TEST_F(ShaderEmit, GivesGlslEsThatGlslangCompiles)
{
    ExpectAccepted("glsles", "glslangValidator");
}

TEST_F(ShaderEmit, GivesHlslThatGlslangCompiles)
{
    ExpectAccepted("hlsl", "glslangValidator -D -V -e main -o /dev/null");
}

TEST_F(ShaderEmit, OfAGeometryFunctionIsRefusedWhereTheLanguageHasNone)
{
    const std::string shader =
        folder.Write("a.shader", R"(Shader "Grow" { SubShader { Pass { HLSLPROGRAM
        #pragma vertex vert
        #pragma geometry geom
        #pragma fragment frag
        struct v2f { float4 pos : SV_POSITION; };
        v2f vert(float4 p : POSITION) { v2f o; o.pos = p; return o; }
        [maxvertexcount(1)]
        void geom(triangle v2f v[3], inout PointStream<v2f> s) { s.Append(v[0]); }
        float4 frag() : SV_Target { return 1; }
        ENDHLSL } } })");
    const Sample sample = {"core/shaders/CoreBlit.shader", ""};
    for (const auto& [language, reason] :
         {std::pair("msl", "Metal has no geometry functions"),
          std::pair("hlsl", "SPIRV-Cross writes no geometry functions in HLSL")})
    {
        const std::string out = (folder / language).string();
        const CommandRun run = RunCommand(
            {"shader", shader, test::SourcePath(sample.file), "--emit", language, "-o", out});
        EXPECT_EQ(1, run.exitCode);
        EXPECT_THAT(run.err, Mentions("a.shader:1:29:", language, reason));
        // The other file is written all the same, this one in no part.
        EXPECT_TRUE(std::filesystem::exists(out + "/Hidden_Universal_CoreBlit.0.vert." + language));
        EXPECT_FALSE(std::filesystem::exists(out + "/Grow.0.vert." + language));
    }
    const CommandRun es =
        RunCommand({"shader", shader, "--emit", "glsles", "-o", (folder / "es").string()});
    EXPECT_EQ(0, es.exitCode) << es.err;
    EXPECT_EQ(ReadText((folder / "es" / "Grow.0.geom.glsles").string()).find("#version 320 es"),
              0U);
}

TEST_F(ShaderEmit, GivesTheMslAndTheGlslEsThatWereLookedAt)
{
    for (const Sample& sample : k_Samples)
    {
        for (const std::string language : {"msl", "glsles"})
        {
            Emit(sample, language);
            for (const char* stage : {"vert", "frag"})
            {
                const std::string name = std::string(sample.stem) + "." + stage + "." + language;
                ExpectGolden(Renumbered(ReadText((folder / language / name).string())), name);
            }
        }
    }
}

} // namespace limn::test
