#include "ShaderTestSupport.h"

#include <limn/shaderlab/MissingIncludeError.h>
#include <limn/shaderlab/UnsupportedProgramError.h>

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

struct PassCounts
{
    Count tried;
    int refused = 0;        ///< with a reason
    int missingInclude = 0; ///< of a file that is not in the collection
};

void CompilePasses(ShaderCompiler& compiler, const ShaderLabDocument& document, PassCounts& passes)
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
            try
            {
                const PassProgram program = compiler.ReadPragmas(*pass.program);
                compiler.Compile(program, SelectVariant(program, initial));
                ++passes.tried.good;
                ++passes.tried.all;
            }
            catch (const UnsupportedProgramError&)
            {
                ++passes.refused;
            }
            catch (const MissingIncludeError&)
            {
                ++passes.missingInclude;
            }
            catch (const AssetError& error)
            {
                ++passes.tried.all;
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
        PassCounts passes;
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
        std::cout << "corpus: " << files << " files parse, " << passes.tried << " passes compile, "
                  << passes.refused << " refused, " << passes.missingInclude
                  << " with a missing include\n";
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
