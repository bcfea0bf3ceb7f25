#pragma once

#include "hlsl/Tree.h"

#include <cstddef>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace limn
{

/// Reads the statements of functions and the values of variables. Text that it does not know
/// becomes Unknown nodes up to the end of the statement or bracket.
class HlslTreeParser
{
public:
    /// @param tokens        must outlive this
    /// @param declarations  give the names of types; must outlive this
    HlslTreeParser(const HlslTokens& tokens, const HlslDeclarations& declarations,
                   HlslNodes& nodes);

    /// Parses a block from its `{` on.
    HlslNode* ParseBlock(std::size_t open);
    /// Returns the words that follow a declaration without the missing `;`, because glslang does
    /// not report it.
    const std::vector<HlslProblem>& unended() const { return m_Unended; }

    /// Returns the tokens that are in the place of a type but name none.
    const std::vector<std::size_t>& unknownTypes() const { return m_UnknownTypes; }

    /// Parses an expression or { list } from one token to the one before `end`.
    HlslNode* ParseValue(std::size_t first, std::size_t end);

private:
    std::string_view Text(std::size_t ahead = 0) const { return m_Tokens.Text(m_Index + ahead); }
    bool isWord(std::size_t ahead = 0) const { return m_Tokens.isWord(m_Index + ahead); }
    bool isEnd() const { return m_Index >= m_End; }
    /// @param operand  becomes its first child
    HlslNode* Make(HlslNodeKind kind, std::size_t first, HlslNode* operand = nullptr);
    /// Makes a node like Make, and continues behind its token.
    HlslNode* Take(HlslNodeKind kind, std::size_t first, HlslNode* operand = nullptr);
    /// Ends the node at the parser's present place.
    HlslNode* Close(HlslNode* node);
    /// Makes an Unknown node from one token to the one before `end`, and continues at `end`.
    HlslNode* ReadUnknown(std::size_t first, std::size_t end);

    // Statements
    HlslNode* ReadStatement();
    HlslNode* ReadWordStatement(std::size_t first);
    HlslNode* ReadBlock(std::size_t first);
    HlslNode* ReadLoop(HlslNodeKind kind, std::size_t first);
    HlslNode* ReadFor(std::size_t first);
    HlslNode* ReadDo(std::size_t first);
    HlslNode* ReadLabel(std::size_t first);
    HlslNode* ReadSimple(std::size_t first);
    HlslNode* ReadDeclaration(std::size_t first);
    HlslNode* ReadDeclarator(HlslType type);
    HlslNode* ReadCondition();
    bool isDeclaration() const;
    std::size_t EndOfStatement() const;

    // Expressions
    HlslNode* ReadExpression();
    HlslNode* ReadAssignment();
    HlslNode* ReadBinary(int precedence);
    HlslNode* ReadPrefix();
    HlslNode* ReadPostfix();
    HlslNode* ReadPrimary();
    HlslNode* ReadArguments(HlslNode* node, std::string_view close);

    /// Reads the type at the index, template arguments and `unsigned` included. Returns the index
    /// behind it, or 0 if there is none.
    std::size_t ReadType(std::size_t index, HlslType& type) const;
    /// Reads a type like ReadType, with the brackets of an array behind it.
    std::size_t ReadArrayType(std::size_t index, HlslType& type) const;
    bool isTypeName(std::size_t index) const;
    bool isOperand(std::size_t index) const;

    const HlslTokens& m_Tokens;
    const HlslDeclarations& m_Declarations;
    HlslNodes& m_Nodes;
    std::unordered_set<std::string_view> m_TypeNames; ///< the author's types, local ones included
    std::vector<HlslProblem> m_Unended;
    std::vector<std::size_t> m_UnknownTypes;
    std::size_t m_Index = 0;
    std::size_t m_End = 0;
};

} // namespace limn
