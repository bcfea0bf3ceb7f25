#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limn/core/BuiltinShaders.h>
#include <limn/core/CoreUtils.h>
#include <limn/core/Debug.h>
#include <limn/core/ShaderSource.h>
#include <limn/core/UniversalRenderer.h>

#include "Mentions.h"

namespace limn
{
namespace
{

using testing::HasSubstr;

const std::shared_ptr<ShaderCompiler>& SourceCompiler()
{
    static const auto compiler = std::make_shared<ShaderCompiler>();
    return compiler;
}

/// What is logged while it lives.
class Warnings
{
public:
    Warnings()
    {
        s_Text.clear();
        SetLogSink([](const LogMessage& message) { s_Text += message.text; });
    }
    ~Warnings() { SetLogSink(nullptr); }
    Warnings(const Warnings&) = delete;
    Warnings& operator=(const Warnings&) = delete;
    static const std::string& text() { return s_Text; }

private:
    static inline std::string s_Text;
};

/// Finds its shader in Create, as most features do.
class FindingFeature final : public ScriptableRendererFeature
{
public:
    explicit FindingFeature(std::string_view shader) : m_Name(shader) {}
    void Create() override { found = Shader::Find(m_Name); }
    void AddRenderPasses(ScriptableRenderer&, RenderingData&) override {}

    std::shared_ptr<const Shader> found;

private:
    std::string m_Name;
};

} // namespace

TEST(ShaderSource, MakesEachShaderOnce)
{
    ShaderSource source(&BuiltinShaders, SourceCompiler());
    const auto unlit = source.Find("Universal Render Pipeline/Unlit");
    ASSERT_NE(unlit, nullptr);
    EXPECT_EQ(source.Find("Universal Render Pipeline/Unlit"), unlit);
    EXPECT_EQ(source.Find("No/Such"), nullptr);
    source.Clear();
    EXPECT_NE(source.Find("Universal Render Pipeline/Unlit"), unlit);
}

TEST(ShaderSource, KnowsWhatIsAdded)
{
    ShaderSource source(&BuiltinShaders, SourceCompiler());
    const auto own = Shader::FromText(
        "Shader \"Hidden/Own\" { SubShader { Pass { HLSLPROGRAM\n#pragma vertex v\n#pragma "
        "fragment f\nfloat4 v() : SV_Position { return 0; }\nfloat4 f() : SV_Target { return 0; "
        "}\nENDHLSL } } }",
        "Own.shader", SourceCompiler());
    EXPECT_EQ(source.Find("Hidden/Own"), nullptr);
    source.Add(own);
    EXPECT_EQ(source.Find("Hidden/Own"), own);
}

TEST(ShaderSource, IsWhatFindAsksInItsScope)
{
    const Warnings warnings;
    EXPECT_EQ(Shader::Find("Universal Render Pipeline/Unlit"), nullptr);
    EXPECT_THAT(Warnings::text(), HasSubstr("no shaders are known here"));
    const ShaderSourceScope scope(
        std::make_shared<ShaderSource>(&BuiltinShaders, SourceCompiler()));
    EXPECT_NE(Shader::Find("Universal Render Pipeline/Unlit"), nullptr);
    EXPECT_EQ(Shader::Find("Universal Render Pipeline/Unlot"), nullptr);
    EXPECT_EQ(CoreUtils::CreateEngineMaterial("Universal Render Pipeline/Unlit")->shader(),
              Shader::Find("Universal Render Pipeline/Unlit"));
    EXPECT_THROW(CoreUtils::CreateEngineMaterial("Universal Render Pipeline/Unlot"), ContractError);
    EXPECT_THAT(Warnings::text(), test::Mentions("'Universal Render Pipeline/Unlot'",
                                                 "'Universal Render Pipeline/Unlit'"));
}

TEST(ShaderSource, IsLimnsOwnInAFeaturesCreate)
{
    UniversalRenderer renderer(SourceCompiler());
    auto feature = std::make_unique<FindingFeature>("Hidden/Universal/CoreBlit");
    const FindingFeature& seen = *feature;
    renderer.AddFeature(std::move(feature));
    EXPECT_NE(seen.found, nullptr);
    const Warnings warnings;
    EXPECT_EQ(Shader::Find("Hidden/Universal/CoreBlit"), nullptr) << "behind it";
}

} // namespace limn
