#include "CorpusSupport.h"

namespace limn::test
{
namespace
{

std::string CorpusFolder()
{
    return FolderOf("LIMN_CORPUS_DIR");
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
} // namespace limn::test
