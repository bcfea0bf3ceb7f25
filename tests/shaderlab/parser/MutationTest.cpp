#include "ShaderTestSupport.h"
#include "parser/CorpusFiles.h"

#include <limn/shaderlab/PrintShaderLab.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <random>

namespace limn
{
namespace
{

constexpr int k_Mutations = 1000;
constexpr unsigned k_Seed = 20240229;

/// The seed of this run: LIMN_MUTATION_SEED where it is set.
unsigned Seed()
{
    const char* variable = std::getenv("LIMN_MUTATION_SEED");
    return variable ? static_cast<unsigned>(std::strtoul(variable, nullptr, 10)) : k_Seed;
}

bool isWordCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '#' || c == '.';
}

/// Where the piece of text that starts at `begin` ends: a text in quotes, a word, blanks or a mark.
std::size_t EndOfPiece(const std::string& text, std::size_t begin)
{
    const auto end = [&](const auto& belongs)
    {
        return static_cast<std::size_t>(
            std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(),
                             belongs) -
            text.begin());
    };
    const auto isBlank = [](char c)
    {
        return std::isspace(static_cast<unsigned char>(c)) != 0;
    };
    if (text[begin] == '"')
    {
        const std::size_t quote = text.find('"', begin + 1);
        return quote == std::string::npos ? text.size() : quote + 1;
    }
    if (isWordCharacter(text[begin]))
    {
        return end(isWordCharacter);
    }
    return isBlank(text[begin]) ? end(isBlank) : begin + 1;
}

/// A file cut into its tokens and the blanks between them.
class Pieces
{
public:
    explicit Pieces(const std::string& text)
    {
        for (std::size_t begin = 0; begin < text.size();)
        {
            const std::size_t end = EndOfPiece(text, begin);
            if (std::isspace(static_cast<unsigned char>(text[begin])) == 0)
            {
                m_Tokens.push_back(m_Pieces.size());
            }
            m_Pieces.push_back(text.substr(begin, end - begin));
            begin = end;
        }
    }

    /// The text with one token deleted, doubled, swapped with another or replaced by another.
    std::string Mutate(std::mt19937& random) const
    {
        std::vector<std::string> pieces = m_Pieces;
        std::string& token = pieces[AnyToken(random)];
        std::string& other = pieces[AnyToken(random)];
        switch (random() % 4)
        {
        case 0:
            token.clear();
            break;
        case 1:
            token += " " + std::string(token);
            break;
        case 2:
            std::swap(token, other);
            break;
        default:
            token = other;
        }
        std::string text;
        for (const std::string& piece : pieces)
        {
            text += piece;
        }
        return text;
    }

    bool isEmpty() const { return m_Tokens.empty(); }

private:
    std::size_t AnyToken(std::mt19937& random) const
    {
        return m_Tokens[random() % m_Tokens.size()];
    }

    std::vector<std::string> m_Pieces;
    std::vector<std::size_t> m_Tokens; ///< indices of the pieces that are no blanks
};

/// Whether a place is in the text, the place behind its last byte included.
bool Contains(const std::string& text, SourceLocation location)
{
    std::size_t begin = 0;
    for (int line = 1; line < location.line; ++line)
    {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string::npos)
        {
            return false;
        }
        begin = end + 1;
    }
    const std::size_t length = std::min(text.find('\n', begin), text.size()) - begin;
    return location.line >= 1 && location.column >= 1 &&
           static_cast<std::size_t>(location.column) <= length + 1;
}

void ExpectADocumentOrALocatedError(const std::string& text)
{
    ShaderLabParseResult result;
    ASSERT_NO_THROW(result = ParseShaderLab(text, "mutated.shader"));
    for (const Diagnostic& diagnostic : result.diagnostics)
    {
        EXPECT_TRUE(Contains(text, diagnostic.location)) << ToString(diagnostic);
    }
    if (!result.hasErrors())
    {
        const ShaderLabParseResult again =
            ParseShaderLab(PrintShaderLab(result.document), "printed.shader");
        EXPECT_FALSE(again.hasErrors());
        EXPECT_TRUE(SameContent(result.document, again.document));
    }
}

TEST(ShaderLabMutation, GivesADocumentOrALocatedErrorForEachMutationOfGoodFiles)
{
    std::vector<Pieces> files;
    for (const test::CorpusFile& file : test::CorpusFiles())
    {
        if (!file.hasErrors())
        {
            files.emplace_back(file.text);
        }
    }
    ASSERT_GE(files.size(), 100u);
    ASSERT_TRUE(
        std::none_of(files.begin(), files.end(), [](const Pieces& p) { return p.isEmpty(); }));
    const unsigned seed = Seed();
    RecordProperty("seed", std::to_string(seed));
    std::mt19937 random(seed);
    for (int i = 0; i < k_Mutations && !HasFailure(); ++i)
    {
        const std::string text = files[random() % files.size()].Mutate(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", mutation " + std::to_string(i) + ":\n" +
                     text);
        ExpectADocumentOrALocatedError(text);
    }
}

} // namespace
} // namespace limn
