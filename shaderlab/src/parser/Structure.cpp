#include "parser/Parser.h"

#include "keywords/PragmaScanner.h"
#include "tokens/Lines.h"
#include <limn/base/Text.h>
#include <limn/base/WordList.h>

#include <algorithm>

namespace limn
{

namespace
{

constexpr int k_MaxCategoryDepth = 32;
constexpr std::size_t k_ItemsOfAPass = 16;

/// Returns the bytes of one text of each of the items.
template <typename Item>
std::size_t SizeOf(const std::vector<Item>& items, std::string Item::*text)
{
    std::size_t size = 0;
    for (const Item& item : items)
    {
        size += (item.*text).size();
    }
    return size;
}

constexpr std::size_t k_MaxTags = 256; ///< of a scope: each new one is compared with the others
constexpr std::size_t k_MaxTypos = 2;

// Any key and any value is legal; these are only what a typo is measured against.
const auto k_TagKeys =
    SplitWords("Queue RenderType RenderPipeline LightMode DisableBatching ForceNoShadowCasting "
               "IgnoreProjector CanUseSpriteAtlas PreviewType PassFlags UniversalMaterialType "
               "TerrainCompatible");
const auto k_Pipelines =
    SplitWords("UniversalPipeline HDRenderPipeline UniversalRenderPipeline LightweightPipeline");
const auto k_LightModes = SplitWords(
    "UniversalForward UniversalForwardOnly UniversalGBuffer Universal2D NormalsRendering "
    "SRPDefaultUnlit ShadowCaster DepthOnly DepthNormals DepthNormalsOnly MotionVectors "
    "SceneSelectionPass LightweightForward ForwardBase ForwardAdd Deferred PrepassBase "
    "PrepassFinal Always Meta Picking Vertex");

/// The name that was probably meant; "" for one that is known, or that is near none. Names that
/// differ by their last letters only ("Outline2") are meant as they are.
std::string_view Meant(std::string_view name, const std::vector<std::string_view>& known)
{
    const bool isKnown = std::ranges::any_of(known, [&](std::string_view candidate)
                                             { return EqualsIgnoringCase(name, candidate); });
    const std::string_view nearest = isKnown ? "" : NearestName(name, known);
    const bool isMeant = !nearest.empty() &&
                         EditDistance(name, nearest) <= std::min(k_MaxTypos, nearest.size() / 4) &&
                         !EqualsIgnoringCase(name.substr(0, nearest.size()), nearest);
    return isMeant ? nearest : "";
}

bool isTagWord(const Token& token)
{
    return token.kind == TokenKind::String || token.kind == TokenKind::Identifier;
}

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

} // namespace

void Parser::ParseFile()
{
    // Include blocks may stand before the shader: they are for the whole file.
    const Command* command = FindCommand(ShaderCommands());
    while (command && command->parse == &Parser::ParseIncludeBlock && !m_IsStopped)
    {
        ParseCommand(*command);
        command = FindCommand(ShaderCommands());
    }
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
        CountRepeated(SizeOf(subShader.tags.items, &ShaderTag::key) +
                      SizeOf(subShader.tags.items, &ShaderTag::value)))
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
        CountRepeated(SizeOf(pass.legacyCommands, &LegacyCommand::text)))
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
    // A SubShader may have one too, without effect.
    auto name = ParseString("Name");
    if (name && m_Pass)
    {
        m_Pass->name = std::move(*name);
    }
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

void Parser::ParseTags()
{
    const SourceLocation opening = m_Token.location;
    if (!Expect("Tags", '{'))
    {
        return;
    }
    while (!Accept('}'))
    {
        if (m_Token.kind == TokenKind::End ||
            (m_Token.kind == TokenKind::Identifier && isAnyCommand() && !m_Lexer.isNext('=')))
        {
            ReportStillOpen("Tags", opening);
            return;
        }
        if (!isTagWord(m_Token))
        {
            Error("Tags: unexpected " + Found() + "; a tag is \"key\" = \"value\"");
            Advance();
            continue;
        }
        ParseTag(m_Scope.tags);
    }
}

void Parser::ParseTag(ShaderTags& tags)
{
    const Token key = Advance();
    if (!Expect("Tags", '='))
    {
        if (m_Token.kind == TokenKind::String)
        {
            Advance(); // the value, most likely
        }
        return;
    }
    if (!isTagWord(m_Token))
    {
        Error("Tags: the value of \"" + std::string(key.text.substr(0, 80)) +
              "\" is missing before " + Found());
        return;
    }
    const Token value = Advance();
    if (key.kind != value.kind)
    {
        Report(Severity::Error, key.location,
               "Tags: only one of key and value is in quotes; put both in quotes");
    }
    CheckTag(key, value);
    if (tags.items.size() == k_MaxTags)
    {
        Report(Severity::Error, key.location,
               "Tags: there are more than " + std::to_string(k_MaxTags) +
                   "; the tags after these are not kept");
    }
    else if (Count())
    {
        tags.Set({key.location, std::string(key.text), std::string(value.text)});
    }
}

/// Warns of names that are nearly, but not quite, ones that Unity or URP asks for.
void Parser::CheckTag(const Token& key, const Token& value)
{
    const auto warn = [this](const Token& token, std::string_view meant)
    {
        if (!meant.empty())
        {
            Report(Severity::Warning, token.location,
                   "Tags: \"" + std::string(token.text) + "\" is no name that Unity knows; did " +
                       "you mean \"" + std::string(meant) + "\"?");
        }
    };
    warn(key, Meant(key.text, k_TagKeys));
    if (EqualsIgnoringCase(key.text, "RenderPipeline"))
    {
        warn(value, Meant(value.text, k_Pipelines));
    }
    else if (EqualsIgnoringCase(key.text, "LightMode"))
    {
        warn(value, Meant(value.text, k_LightModes));
    }
}

void Parser::ParseLod()
{
    const auto number = ParseNumber("LOD");
    // A Pass may name one too, without effect.
    if (number && !m_Pass)
    {
        m_Scope.lod = static_cast<int>(std::clamp(*number, 0.0f, 1e6f));
    }
}

void Parser::ParsePackageRequirements()
{
    auto& requirements = m_Pass ? m_Pass->packageRequirements : m_SubShader->packageRequirements;
    if (!Expect("PackageRequirements", '{'))
    {
        return;
    }
    while (!Accept('}'))
    {
        if (m_Token.kind != TokenKind::String)
        {
            Error("PackageRequirements: unexpected " + Found() +
                  "; an entry is \"package\" or \"package\" : \"versions\"");
            if (m_Token.kind == TokenKind::End || isAnyCommand())
            {
                return;
            }
            Advance();
            continue;
        }
        const Token package = Advance();
        std::string range;
        if (Accept(':'))
        {
            range = ParseString("PackageRequirements").value_or("");
        }
        if (Count())
        {
            requirements.push_back({package.location, std::string(package.text), std::move(range)});
        }
    }
}

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
    if (!chunk || !CountRepeated(SizeOf(includes, &SourceChunk::text)) || !Count(includes.size()))
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
