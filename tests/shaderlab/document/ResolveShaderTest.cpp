#include "Mentions.h"

#include <limn/shaderlab/ResolveShader.h>
#include <limn/shaderlab/ShaderLabParser.h>

#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>

namespace limn
{

namespace
{

std::shared_ptr<const ShaderLabDocument> Parse(const char* text, const char* file = "u.shader")
{
    return std::make_shared<const ShaderLabDocument>(ParseShaderLab(text, file).document);
}

ShaderDatabase BaseDatabase()
{
    ShaderDatabase database;
    database.Add(Parse("Shader \"Lib/Base\" { SubShader { Pass { Name \"One\" Cull Off } "
                       "Pass { Name \"one\" Cull Front } UsePass \"Loop/A/BACK\" } }"));
    database.Add(Parse("Shader \"Loop/A\" { SubShader { Pass { Name \"P\" } "
                       "UsePass \"Lib/Base/BACK\" } }"));
    return database;
}

std::string ChosenPass(const std::string& subShaders)
{
    const auto document = Parse(("Shader \"U\" { " + subShaders + " }").c_str());
    return ResolveShader(*document, nullptr).subShader.passes.at(0).name;
}

} // namespace

TEST(ResolveShader, UsePassTakesTheLastOfEqualNamesInItsPlace)
{
    const ShaderDatabase database = BaseDatabase();
    const auto user = Parse("Shader \"U\" { SubShader { UsePass \"Lib/Base/ONE\" GrabPass { } "
                            "Pass { Name \"Own\" } } }");
    const ResolvedShader resolved = ResolveShader(*user, &database);
    ASSERT_EQ(resolved.subShader.passes.size(), 3U);
    EXPECT_EQ(resolved.subShader.passes[0].name, "one");
    EXPECT_EQ(resolved.subShader.passes[1].kind, ShaderLabPassKind::GrabPass);
    EXPECT_EQ(resolved.subShader.passes[2].name, "Own");
    EXPECT_TRUE(resolved.errors.empty());
}

TEST(ResolveShader, UsePassOfAnUnknownShaderOrACycleIsAnError)
{
    const ShaderDatabase database = BaseDatabase();
    using Parts = std::vector<std::string>;
    for (const auto& [use, parts] :
         {std::pair("Lib/Bas/ONE", Parts{"UsePass", "unknown shader 'Lib/Bas'", "'Lib/Base'"}),
          std::pair("Lib/Base/BACK", Parts{"back to itself", "with a program"})})
    {
        const auto user =
            Parse(("Shader \"U\" { SubShader { UsePass \"" + std::string(use) + "\" Pass { } } }")
                      .c_str());
        const ResolvedShader resolved = ResolveShader(*user, &database);
        ASSERT_EQ(resolved.errors.size(), 1U) << use;
        EXPECT_THAT(resolved.errors[0].message, test::MentionsInOrder(parts));
    }
}

TEST(ResolveShader, TakesTheFirstSubShaderOfAPipelineThatSuits)
{
    const std::string foreign =
        "SubShader { Tags { \"RenderPipeline\" = \"HDRenderPipeline\" } Pass { Name \"H\" } } ";
    EXPECT_EQ(ChosenPass(foreign + "SubShader { Tags { \"RenderPipeline\" = "
                                   "\"UniversalPipeline\" } Pass { Name \"A\" } }"),
              "A");
    EXPECT_EQ(ChosenPass(foreign + "SubShader { Tags { \"RenderPipeline\" = "
                                   "\"UniversalRenderPipeline\" } Pass { Name \"B\" } }"),
              "B");
    EXPECT_EQ(ChosenPass(foreign + "SubShader { Pass { Name \"C\" } }"), "C");
}

TEST(ResolveShader, PassesOverATagThatIsOnlyLikeThePipelines)
{
    for (const auto& [tag, isNear] :
         {std::pair("UniversalPipelin", true), std::pair("universalpipeline", true),
          std::pair("UniversalPipeline2", true), std::pair("HDRenderPipeline", false)})
    {
        const auto user = Parse(("Shader \"U\" { SubShader { Tags { \"RenderPipeline\" = \"" +
                                 std::string(tag) + "\" } Pass { } } SubShader { Pass { } } }")
                                    .c_str());
        const ResolvedShader resolved = ResolveShader(*user, nullptr);
        EXPECT_EQ(resolved.subShaderIndex, 1) << tag;
        ASSERT_EQ(resolved.notes.size(), 1U) << tag;
        EXPECT_THAT(resolved.notes[0].message,
                    test::Mentions("SubShader 0", "RenderPipeline", "'" + std::string(tag) + "'"));
        EXPECT_EQ(resolved.notes[0].message.find("'UniversalPipeline'") != std::string::npos,
                  isNear);
    }
}

TEST(ResolveShader, FollowsTheFallbackAndNamesIt)
{
    const ShaderDatabase database = BaseDatabase();
    const auto user = Parse("Shader \"U\" { SubShader { Tags { \"RenderPipeline\" = "
                            "\"HDRenderPipeline\" } Pass { } } Fallback \"Lib/Base\" }");
    EXPECT_EQ(ResolveShader(*user, &database).fallback, "Lib/Base");
    EXPECT_THROW(ResolveShader(*user, nullptr), AssetError);
}

TEST(ResolveShader, ShadowCasterAndMetaComeFromTheFallbackWhereTheyAreMissing)
{
    ShaderDatabase database;
    database.Add(Parse("Shader \"Near\" { SubShader { "
                       "Pass { Name \"depth\" Tags { \"LightMode\" = \"DepthOnly\" } } "
                       "Pass { Name \"near\" Tags { \"LightMode\" = \"ShadowCaster\" } } "
                       "Pass { Name \"second\" Tags { \"LightMode\" = \"ShadowCaster\" } } } "
                       "Fallback \"Far\" }"));
    database.Add(Parse("Shader \"Far\" { SubShader { "
                       "Pass { Name \"far\" Tags { \"LightMode\" = \"ShadowCaster\" } } "
                       "Pass { Name \"meta\" Tags { \"LightMode\" = \"Meta\" } } } "
                       "Fallback \"Near\" }"));
    const auto names = [&](const std::string& passes)
    {
        const auto user =
            Parse(("Shader \"U\" { SubShader { " + passes + " } Fallback \"Near\" }").c_str());
        std::vector<std::string> result;
        for (const ShaderLabPass& pass : ResolveShader(*user, &database).subShader.passes)
        {
            result.push_back(pass.name);
        }
        return result;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names("Pass { Name \"own\" }"), (Names{"own", "near", "meta"}));
    EXPECT_EQ(names("Pass { Name \"own\" Tags { \"LightMode\" = \"ShadowCaster\" } }"),
              (Names{"own", "meta"}));
    EXPECT_EQ(names("Pass { Name \"own\" Tags { \"LightMode\" = \"Meta\" } }"),
              (Names{"own", "near"}));
}

/// Opaque and cutout shaders of Unity's built-in pipeline cast shadows; transparent ones, sprites
/// and Unlit do not (2022.3). URP draws nothing else of them.
TEST(ResolveShader, TakesShadowsOfUnitysBuiltInShaders)
{
    ShaderDatabase database;
    database.Add(
        Parse("Shader \"Hidden/Limn/VertexLit\" { SubShader { "
              "Pass { Name \"ShadowCaster\" Tags { \"LightMode\" = \"ShadowCaster\" } } } }"));
    database.Add(Parse("Shader \"Hidden/Limn/CutoutVertexLit\" { SubShader { "
                       "Pass { Name \"Caster\" Tags { \"LightMode\" = \"ShadowCaster\" } } } }"));
    const auto shadowOf = [&](const std::string& fallback)
    {
        const auto user = Parse(
            ("Shader \"U\" { SubShader { Pass { } } Fallback \"" + fallback + "\" }").c_str());
        const std::vector<ShaderLabPass> passes = ResolveShader(*user, &database).subShader.passes;
        return passes.size() > 1 ? passes[1].name : "";
    };
    for (const char* opaque : {"Diffuse", "VertexLit", "Legacy Shaders/VertexLit", "Standard",
                               "Legacy Shaders/Self-Illumin/Diffuse", "Mobile/Diffuse"})
    {
        EXPECT_EQ(shadowOf(opaque), "ShadowCaster") << opaque;
    }
    for (const char* cutout :
         {"Transparent/Cutout/Diffuse", "Legacy Shaders/Transparent/Cutout/VertexLit"})
    {
        EXPECT_EQ(shadowOf(cutout), "Caster") << cutout;
    }
    for (const char* none : {"Transparent/Diffuse", "Sprites/Default", "Unlit/Texture"})
    {
        EXPECT_EQ(shadowOf(none), "") << none;
    }
    const auto user = Parse("Shader \"U\" { SubShader { Pass { } "
                            "UsePass \"Legacy Shaders/VertexLit/SHADOWCASTER\" } }");
    const ResolvedShader resolved = ResolveShader(*user, &database);
    EXPECT_TRUE(resolved.errors.empty());
    EXPECT_EQ(resolved.subShader.passes.at(1).lightMode(), "ShadowCaster");
}

TEST(ResolveShader, AFallbackInACircleThatLacksAPassIsNoError)
{
    ShaderDatabase database;
    database.Add(Parse("Shader \"A\" { SubShader { Pass { } } Fallback \"B\" }"));
    database.Add(Parse("Shader \"B\" { SubShader { Pass { } } Fallback \"A\" }"));
    const ResolvedShader resolved = ResolveShader(*database.Find("A"), &database);
    EXPECT_EQ(resolved.subShader.passes.size(), 1U);
    EXPECT_TRUE(resolved.errors.empty());
}

TEST(ResolveShader, AnUnknownFallbackIsNotedAtItsPlace)
{
    const ShaderDatabase database = BaseDatabase();
    const auto user = Parse("Shader \"U\" {\nFallback \"Lib/Nothing\"\n  Fallback \"Lib/Bas\" }");
    try
    {
        ResolveShader(*user, &database);
        ADD_FAILURE() << "there is nothing to draw with";
    }
    catch (const AssetError& error)
    {
        ASSERT_EQ(error.diagnostics().size(), 2U);
        EXPECT_THAT(
            ToString(error.diagnostics()[1]),
            test::Mentions("u.shader:3:3: note: Fallback", "unknown", "'Lib/Bas'", "'Lib/Base'"));
    }
}

TEST(ResolveShader, PassesOverASubShaderThatRequiresWhatTheDeviceLacks)
{
    const auto user = Parse("Shader \"U\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex v\n"
                            "#pragma fragment f\n#pragma require cubearray\nENDHLSL\n } } "
                            "SubShader { Pass { } } }");
    ShaderCriteria criteria;
    EXPECT_EQ(ResolveShader(*user, nullptr, criteria).subShaderIndex, 0);
    criteria.missingFeatures = {"cubearray"};
    EXPECT_EQ(ResolveShader(*user, nullptr, criteria).subShaderIndex, 1);
}

TEST(ResolveShader, PassesOverASubShaderAboveTheMaximumLod)
{
    ShaderCriteria criteria;
    criteria.maximumLod = 200;
    const auto user = Parse("Shader \"U\" { SubShader { LOD 300 Pass { } } "
                            "SubShader { LOD 200 Pass { } } }");
    const ResolvedShader resolved = ResolveShader(*user, nullptr, criteria);
    EXPECT_EQ(resolved.subShaderIndex, 1);
    ASSERT_EQ(resolved.notes.size(), 1U);
    EXPECT_THAT(resolved.notes[0].message,
                test::Mentions("SubShader 0", "LOD 300", "maximum", "200"));
}

TEST(ResolveShader, PassesOverASubShaderWhosePackageRequirementsDoNotHold)
{
    const std::string universal = "\"com.unity.render-pipelines.universal\" : ";
    EXPECT_EQ(ChosenPass("SubShader { PackageRequirements { " + universal +
                         "\"15.0\" } Pass { Name \"later\" } } "
                         "SubShader { PackageRequirements { \"com.foo\" } Pass { Name \"foo\" } } "
                         "SubShader { PackageRequirements { " +
                         universal + "\"[12,15)\" } Pass { Name \"holds\" } }"),
              "holds");
}

TEST(ResolveShader, PassesOverASubShaderWithAProgramThatCannotRun)
{
    EXPECT_EQ(ChosenPass("SubShader { Pass { Name \"g\" HLSLPROGRAM\n#pragma vertex v\n"
                         "#pragma fragment f\n#pragma hull h\nENDHLSL\n } } "
                         "SubShader { Pass { Name \"plain\" } }"),
              "plain");
}

TEST(ResolveShader, UsePassOfAMissingPassIsAnErrorThatNamesTheNearest)
{
    const ShaderDatabase database = BaseDatabase();
    const auto user = Parse("Shader \"U\" { SubShader { UsePass \"Lib/Base/ONEE\" Pass { } } }");
    const ResolvedShader resolved = ResolveShader(*user, &database);
    ASSERT_EQ(resolved.errors.size(), 1U);
    EXPECT_THAT(resolved.errors[0].message,
                test::Mentions("UsePass", "'Lib/Base'", "no pass", "'ONEE'", "did you mean"));
}

TEST(ResolveShader, ThrowsWhereFallbacksRunInACircleOrAreOff)
{
    const std::string foreign =
        "SubShader { Tags { \"RenderPipeline\" = \"HDRenderPipeline\" } Pass { } } ";
    ShaderDatabase database;
    database.Add(Parse(("Shader \"F/A\" { " + foreign + "Fallback \"F/B\" }").c_str()));
    database.Add(Parse("Shader \"F/B\" { Fallback \"F/A\" }"));
    database.Add(Parse(("Shader \"Off\" { " + foreign + "Fallback Off }").c_str()));
    EXPECT_THROW(ResolveShader(*database.Find("F/A"), &database), AssetError);
    EXPECT_THROW(ResolveShader(*database.Find("Off"), &database), AssetError);
}

} // namespace limn
