#include "ShaderTestSupport.h"

#include <limn/shaderlab/InitialKeywords.h>

#include <cstdlib>
#include <iostream>

namespace limn
{
namespace
{

std::string CorpusFolder()
{
    const char* variable = std::getenv("LIMN_CORPUS_DIR");
    return variable ? variable : "";
}

struct Count
{
    int good = 0;
    int all = 0;
};

std::ostream& operator<<(std::ostream& stream, const Count& count)
{
    return stream << count.good << " of " << count.all;
}

void CompilePasses(ShaderCompiler& compiler, const ShaderLabDocument& document, Count& passes)
{
    const std::vector<std::string> initial = InitialKeywords(document);
    for (const ShaderLabSubShader& subShader : document.subShaders)
    {
        for (const ShaderLabPass& pass : subShader.passes)
        {
            if (!pass.program)
            {
                continue;
            }
            ++passes.all;
            try
            {
                compiler.Compile(*pass.program, SelectVariant(*pass.program, initial));
                ++passes.good;
            }
            catch (const AssetError& error)
            {
                std::cout << error.what() << "\n";
            }
        }
    }
}

/// Parses and compiles every shader of a folder. A file may fail, but only with diagnostics.
class Corpus : public testing::Test
{
public:
    void TestBody() override
    {
        ShaderCompiler compiler;
        Count files;
        Count passes;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(CorpusFolder()))
        {
            if (entry.path().extension() != ".shader")
            {
                continue;
            }
            ++files.all;
            try
            {
                const ShaderLabDocument document = LoadShaderLab(entry.path());
                ++files.good;
                CompilePasses(compiler, document, passes);
            }
            catch (const AssetError& error)
            {
                std::cout << error.what() << "\n";
            }
        }
        std::cout << "corpus: " << files << " files parse, " << passes << " passes compile\n";
        EXPECT_GT(files.all, 0) << "no .shader file below " << CorpusFolder();
    }
};

// The test exists only where a corpus is named, so that a run without one claims nothing.
const bool k_Registered = []
{
    if (!CorpusFolder().empty())
    {
        testing::RegisterTest("Corpus", "ParsesAndCompilesWithoutCrashing", nullptr, nullptr,
                              __FILE__, __LINE__, [] { return new Corpus; });
    }
    return true;
}();

} // namespace
} // namespace limn
