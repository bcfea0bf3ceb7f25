#include <limn/shaderlab/PrintShaderLab.h>
#include <limn/shaderlab/ShaderLabParser.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace
{

void Require(bool holds, const char* what)
{
    if (!holds)
    {
        std::fprintf(stderr, "ParserFuzzer: %s\n", what);
        std::abort();
    }
}

/// A program that ends in a comment, or holds a word that opens another, ends elsewhere once other
/// text stands before or behind it; so does a comment that a block leaves open.
bool isAmbiguous(const limn::ShaderLabParseResult& result)
{
    for (const limn::Diagnostic& diagnostic : result.diagnostics)
    {
        if (diagnostic.message.find("stands in a comment") != std::string::npos ||
            diagnostic.message.find("stands inside it") != std::string::npos ||
            diagnostic.message.find("is not closed") != std::string::npos)
        {
            return true;
        }
    }
    return false;
}

/// Canonical text has one block where the file had an include block and a program. Nonsense in
/// them, such as halves of comments, may then mean something else.
bool hasJoinedBlocks(const limn::ShaderLabDocument& document)
{
    for (const limn::ShaderLabSubShader& subShader : document.subShaders)
    {
        for (const limn::ShaderLabPass& pass : subShader.passes)
        {
            if (pass.program && pass.program->chunks.size() > 1)
            {
                return true;
            }
        }
    }
    return false;
}

} // namespace

/// Any bytes give a document or diagnostics, never an exception; what is read without an error can
/// be printed and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const limn::ShaderLabParseResult result = limn::ParseShaderLab(text, "fuzz.shader");
    Require(result.diagnostics.size() <= 303, "more diagnostics than are promised");
    for (const limn::Diagnostic& diagnostic : result.diagnostics)
    {
        Require(!limn::ToStringWithSource(diagnostic, text).empty(), "an empty diagnostic");
    }
    if (result.hasErrors() || isAmbiguous(result) || hasJoinedBlocks(result.document))
    {
        return 0;
    }
    const std::string printed = limn::PrintShaderLab(result.document);
    const limn::ShaderLabParseResult again = limn::ParseShaderLab(printed, "printed.shader");
    Require(!again.hasErrors(), "the canonical text has errors");
    Require(limn::SameContent(result.document, again.document), "the canonical text says less");
    Require(limn::PrintShaderLab(again.document) == printed, "the canonical text is not stable");
    return 0;
}
