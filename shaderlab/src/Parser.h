#pragma once

#include <limn/shaderlab/ShaderLabParser.h>

#include "Lexer.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limn
{

template <typename T>
struct EnumName
{
    std::string_view name;
    T value;
};

/// Recursive descent over the tokens of one file. Each scope is a table of commands; what no table
/// knows is reported and skipped.
class Parser
{
public:
    Parser(std::string_view text, std::string file);

    ShaderLabParseResult Parse();

private:
    struct Command
    {
        std::string_view name;
        void (Parser::*parse)(); ///< called with the token behind the name
    };
    using CommandTable = std::vector<Command>;

    // Parser.cpp: tokens, diagnostics and blocks
    Token Advance();
    bool isWord(std::string_view word) const;
    bool isPunctuation(std::string_view mark) const;
    bool Accept(std::string_view mark);
    bool Expect(std::string_view subject, std::string_view mark);
    std::string Found() const;
    void Report(Severity severity, SourceLocation location, std::string message);
    void Error(std::string message);
    const Command* FindCommand(const CommandTable& table) const;
    bool isAnyCommand() const;
    bool isOuterCommand() const;
    void SkipUnknown();
    void SkipBraces();
    void ParseBlock(std::string_view scope, const CommandTable& table);
    void ParseUnknown(std::string_view scope, const CommandTable& table);
    std::optional<std::string> ParseString(std::string_view subject);
    std::optional<double> ParseNumber(std::string_view subject);
    std::optional<std::string> ParseReference(std::string_view subject);

    // ParserStructure.cpp: shader, sub-shader, pass, tags, programs
    void ParseFile();
    void ParseShader();
    void ParseCategory();
    void ParseSubShader();
    void ParsePass();
    void ParseName();
    void ParseIgnoredName();
    void ParseTags();
    void ParseTagsInto(ShaderTags& tags);
    void ParseLod();
    void ParseFallback();
    void ParseCustomEditor();
    void ParsePipelineEditor();
    void ParseDependency();
    void ParseUnsupportedBlock();
    void ParseUsePass();
    void ParseIncludeBlock();
    void ParseProgram();
    void ParseStrayProgram();
    std::optional<SourceChunk> ReadChunk(std::string_view endWord);
    static const CommandTable& ShaderCommands();
    static const CommandTable& CategoryCommands();
    static const CommandTable& SubShaderCommands();
    static const CommandTable& PassCommands();

    // ParserProperties.cpp
    void ParseProperties();
    void ParseProperty();
    bool ParsePropertyType(ShaderProperty& property);
    bool ParseRangeLimits(ShaderProperty& property);
    void ParsePropertyDefault(ShaderProperty& property);
    void ParseNumberDefault(ShaderProperty& property);
    void ParseVectorDefault(ShaderProperty& property);
    void ParseTextureDefault(ShaderProperty& property);
    void SkipProperty();

    // ParserState.cpp: fixed-function commands into *m_State
    void ParseCull();
    void ParseZTest();
    void ParseZWrite();
    void ParseZClip();
    void ParseAlphaToMask();
    void ParseConservative();
    void ParseOffset();
    void ParseBlend();
    void ParseBlendOp();
    void ParseColorMask();
    std::optional<std::size_t> ParseTargetIndex(std::string_view subject);
    std::span<PassBlendState> TargetsOf(std::optional<std::size_t> index);
    bool ParseBool(std::string_view subject, StateValue<bool>& target);
    bool ParseBlendFactor(StateValue<BlendMode>& target);
    bool ParseBlendOperation(StateValue<BlendOp>& target);
    template <typename T>
    bool ParseEnum(std::string_view subject, std::span<const EnumName<T>> names,
                   StateValue<T>& target);

    // ParserStencil.cpp
    void ParseStencil();
    void ParseStencilRef();
    void ParseStencilReadMask();
    void ParseStencilWriteMask();
    void ParseStencilByte(std::string_view subject, StateValue<int>& target);
    template <StateValue<CompareFunction> StencilFaceState::*Field, bool Front, bool Back>
    void ParseStencilCompare();
    template <StateValue<StencilOp> StencilFaceState::*Field, bool Front, bool Back>
    void ParseStencilOperation();
    static const CommandTable& StencilCommands();

    // ParserLegacy.cpp: fixed-function lighting, read and dropped
    void IgnoreWord();
    void IgnoreBlock();
    void IgnoreColor();
    void IgnoreAlphaTest();
    void IgnoreSetTexture();

    static void AppendStateCommands(CommandTable& table);
    static void AppendLegacyCommands(CommandTable& table);

    Lexer m_Lexer;
    Token m_Token;
    SourceLocation m_Command; ///< of the command word being parsed
    std::string_view m_Word;  ///< the command word being parsed, as written
    Lexer::Mark m_WordEnd;    ///< behind that word
    bool m_ReportedEnd = false;
    std::vector<const CommandTable*> m_Tables; ///< of the scopes around the current place
    std::vector<SourceChunk> m_HlslIncludes;
    std::vector<SourceChunk> m_CgIncludes;
    RenderState m_RootState;
    RenderState* m_State = &m_RootState;
    ShaderTags m_CategoryTags;
    ShaderTags* m_Tags = nullptr;
    ShaderLabSubShader* m_SubShader = nullptr;
    ShaderLabPass* m_Pass = nullptr;
    ShaderLabParseResult m_Result;
};

/// How ShaderLab spells the comparisons, both of ZTest and of Stencil.
std::span<const EnumName<CompareFunction>> CompareFunctionNames();

template <typename T>
bool Parser::ParseEnum(std::string_view subject, std::span<const EnumName<T>> names,
                       StateValue<T>& target)
{
    if (isPunctuation("["))
    {
        const auto property = ParseReference(subject);
        if (property)
        {
            target = StateValue<T>::FromProperty(*property);
        }
        return property.has_value();
    }
    for (const EnumName<T>& name : names)
    {
        if (isWord(name.name))
        {
            target = name.value;
            Advance();
            return true;
        }
    }
    if (m_Token.kind != TokenKind::Identifier || isAnyCommand())
    {
        Error(std::string(subject) + ": value is missing before " + Found() +
              "; write a name or [_Property]");
        return false;
    }
    std::vector<std::string_view> known;
    for (const EnumName<T>& name : names)
    {
        known.push_back(name.name);
    }
    Error(std::string(subject) + ": unknown value " + UnknownName(m_Token.text, known));
    Advance();
    return false;
}

} // namespace limn
