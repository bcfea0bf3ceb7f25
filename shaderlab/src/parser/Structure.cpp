#include "parser/Parser.h"

#include <algorithm>

namespace limn
{

namespace
{

constexpr int k_MaxCategoryDepth = 32;
constexpr std::size_t k_ItemsOfAPass = 16;

std::size_t SizeOf(const ShaderTags& tags)
{
    std::size_t size = 0;
    for (const ShaderTag& tag : tags.items)
    {
        size += tag.key.size() + tag.value.size();
    }
    return size;
}

std::size_t SizeOf(const std::vector<LegacyCommand>& commands)
{
    std::size_t size = 0;
    for (const LegacyCommand& command : commands)
    {
        size += command.text.size();
    }
    return size;
}

} // namespace

/// Include blocks may stand before the shader: they are for the whole file.
void Parser::ParseIncludesBeforeShader()
{
    const auto isNext = [&](const Command& command)
    {
        return command.parse == &Parser::ParseIncludeBlock && isWord(command.name);
    };
    const CommandTable& table = ShaderCommands();
    for (auto command = std::find_if(table.begin(), table.end(), isNext);
         command != table.end() && !m_IsStopped;
         command = std::find_if(table.begin(), table.end(), isNext))
    {
        ParseCommand(*command);
    }
}

void Parser::ParseFile()
{
    ParseIncludesBeforeShader();
    if (!isWord("Shader"))
    {
        Error("file: it must start with Shader \"name\", not with " + Found());
        return;
    }
    m_Result.document.location = Advance().location;
    m_Result.document.name = ParseString("Shader").value_or("");
    ParseBlock("Shader", ShaderCommands());
    if (m_Token.kind != TokenKind::End)
    {
        Error("file: " + Found() + " behind the closing '}' of the shader; remove it");
    }
}

void Parser::ParseCategory()
{
    if (m_CategoryDepth == k_MaxCategoryDepth)
    {
        Report(Severity::Error, m_Command,
               "Category: they are nested more than " + std::to_string(k_MaxCategoryDepth) +
                   " deep; remove some of the braces");
        SkipTokenOrBraces();
        return;
    }
    ++m_CategoryDepth;
    const Scope outer = m_Scope;
    ParseBlock("Category", CategoryCommands());
    m_Scope = outer;
    --m_CategoryDepth;
}

void Parser::ParseSubShader()
{
    ShaderLabSubShader subShader;
    subShader.location = m_Command;
    Scope outer = m_Scope;
    m_SubShader = &subShader;
    ParseBlock("SubShader", SubShaderCommands());
    m_SubShader = nullptr;
    subShader.tags = std::move(m_Scope.tags);
    subShader.lod = m_Scope.lod;
    m_Scope = std::move(outer);
    if (Count(k_ItemsOfAPass + subShader.tags.items.size()) &&
        CountRepeated(SizeOf(subShader.tags)))
    {
        m_Result.document.subShaders.push_back(std::move(subShader));
    }
}

void Parser::ParsePass()
{
    ShaderLabPass pass;
    pass.location = m_Command;
    Scope outer = m_Scope;
    m_Scope.tags = {};
    m_Pass = &pass;
    ParseBlock("Pass", PassCommands());
    m_Pass = nullptr;
    pass.state = std::move(m_Scope.state);
    pass.tags = std::move(m_Scope.tags);
    pass.legacyCommands = std::move(m_Scope.legacyCommands);
    m_Scope = std::move(outer);
    const std::string* const lightMode = pass.tags.Find("LightMode");
    if (pass.program && lightMode)
    {
        pass.program->lightMode = *lightMode;
    }
    AddPass(std::move(pass));
}

/// Passes go through here whatever their kind.
void Parser::AddPass(ShaderLabPass pass)
{
    const auto& targets = pass.state.targets;
    pass.state.separateBlend = std::ranges::any_of(targets, [&](const PassBlendState& target)
                                                   { return target != targets[0]; });
    if (Count(k_ItemsOfAPass + pass.legacyCommands.size()) &&
        CountRepeated(SizeOf(pass.legacyCommands)))
    {
        NoteLegacyCommands(pass);
        m_SubShader->passes.push_back(std::move(pass));
    }
}

void Parser::ParseUsePass()
{
    ShaderLabPass pass;
    pass.location = m_Command;
    pass.kind = ShaderLabPassKind::UsePass;
    const SourceLocation location = m_Token.location;
    const auto name = ParseString("UsePass");
    if (!name)
    {
        return;
    }
    if (name->find('/') == std::string::npos)
    {
        Report(Severity::Error, location,
               "UsePass: the name of a pass is missing; write \"shader name/PASS NAME\"");
        return;
    }
    pass.usePass = *name;
    AddPass(std::move(pass));
}

void Parser::ParseGrabPass()
{
    ShaderLabPass pass;
    pass.location = m_Command;
    pass.kind = ShaderLabPassKind::GrabPass;
    if (!Expect("GrabPass", '{'))
    {
        return;
    }
    Scope outer = m_Scope;
    m_Scope.tags = {};
    ParseGrabPassBody(pass);
    pass.tags = std::move(m_Scope.tags);
    m_Scope = std::move(outer);
    AddPass(std::move(pass));
}

void Parser::ParseGrabPassBody(ShaderLabPass& pass)
{
    const SourceLocation opening = m_Command;
    while (!Accept('}'))
    {
        if (m_Token.kind == TokenKind::String)
        {
            pass.grabTexture = std::string(Advance().text);
        }
        else if (isWord("Name"))
        {
            Advance();
            pass.name = ParseString("Name").value_or("");
        }
        else if (isWord("Tags"))
        {
            m_Command = Advance().location;
            ParseTags();
        }
        else if (m_Token.kind == TokenKind::End)
        {
            ReportNotClosed("GrabPass", opening);
            return;
        }
        else
        {
            const bool isOuter = isAnyCommand();
            Error("GrabPass: unexpected " + Found() +
                  "; it holds the name of a texture, Name and Tags");
            if (isOuter)
            {
                return;
            }
            Advance();
        }
    }
}

void Parser::ParseName()
{
    if (auto name = ParseString("Name"))
    {
        m_Pass->name = std::move(*name);
    }
}

void Parser::ParseIgnoredName()
{
    ParseString("Name");
}

void Parser::ParseFallback()
{
    const bool isSecond = !m_Result.document.fallback.empty();
    const SourceLocation location = m_Command;
    std::string name;
    if (isWord("Off") || isWord("False"))
    {
        Advance();
    }
    else if (m_Token.kind == TokenKind::String)
    {
        name = std::string(Advance().text);
        if (Accept(','))
        {
            ParseNumber("Fallback");
        }
    }
    else
    {
        Error("Fallback: \"shader name\" or Off is missing before " + Found());
        return;
    }
    if (isSecond && name != m_Result.document.fallback)
    {
        Report(Severity::Note, location,
               "Fallback: it replaces \"" + m_Result.document.fallback.substr(0, 80) +
                   "\" given before");
    }
    m_Result.document.fallback = std::move(name);
    m_Result.document.fallbackLocation = location;
}

void Parser::ParseCustomEditor()
{
    m_Result.document.customEditor =
        ParseString("CustomEditor").value_or(m_Result.document.customEditor);
}

void Parser::ParsePipelineEditor()
{
    const SourceLocation location = m_Command;
    const auto editor = ParseString("CustomEditorForRenderPipeline");
    const auto asset = editor ? ParseString("CustomEditorForRenderPipeline") : std::nullopt;
    if (asset && Count())
    {
        m_Result.document.pipelineEditors.push_back({location, *editor, *asset});
    }
}

void Parser::ParseDependency()
{
    const SourceLocation location = m_Command;
    const auto name = ParseString("Dependency");
    if (!name || !Expect("Dependency", '='))
    {
        return;
    }
    const auto shader = ParseString("Dependency");
    if (shader && Count())
    {
        m_Result.document.dependencies.push_back({location, *name, *shader});
    }
}

} // namespace limn
