#pragma once

#include <limn/shaderlab/ShaderLabParser.h>

#include "document/StateNames.h"
#include "parser/Lexer.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace limn
{

/// Returns the names of things that have one.
template <typename Items>
std::vector<std::string_view> NamesIn(const Items& items)
{
    std::vector<std::string_view> names;
    for (const auto& item : items)
    {
        names.push_back(item.name);
    }
    return names;
}

/// Parses the tokens of one file by recursive descent. Each scope has a table of commands; unknown
/// commands are reported and skipped. Only Category blocks can be nested without end, so their
/// depth is limited; everything else that could grow beyond the size of the file is counted.
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
        bool isRaw = false;      ///< raw text follows: called with the name as the token
    };
    using CommandTable = std::vector<Command>;

    /// The state that a scope passes to the scopes inside it.
    struct Scope
    {
        RenderState state;
        ShaderTags tags;
        int lod = 0;
        std::vector<LegacyCommand> legacyCommands;
    };

    // Parser.cpp: tokens, blocks, and which command stands where
    static const CommandTable& ShaderCommands();
    static const CommandTable& CategoryCommands();
    static const CommandTable& SubShaderCommands();
    static const CommandTable& PassCommands();
    std::string_view PlaceOfCommand() const;
    Token Advance();
    void TakeDirective();
    bool isWord(std::string_view word) const;
    bool isPunctuation(char mark) const;
    bool Accept(char mark);
    bool Expect(std::string_view subject, char mark);
    const Command* FindCommand(const CommandTable& table) const;
    bool isAnyCommand() const;
    bool isOuterCommand() const;
    void SkipUnknown();
    void SkipRestOfCommand();
    void SkipTokenOrBraces();
    void ParseBlock(std::string_view scope, const CommandTable& table);
    void ParseCommand(const Command& command);
    void ParseUnknown(std::string_view scope, const CommandTable& table);
    std::optional<std::string> ParseString(std::string_view subject);
    std::optional<float> ParseNumber(std::string_view subject);
    std::optional<std::string> ParseReference(std::string_view subject);

    // Diagnostics and limits
    std::string Found() const;
    void Report(Severity severity, SourceLocation location, std::string message);
    void Error(std::string message);
    void ReportNotClosed(std::string_view scope, SourceLocation opening);
    void ReportStillOpen(std::string_view scope, SourceLocation opening);
    void Stop();
    bool Count(std::size_t items = 1);
    bool CountRepeated(std::size_t bytes);
    void FinishDiagnostics();

    // Structure.cpp: shader, category, sub-shader, pass
    void ParseFile();
    void ParseCategory();
    void ParseSubShader();
    void ParsePass();
    void ParseUsePass();
    void ParseGrabPass();
    void ParseGrabPassBody(ShaderLabPass& pass);
    void AddPass(ShaderLabPass pass);
    void ParseName();
    void ParseFallback();
    void ParseCustomEditor();
    void ParsePipelineEditor();
    void ParseDependency();

    // Structure.cpp: tags and the like
    void ParseTags();
    void ParseTag(ShaderTags& tags);
    void CheckTag(const Token& key, const Token& value);
    void ParseLod();
    void ParsePackageRequirements();

    // Structure.cpp: programs
    std::optional<SourceChunk> ReadChunk(std::string_view endWord);
    std::optional<PassProgram> ReadProgram();
    void ReadPragmas();
    void ParseIncludeBlock();
    void ParseProgram();
    void ParseSurface();

    // Properties.cpp
    void ParseProperties();
    void ParseProperty();
    bool ParseAttributes(ShaderProperty& property);
    bool ParsePropertyHead(ShaderProperty& property);
    bool ParsePropertyType(ShaderProperty& property);
    bool ParseRangeLimits(ShaderProperty& property);
    void ParsePropertyDefault(ShaderProperty& property);
    bool ParseNumberDefault(ShaderProperty& property);
    bool ParseVectorDefault(ShaderProperty& property);
    bool ParseTextureDefault(ShaderProperty& property);
    void ParseTextureMode(ShaderProperty& property);
    void SkipProperty(int line);
    void ReportDuplicateProperties();

    // State.cpp: fixed-function state into m_Scope.state
    static CommandTable WithCommonCommands(CommandTable table);
    static const CommandTable& StencilCommands();
    template <auto Field, const auto& Names>
    void ParseState();
    void ParseOffset();
    void ParseBlend();
    void ParseBlendOp();
    void ParseColorMask();
    std::span<PassBlendState> ParseTargets(std::string_view subject);
    template <typename T>
    bool ParseStateReference(std::string_view subject, StateValue<T>& target);
    bool ParseFloat(std::string_view subject, StateValue<float>& target);
    template <typename T>
    bool ParseEnum(std::string_view subject,
                   std::type_identity_t<std::span<const EnumName<T>>> names, StateValue<T>& target);
    void ParseStencil();
    template <StateValue<int> PassStencilState::*Field>
    void ParseStencilByte();
    /// Parses a state of both faces, or of one where the command ends in Front or Back.
    template <auto Field, const auto& Names>
    void ParseStencilFaces();

    // State.cpp: fixed-function lighting and texturing, kept as text in m_Legacy
    /// Parses a command of a scope whose arguments a member function appends.
    template <bool (Parser::*Append)()>
    void ParseLegacyCommand();
    /// Parses a command inside a legacy block.
    template <bool (Parser::*Append)()>
    void ParseLegacyField();
    void ParseLegacyBlock();
    void ParseBind();
    void ParseSetTexture();
    bool AppendAlphaTest();
    bool AppendRange();
    bool AppendCombine();
    bool AppendCombineSource();
    bool AppendCombination();
    bool AppendNumber();
    bool AppendColor();
    bool AppendReference();
    template <const auto& Names>
    bool AppendName();
    bool AppendLerpFactor();
    void AddLegacy(SourceLocation location, bool isGood);
    void NoteLegacyCommands(const ShaderLabPass& pass);
    static const CommandTable& LegacyBlockCommands(std::string_view command);

    Lexer m_Lexer;
    Token m_Token;
    SourceLocation m_Command; ///< the place of the command word being parsed
    std::string_view m_Word;  ///< the command word being parsed, as the tables spell it
    bool m_ReportedEnd = false;
    int m_FailedLine = 0; ///< line of an error in the command being parsed; 0 = none so far
    std::array<std::size_t, 3> m_Reported{}; ///< by severity
    std::size_t m_Items = 0;
    bool m_IsStopped = false;
    /// The tables of the scopes around the current place.
    std::vector<const CommandTable*> m_Tables;
    /// The include blocks of the file so far, by ProgramLanguage.
    std::array<std::vector<SourceChunk>, 3> m_Includes;
    std::size_t m_RepeatedBytes = 0; ///< bytes of the copies that inner scopes received
    int m_CategoryDepth = 0;
    Scope m_Scope;
    ShaderLabSubShader* m_SubShader = nullptr;
    ShaderLabPass* m_Pass = nullptr;
    std::string m_Legacy; ///< the legacy command being parsed, canonical
    SourceLocation m_NotedLegacy;
    ShaderLabParseResult m_Result;
};

} // namespace limn
