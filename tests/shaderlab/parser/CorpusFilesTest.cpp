#include "parser/CorpusFiles.h"
#include "ShaderTestSupport.h"

#include <limn/shaderlab/PrintShaderLab.h>

#include <algorithm>

namespace limn
{

namespace test
{

void PrintTo(const CorpusFile& file, std::ostream* stream)
{
    *stream << file.name;
}

} // namespace test

namespace
{

using test::CorpusFile;

std::string Joined(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines)
    {
        text += line + "\n";
    }
    return text;
}

/// The diagnostics one a line, as the corpus has them: the names listed in "(known: …)" are left
/// out, so that a new command does not change every file.
std::string Listed(const std::vector<Diagnostic>& diagnostics)
{
    constexpr std::string_view known = "(known: ";
    std::vector<std::string> lines = test::Messages(diagnostics);
    for (std::string& line : lines)
    {
        const std::size_t names = line.find(known);
        const std::size_t end = line.rfind(')');
        if (names != std::string::npos && end != std::string::npos)
        {
            line.replace(names + known.size(), end - names - known.size(), "...");
        }
    }
    return Joined(lines);
}

/// A small ShaderLab file that shows one rule, with hand-written text of what it means.
class ShaderLabCorpus : public testing::TestWithParam<CorpusFile>
{
protected:
    ShaderLabParseResult Parse() const
    {
        return ParseShaderLab(GetParam().text, GetParam().name + ".shader");
    }
};

TEST_P(ShaderLabCorpus, HasTheExpectedDiagnostics)
{
    EXPECT_EQ(Joined(GetParam().diagnostics), Listed(Parse().diagnostics));
}

TEST_P(ShaderLabCorpus, HasTheExpectedDocument)
{
    if (GetParam().document)
    {
        EXPECT_EQ(*GetParam().document, PrintShaderLab(Parse().document));
    }
}

TEST_P(ShaderLabCorpus, IsTheSameAfterPrinting)
{
    const ShaderLabParseResult first = Parse();
    if (first.hasErrors())
    {
        return; // what was read of a broken file need not be a whole shader
    }
    const std::string text = PrintShaderLab(first.document);
    const ShaderLabParseResult second = ParseShaderLab(text, "printed.shader");
    EXPECT_FALSE(second.hasErrors()) << Listed(second.diagnostics) << text;
    EXPECT_TRUE(SameContent(first.document, second.document)) << text;
    EXPECT_EQ(text, PrintShaderLab(second.document));
}

std::string TestName(const testing::TestParamInfo<CorpusFile>& info)
{
    std::string name = info.param.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '/' || c == '.'; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Files, ShaderLabCorpus, testing::ValuesIn(test::CorpusFiles()), TestName);

TEST(ShaderLabCorpusFolder, HoldsAtLeast120FilesThatSayWhatIsExpected)
{
    EXPECT_GE(test::CorpusFiles().size(), 120u) << test::CorpusFolder();
    for (const CorpusFile& file : test::CorpusFiles())
    {
        EXPECT_TRUE(file.document || file.hasErrors()) << file.name;
    }
}

TEST(ShaderLabCorpusFolder, HoldsNoExpectationWithoutItsFile)
{
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::CorpusFolder()))
    {
        const bool isExpectation = entry.path().stem().extension() == ".expected" ||
                                   entry.path().extension() == ".diagnostics";
        if (entry.is_regular_file() && isExpectation)
        {
            const std::filesystem::path stem = entry.path().parent_path() / entry.path().stem();
            const std::string shader =
                stem.extension() == ".expected"
                    ? std::filesystem::path(stem).replace_extension().string()
                    : stem.string();
            EXPECT_TRUE(std::filesystem::exists(shader + ".shader")) << entry.path();
        }
    }
}

} // namespace
} // namespace limn
