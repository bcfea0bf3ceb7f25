#include "Parser.h"

#include "PragmaScanner.h"
#include "Text.h"

namespace limn
{

namespace
{

/// The word that closes the block that `word` opens.
std::string_view EndWordOf(std::string_view word)
{
    if (word.substr(0, 2) == "CG")
    {
        return "ENDCG";
    }
    return word.substr(0, 4) == "HLSL" ? "ENDHLSL" : "ENDGLSL";
}

std::size_t SizeOf(const std::vector<SourceChunk>& chunks)
{
    std::size_t size = 0;
    for (const SourceChunk& chunk : chunks)
    {
        size += chunk.text.size();
    }
    return size;
}

} // namespace

std::optional<SourceChunk> Parser::ReadChunk(std::string_view endWord)
{
    const SourceLocation location = m_Command;
    SourceChunk chunk;
    chunk.firstLine = m_Lexer.line();
    const RawBlock block = m_Lexer.ReadBlock(endWord);
    const std::string subject(m_Word);
    if (block.endWord.empty())
    {
        Report(Severity::Error, location,
               subject + ": no " + std::string(endWord) + " closes this block");
        Stop();
        return std::nullopt;
    }
    if (!EqualsIgnoringCase(block.endWord, endWord))
    {
        Report(Severity::Error, location,
               subject + ": " + std::string(block.endWord) + " stands at its end; write " +
                   std::string(endWord));
    }
    else if (block.inComment)
    {
        Report(Severity::Warning, location,
               subject + ": the " + std::string(endWord) +
                   " that closes it stands in a comment; put it on a line of its own");
    }
    else if (!block.opener.empty())
    {
        Report(Severity::Warning, location,
               subject + ": '" + std::string(block.opener) + "' stands inside it; is an " +
                   std::string(endWord) + " missing before that?");
    }
    chunk.text = std::string(block.text);
    Advance();
    return chunk;
}

void Parser::ParseIncludeBlock()
{
    const std::string_view endWord = EndWordOf(m_Word);
    if (auto chunk = ReadChunk(endWord); chunk && Count())
    {
        (endWord == "ENDCG" ? m_CgIncludes : m_HlslIncludes).push_back(std::move(*chunk));
    }
}

void Parser::ParseGlslInclude()
{
    Report(Severity::Warning, m_Command, "GLSLINCLUDE: ignored; limn compiles HLSL only");
    ReadChunk("ENDGLSL");
}

/// The program that starts here with the include blocks in scope; none where it is no HLSL.
std::optional<PassProgram> Parser::ReadProgram()
{
    const std::string_view endWord = EndWordOf(m_Word);
    if (endWord == "ENDGLSL")
    {
        Report(Severity::Error, m_Command, "GLSLPROGRAM: not supported; write the pass in HLSL");
        ReadChunk(endWord);
        return std::nullopt;
    }
    const bool isCg = endWord == "ENDCG";
    PassProgram program;
    program.location = m_Command;
    auto chunk = ReadChunk(endWord);
    const std::vector<SourceChunk>& includes = isCg ? m_CgIncludes : m_HlslIncludes;
    if (!chunk || !CountRepeated(SizeOf(includes)) || !Count(includes.size()))
    {
        return std::nullopt;
    }
    program.file = m_Result.document.file;
    program.language = isCg ? ProgramLanguage::Cg : ProgramLanguage::Hlsl;
    program.chunks = includes;
    program.chunks.push_back(std::move(*chunk));
    ScanPragmas(program);
    return program;
}

void Parser::ParseProgram()
{
    const SourceLocation location = m_Command;
    auto program = ReadProgram();
    if (program && m_Pass->program)
    {
        Report(Severity::Error, location, "Pass: it has a program already; start another Pass");
    }
    else if (program)
    {
        m_Pass->program = std::move(program);
    }
}

void Parser::ParseSurface()
{
    ShaderLabPass pass;
    pass.location = m_Command;
    pass.isSurface = true;
    const std::string subject(m_Word);
    pass.program = ReadProgram();
    if (!pass.program)
    {
        return;
    }
    Report(Severity::Warning, pass.location,
           subject + ": a program outside a Pass is a surface shader, which limn does not compile; "
                     "write a Pass with a vertex and a fragment function");
    pass.state = m_Scope.state;
    pass.legacyCommands = m_Scope.legacyCommands;
    AddPass(std::move(pass));
}

} // namespace limn
