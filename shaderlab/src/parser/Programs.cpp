#include "parser/Parser.h"

#include "keywords/PragmaScanner.h"
#include "tokens/Lines.h"
#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

namespace
{

/// Returns the language of the block that `word` opens.
ProgramLanguage LanguageOf(std::string_view word)
{
    return word.starts_with("CG")     ? ProgramLanguage::Cg
           : word.starts_with("HLSL") ? ProgramLanguage::Hlsl
                                      : ProgramLanguage::Glsl;
}

std::string_view EndWordOf(ProgramLanguage language)
{
    static constexpr std::string_view k_Words[] = {"ENDHLSL", "ENDCG", "ENDGLSL"};
    return k_Words[static_cast<std::size_t>(language)];
}

bool EndsInComment(std::string_view text)
{
    const std::size_t last = text.rfind("/*");
    if (last == text.npos || text.find("*/", last + 2) != text.npos)
    {
        return false; // as nearly always
    }
    HlslLines lines(text, 1);
    std::string line;
    int number = 0;
    while (lines.Next(line, number))
    {
    }
    return lines.endsInComment();
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
               subject + ": " + std::string(block.endWord) + " closes this block; write " +
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
    if (EndsInComment(chunk.text))
    {
        Report(Severity::Warning, location,
               subject + ": a comment in it is not closed; write */ before " +
                   std::string(endWord));
    }
    Advance();
    return chunk;
}

/// An include block is for the programs behind it, and for those before it in its Pass, SubShader
/// or Shader.
void Parser::ParseIncludeBlock()
{
    const ProgramLanguage language = LanguageOf(m_Word);
    auto chunk = ReadChunk(EndWordOf(language));
    if (!chunk || !Count())
    {
        return;
    }
    const auto include = [&](ShaderLabPass& pass)
    {
        if (pass.program && pass.program->language == language && Count() &&
            CountRepeated(chunk->text.size()))
        {
            pass.program->chunks.insert(pass.program->chunks.end() - 1, *chunk);
        }
    };
    if (m_Pass != nullptr)
    {
        include(*m_Pass);
    }
    else if (m_SubShader != nullptr)
    {
        std::ranges::for_each(m_SubShader->passes, include);
    }
    else
    {
        for (ShaderLabSubShader& subShader : m_Result.document.subShaders)
        {
            std::ranges::for_each(subShader.passes, include);
        }
    }
    m_Includes[static_cast<std::size_t>(language)].push_back(std::move(*chunk));
}

/// Reads the pragmas of all programs, which have all of their include blocks only at the file's
/// end.
void Parser::ReadPragmas()
{
    for (ShaderLabSubShader& subShader : m_Result.document.subShaders)
    {
        for (ShaderLabPass& pass : subShader.passes)
        {
            if (pass.program)
            {
                ScanPragmas(*pass.program);
            }
        }
    }
}

/// Returns the program that starts here, behind all include blocks of its language that the file
/// has so far. ReadPragmas completes it.
std::optional<PassProgram> Parser::ReadProgram()
{
    PassProgram program;
    program.location = m_Command;
    program.language = LanguageOf(m_Word);
    auto chunk = ReadChunk(EndWordOf(program.language));
    const std::vector<SourceChunk>& includes =
        m_Includes[static_cast<std::size_t>(program.language)];
    if (!chunk || !CountRepeated(SizeOf(includes)) || !Count(includes.size()))
    {
        return std::nullopt;
    }
    program.file = m_Result.document.file;
    program.chunks = includes;
    program.chunks.push_back(std::move(*chunk));
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
