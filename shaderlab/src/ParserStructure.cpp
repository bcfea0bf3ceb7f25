#include "Parser.h"

#include "PragmaScanner.h"
#include "Text.h"

#include <algorithm>

namespace limn
{

const Parser::CommandTable& Parser::ShaderCommands()
{
    static const CommandTable table = {
        {"Properties", &Parser::ParseProperties},
        {"SubShader", &Parser::ParseSubShader},
        {"Category", &Parser::ParseCategory},
        {"Fallback", &Parser::ParseFallback},
        {"CustomEditor", &Parser::ParseCustomEditor},
        {"CustomEditorForRenderPipeline", &Parser::ParsePipelineEditor},
        {"Dependency", &Parser::ParseDependency},
        {"HLSLINCLUDE", &Parser::ParseIncludeBlock},
        {"CGINCLUDE", &Parser::ParseIncludeBlock},
    };
    return table;
}

const Parser::CommandTable& Parser::CategoryCommands()
{
    static const CommandTable table = []
    {
        CommandTable commands = {
            {"SubShader", &Parser::ParseSubShader},
            {"Category", &Parser::ParseCategory},
            {"Tags", &Parser::ParseTags},
            {"LOD", &Parser::ParseLod},
            {"Fallback", &Parser::ParseFallback},
            {"CustomEditor", &Parser::ParseCustomEditor},
            {"Dependency", &Parser::ParseDependency},
            {"HLSLINCLUDE", &Parser::ParseIncludeBlock},
            {"CGINCLUDE", &Parser::ParseIncludeBlock},
        };
        AppendStateCommands(commands);
        AppendLegacyCommands(commands);
        return commands;
    }();
    return table;
}

const Parser::CommandTable& Parser::SubShaderCommands()
{
    static const CommandTable table = []
    {
        CommandTable commands = {
            {"Pass", &Parser::ParsePass},
            {"Tags", &Parser::ParseTags},
            {"LOD", &Parser::ParseLod},
            {"Name", &Parser::ParseIgnoredName},
            {"UsePass", &Parser::ParseUsePass},
            {"GrabPass", &Parser::ParseUnsupportedBlock},
            {"PackageRequirements", &Parser::ParseUnsupportedBlock},
            {"HLSLINCLUDE", &Parser::ParseIncludeBlock},
            {"CGINCLUDE", &Parser::ParseIncludeBlock},
            {"HLSLPROGRAM", &Parser::ParseStrayProgram},
            {"CGPROGRAM", &Parser::ParseStrayProgram},
        };
        AppendStateCommands(commands);
        AppendLegacyCommands(commands);
        return commands;
    }();
    return table;
}

const Parser::CommandTable& Parser::PassCommands()
{
    static const CommandTable table = []
    {
        CommandTable commands = {
            {"Name", &Parser::ParseName},
            {"Tags", &Parser::ParseTags},
            {"LOD", &Parser::ParseLod},
            {"PackageRequirements", &Parser::ParseUnsupportedBlock},
            {"HLSLINCLUDE", &Parser::ParseIncludeBlock},
            {"CGINCLUDE", &Parser::ParseIncludeBlock},
            {"HLSLPROGRAM", &Parser::ParseProgram},
            {"CGPROGRAM", &Parser::ParseProgram},
            {"GLSLPROGRAM", &Parser::ParseProgram},
        };
        AppendStateCommands(commands);
        AppendLegacyCommands(commands);
        return commands;
    }();
    return table;
}

void Parser::ParseFile()
{
    if (!isWord("Shader"))
    {
        Error("file: it must start with Shader \"name\", not with " + Found());
        return;
    }
    m_Result.document.location = Advance().location;
    const auto name = ParseString("Shader");
    m_Result.document.name = name.value_or("");
    ParseBlock("Shader", ShaderCommands());
    if (m_Token.kind != TokenKind::End)
    {
        Error("file: " + Found() + " behind the closing '}' of the shader; remove it");
    }
}

void Parser::ParseCategory()
{
    const RenderState outerState = *m_State;
    const ShaderTags outerTags = m_CategoryTags;
    ShaderTags* const tags = m_Tags;
    m_Tags = &m_CategoryTags;
    ParseBlock("Category", CategoryCommands());
    m_Tags = tags;
    m_CategoryTags = outerTags;
    *m_State = outerState;
}

void Parser::ParseSubShader()
{
    ShaderLabSubShader subShader;
    subShader.location = m_Command;
    subShader.tags = m_CategoryTags;
    RenderState state = *m_State;
    RenderState* const outerState = m_State;
    ShaderTags* const outerTags = m_Tags;
    const std::size_t hlslIncludes = m_HlslIncludes.size();
    const std::size_t cgIncludes = m_CgIncludes.size();
    m_State = &state;
    m_Tags = &subShader.tags;
    m_SubShader = &subShader;
    ParseBlock("SubShader", SubShaderCommands());
    m_SubShader = nullptr;
    m_Tags = outerTags;
    m_State = outerState;
    m_HlslIncludes.resize(hlslIncludes);
    m_CgIncludes.resize(cgIncludes);
    m_Result.document.subShaders.push_back(std::move(subShader));
}

void Parser::ParsePass()
{
    ShaderLabPass pass;
    pass.location = m_Command;
    pass.state = *m_State; // what the SubShader has set up to here
    RenderState* const outerState = m_State;
    ShaderTags* const outerTags = m_Tags;
    m_State = &pass.state;
    m_Tags = &pass.tags;
    m_Pass = &pass;
    ParseBlock("Pass", PassCommands());
    m_Pass = nullptr;
    m_Tags = outerTags;
    m_State = outerState;
    m_SubShader->passes.push_back(std::move(pass));
}

void Parser::ParseName()
{
    if (const auto name = ParseString("Name"))
    {
        m_Pass->name = *name;
    }
}

void Parser::ParseIgnoredName()
{
    ParseString("Name");
}

void Parser::ParseTags()
{
    const SourceLocation opening = m_Token.location;
    if (!Expect("Tags", "{"))
    {
        return;
    }
    while (!Accept("}"))
    {
        if (m_Token.kind == TokenKind::End ||
            (m_Token.kind == TokenKind::Identifier && isAnyCommand()))
        {
            Error("Tags: '}' is missing before " + Found() + "; the '{' of line " +
                  std::to_string(opening.line) + " is still open");
            return;
        }
        if (m_Token.kind != TokenKind::String && m_Token.kind != TokenKind::Identifier)
        {
            Error("Tags: unexpected " + Found() + "; a tag is \"key\" = \"value\"");
            Advance();
            continue;
        }
        ParseTagsInto(*m_Tags);
    }
}

void Parser::ParseTagsInto(ShaderTags& tags)
{
    const Token key = Advance();
    if (!Expect("Tags", "="))
    {
        return;
    }
    if (m_Token.kind != TokenKind::String && m_Token.kind != TokenKind::Identifier)
    {
        Error("Tags: the value of \"" + std::string(key.text) + "\" is missing before " + Found());
        return;
    }
    const Token value = Advance();
    tags.Set({key.location, std::string(key.text), std::string(value.text)});
}

void Parser::ParseLod()
{
    const auto number = ParseNumber("LOD");
    if (number && m_SubShader && !m_Pass)
    {
        m_SubShader->lod = static_cast<int>(std::clamp(*number, 0.0, 1e6));
    }
}

void Parser::ParseFallback()
{
    if (isWord("Off") || isWord("False"))
    {
        Advance();
        m_Result.document.fallback.clear();
        return;
    }
    if (m_Token.kind != TokenKind::String)
    {
        Error("Fallback: \"shader name\" or Off is missing before " + Found());
        return;
    }
    m_Result.document.fallback = std::string(Advance().text);
    if (Accept(","))
    {
        ParseNumber("Fallback");
    }
}

void Parser::ParseCustomEditor()
{
    m_Result.document.customEditor = ParseString("CustomEditor").value_or("");
}

void Parser::ParsePipelineEditor()
{
    const SourceLocation location = m_Command;
    const auto editor = ParseString("CustomEditorForRenderPipeline");
    const auto asset = editor ? ParseString("CustomEditorForRenderPipeline") : std::nullopt;
    if (asset)
    {
        m_Result.document.pipelineEditors.push_back({location, *editor, *asset});
    }
}

void Parser::ParseDependency()
{
    const SourceLocation location = m_Command;
    const auto name = ParseString("Dependency");
    if (!name || !Expect("Dependency", "="))
    {
        return;
    }
    if (const auto shader = ParseString("Dependency"))
    {
        m_Result.document.dependencies.push_back({location, *name, *shader});
    }
}

void Parser::ParseUnsupportedBlock()
{
    Report(Severity::Error, m_Command,
           std::string(m_Word) + ": not supported yet; remove the block");
    if (isPunctuation("{"))
    {
        SkipBraces();
    }
}

void Parser::ParseUsePass()
{
    Report(Severity::Error, m_Command,
           "UsePass: not supported yet; copy the pass into this shader");
    ParseString("UsePass");
}

std::optional<SourceChunk> Parser::ReadChunk(std::string_view endWord)
{
    SourceChunk chunk;
    // The token behind the opening word was read ahead; the raw text starts before it.
    bool found = false;
    m_Lexer.Rewind(m_WordEnd);
    chunk.firstLine = m_WordEnd.location.line;
    chunk.text = std::string(m_Lexer.ReadBlock(endWord, found));
    Advance();
    if (!found)
    {
        Report(Severity::Error, m_Command,
               std::string(m_Word) + ": no " + std::string(endWord) + " closes this block");
        m_ReportedEnd = true;
        return std::nullopt;
    }
    return chunk;
}

void Parser::ParseIncludeBlock()
{
    const bool isCg = EqualsIgnoringCase(m_Word, "CGINCLUDE");
    if (auto chunk = ReadChunk(isCg ? "ENDCG" : "ENDHLSL"))
    {
        (isCg ? m_CgIncludes : m_HlslIncludes).push_back(std::move(*chunk));
    }
}

void Parser::ParseProgram()
{
    if (EqualsIgnoringCase(m_Word, "GLSLPROGRAM"))
    {
        Report(Severity::Error, m_Command, "GLSLPROGRAM: not supported; write the pass in HLSL");
        ReadChunk("ENDGLSL");
        return;
    }
    const bool isCg = EqualsIgnoringCase(m_Word, "CGPROGRAM");
    const SourceLocation location = m_Command;
    auto chunk = ReadChunk(isCg ? "ENDCG" : "ENDHLSL");
    if (!chunk)
    {
        return;
    }
    if (m_Pass->program)
    {
        Report(Severity::Error, location, "Pass: it has a program already; start another Pass");
        return;
    }
    PassProgram program;
    program.file = m_Result.document.file;
    program.location = location;
    program.language = isCg ? ProgramLanguage::Cg : ProgramLanguage::Hlsl;
    program.chunks = isCg ? m_CgIncludes : m_HlslIncludes;
    program.chunks.push_back(std::move(*chunk));
    ScanPragmas(program);
    m_Pass->program = std::move(program);
}

void Parser::ParseStrayProgram()
{
    Report(Severity::Error, m_Command,
           std::string(m_Word) +
               ": a program outside a Pass is a surface shader, which is not supported yet; put it "
               "into a Pass");
    ReadChunk(EqualsIgnoringCase(m_Word, "CGPROGRAM") ? "ENDCG" : "ENDHLSL");
}

} // namespace limn
