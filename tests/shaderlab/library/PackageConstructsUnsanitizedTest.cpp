#include "Paths.h"
#include "ShaderTestSupport.h"
#include "SpirvTestSupport.h"

#include <gmock/gmock.h>
#include <limn/shaderlab/ShaderLabParser.h>

namespace limn::test
{

// Packages put in front of the built-in library, written with what Unity's own are written with:
// textures by their precision, functions for half and for float out of one macro, a file for each
// platform, overloads of vectors and integers, parameters that are textures.
TEST(ShaderLibraryPackages, MayBeOnesThatAreWrittenAsUnitysAre)
{
    const std::filesystem::path folder = SourcePath("tests/shaderlab/packages");
    const ShaderLabDocument document = LoadShaderLab(folder / "AllOfIt.shader");
    for (const bool halfIs16Bit : {false, true})
    {
        ShaderCompilerOptions options;
        options.halfIs16Bit = halfIs16Bit;
        options.packages["com.unity.render-pipelines.core"] = folder / "core";
        options.packages["com.unity.render-pipelines.universal"] = folder / "universal";
        ShaderCompiler compiler(options);
        const auto pass = compiler.Compile(*document.subShaders.front().passes.front().program);
        EXPECT_EQ(ValidationMessages(pass->vertexSpirv), "");
        EXPECT_EQ(ValidationMessages(pass->fragmentSpirv), "");
        EXPECT_EQ(Messages(pass->diagnostics), std::vector<std::string>{});
    }
}

// What the fork declares and limn feeds is limn's: its buffers, and the elements of each draw.
TEST(ShaderLibraryPackages, MayBeForksThatComeWithoutTheCorePackage)
{
    const std::filesystem::path folder = SourcePath("tests/shaderlab/packages");
    const ShaderLabDocument document = LoadShaderLab(folder / "Fork.shader");
    ShaderCompilerOptions options;
    options.packages["com.unity.render-pipelines.universal"] = folder / "fork";
    ShaderCompiler compiler(options);
    const auto pass = compiler.Compile(*document.subShaders.front().passes.front().program);
    EXPECT_EQ(ValidationMessages(pass->vertexSpirv), "");
    EXPECT_EQ(ValidationMessages(pass->fragmentSpirv), "");
    std::vector<std::string> buffers;
    for (const UniformBuffer& buffer : pass->layout.buffers)
    {
        buffers.push_back(buffer.name);
    }
    EXPECT_THAT(buffers, testing::UnorderedElementsAre("limn_PerCamera", "limn_PerFrameLighting"));
    EXPECT_THAT(pass->layout.storageBuffers,
                testing::Contains(testing::Field(&StorageBufferBinding::name, "limn_PerDraw")));
}

} // namespace limn::test
