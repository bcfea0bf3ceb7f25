#include "Mentions.h"

#include <gmock/gmock.h>
#include <limn/shaderlab/ShaderLabParser.h>

namespace limn::test
{

TEST(ShaderLabError, LimitsHowManyPropertiesAFileDeclares)
{
    constexpr std::size_t k_Most = std::size_t{1} << 20;
    const std::string head = "Shader \"T\" { Properties {\n";
    const std::string tail = "} SubShader { Pass { } } }";
    std::string properties;
    for (std::size_t i = 0; i <= k_Most; ++i)
    {
        properties += "_P" + std::to_string(i) + "(\"\",Int)=0\n";
    }
    const ShaderLabParseResult result = ParseShaderLab(head + properties + tail, "t.shader");
    ASSERT_TRUE(result.hasErrors());
    EXPECT_THAT(ToString(result.diagnostics.back()), Mentions("file", "declares more", "1048576"));
    EXPECT_EQ(result.document.properties.size(), k_Most);
}

} // namespace limn::test
