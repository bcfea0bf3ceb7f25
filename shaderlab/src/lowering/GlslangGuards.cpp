#include "lowering/GlslangGuards.h"

#include "hlsl/DuplicateDeclarations.h"
#include <limn/base/Text.h>

#include <algorithm>
#include <unordered_map>
#include <vector>

namespace limn
{

namespace
{

char ClosingOf(std::string_view open)
{
    return open == "(" ? ')' : open == "[" ? ']' : '}';
}

/// Returns whether the node's value is known only when the program runs.
bool isVariable(const HlslNode& node, const HlslTokens& tokens, const HlslGlobals& globals)
{
    const bool isConstant =
        node.local ? node.local->parent &&
                         tokens.Span(node.local->parent->first, node.local->token).find("const") !=
                             std::string_view::npos
                   : !node.variable || node.variable->Has("const");
    return node.kind == HlslNodeKind::Name ? !isConstant
           : node.kind == HlslNodeKind::Call
               ? !globals.FindFunctions(tokens.Text(node.token)).empty()
               : false;
}

void CheckLabel(const HlslNode& label, const HlslTokens& tokens, const HlslGlobals& globals,
                std::vector<HlslProblem>& problems)
{
    const HlslNode* parent = label.parent;
    while (parent && parent->kind != HlslNodeKind::Switch)
    {
        parent = parent->parent;
    }
    const HlslNode* const variable =
        FindNode(label, [&](const HlslNode& part) { return isVariable(part, tokens, globals); });
    if (!parent)
    {
        problems.push_back({label.token, "it stands outside of a switch"});
    }
    else if (variable)
    {
        problems.push_back({variable->token, "the value of a case must be a constant"});
    }
}

void CheckGather(const HlslNode& method, const HlslTokens& tokens,
                 std::vector<HlslProblem>& problems)
{
    const std::string_view name = tokens.Text(method.token);
    const HlslType& texture = method.child->type;
    if (texture.kind != HlslType::Kind::Object || !name.starts_with("GatherCmp"))
    {
        return;
    }
    if (texture.name.starts_with("TextureCube"))
    {
        problems.push_back({method.token, "limn cannot compare four texels of a cube at once; use "
                                          "'SampleCmpLevelZero' for each"});
    }
    else if (name != "GatherCmp" && name != "GatherCmpRed")
    {
        problems.push_back({method.token,
                            "a device compares only the first component of a texel; use "
                            "'GatherCmpRed'"});
    }
}

constexpr std::size_t k_DeepestBrackets = 500;
constexpr std::size_t k_DeepestOperators = 2000;
constexpr std::size_t k_DeepestStructs = 100;

/// Adds up how deep the tree of an expression is at most: a chain of operators goes down by one
/// with each, and so do a chain of `else if` and what is called, indexed or picked of one value
/// (`a.b[0].c`); brackets cost a compiler more, and a cast is one.
class DepthCounter
{
public:
    /// The depth that the tree may have.
    std::size_t Take(const HlslToken& token, std::string_view next)
    {
        const char mark = token.Mark();
        if (mark == '(' || mark == '[' || mark == '{')
        {
            m_Levels.emplace_back();
            m_Levels.back().isList = isList(mark);
        }
        else if ((mark == ')' || mark == ']' || mark == '}') && m_Levels.size() > 1)
        {
            const std::size_t inner = m_Levels.back().Depth() + k_Bracket;
            m_Levels.pop_back();
            m_Levels.back().AddBracket(inner);
        }
        else if (mark == '.')
        {
            m_Levels.back().AddPick(1);
        }
        else if (isOperator(token) || (mark == ',' && !m_Levels.back().isList))
        {
            m_Levels.back().AddOperator();
        }
        const std::size_t depth = std::max(m_Levels.back().Depth(), m_Levels.size() * k_Bracket);
        const bool isEnd = mark == ';' || mark == '}' || (mark == ',' && m_Levels.back().isList);
        if (isEnd && next != "else" && next != ";")
        {
            m_Levels.back().End();
        }
        m_Previous = token;
        return depth;
    }

    static constexpr std::size_t k_Bracket = k_DeepestOperators / k_DeepestBrackets;

private:
    struct Level
    {
        bool isList = true;      ///< commas part items, they are no operators
        bool hasBracket = false; ///< the value at hand
        std::size_t operators = 0;
        std::size_t picks = 0; ///< of the value at hand
        std::size_t mostPicks = 0;
        std::size_t inner = 0;   ///< deepest of its brackets
        std::size_t deepest = 0; ///< of the expressions before this one

        std::size_t Depth() const { return std::max(operators + mostPicks + inner, deepest); }
        void AddOperator()
        {
            ++operators;
            picks = 0;
            hasBracket = false;
        }
        void AddBracket(std::size_t depth)
        {
            inner = std::max(inner, depth);
            AddPick(hasBracket ? k_Bracket : 0);
            hasBracket = true;
        }
        void AddPick(std::size_t depth)
        {
            picks += depth;
            mostPicks = std::max(mostPicks, picks);
        }
        void End() { *this = {isList, false, 0, 0, 0, 0, Depth()}; }
    };

    static bool isStatement(std::string_view word)
    {
        return word == "if" || word == "else" || word == "for" || word == "while" || word == "do" ||
               word == "switch";
    }

    static bool isOperator(const HlslToken& token)
    {
        constexpr std::string_view k_NoOperators = ".,;:(){}[]\"";
        const char first = token.text[0];
        return token.isWord ? isStatement(token.text)
                            : !isDigit(first) && k_NoOperators.find(first) == k_NoOperators.npos;
    }

    /// Returns whether a bracket behind m_Previous opens a list of arguments, parameters or initial
    /// values.
    bool isList(char bracket) const
    {
        return bracket == '(' ? m_Previous.isWord && m_Previous.text != "return" &&
                                    !isStatement(m_Previous.text)
               : bracket == '{'
                   ? m_Previous.text == "=" || m_Previous.text == "," || m_Previous.text == "{"
                   : true;
    }

    std::vector<Level> m_Levels{1};
    HlslToken m_Previous;
};

/// Counts how deep structs hold structs, as members or bases.
class StructCounter
{
public:
    /// Returns how deeply the type is nested whose declaration is at the token.
    std::size_t Take(const HlslTokens& tokens, std::size_t index)
    {
        const auto text = [&](std::size_t ahead)
        {
            return tokens.Text(index + ahead);
        };
        if (tokens.isWord(index))
        {
            return TakeWord(text(0), text(1), text(2), text(3));
        }
        const char mark = tokens.all()[index].Mark();
        if (mark == '{')
        {
            m_Open.push_back(m_Next);
            m_Next = {};
        }
        else if (mark == '}' && !m_Open.empty())
        {
            Close(text(1));
        }
        else if (mark == ';' || mark == '(' || mark == ')' || mark == '=')
        {
            m_Next = {};
        }
        return 0;
    }

private:
    struct Type
    {
        std::string_view name;
        bool isStruct = false; ///< or whatever else has braces
        std::size_t depth = 0;
    };

    std::size_t TakeWord(std::string_view word, std::string_view next, std::string_view name,
                         std::string_view end)
    {
        const bool isMember = !m_Open.empty() && m_Open.back().isStruct;
        if (word == "struct")
        {
            m_Next = {next, true, 1};
        }
        else if (word == "typedef" && end == ";")
        {
            m_Depths[name] = DepthOf(next);
        }
        else if (m_Next.isStruct || isMember)
        {
            Type& holder = m_Next.isStruct ? m_Next : m_Open.back();
            holder.depth = std::max(holder.depth, DepthOf(word) + 1);
            return holder.depth;
        }
        return 0;
    }

    std::size_t DepthOf(std::string_view type) const
    {
        const auto found = m_Depths.find(type);
        return found == m_Depths.end() ? 0 : found->second;
    }

    /// @param next  a name for the struct or a variable where it is one
    void Close(std::string_view next)
    {
        const Type type = m_Open.back();
        m_Open.pop_back();
        if (type.isStruct)
        {
            m_Depths[type.name] = type.depth;
            m_Depths[next] = type.depth;
        }
        if (!m_Open.empty())
        {
            m_Open.back().depth = std::max(m_Open.back().depth, type.depth + 1);
        }
    }

    std::unordered_map<std::string_view, std::size_t> m_Depths;
    Type m_Next; ///< its `{` is still to come
    std::vector<Type> m_Open;
};

std::string DescribeDepth(const std::string& most)
{
    return "nested more than " + most + " deep";
}

/// `x++` and `1 ? x : y`: glslang crashes where x is no variable.
void CheckOperands(const HlslNode& node, const HlslTokens& tokens,
                   std::vector<HlslProblem>& problems)
{
    for (const HlslNode* operand = node.child; operand; operand = operand->next)
    {
        const HlslNode* inner = operand;
        while (inner->kind == HlslNodeKind::Paren && inner->child)
        {
            inner = inner->child;
        }
        if (inner->kind == HlslNodeKind::Name && !inner->local && !inner->variable)
        {
            problems.push_back({inner->token, "unknown variable"});
        }
        else if (node.kind == HlslNodeKind::Postfix &&
                 (inner->kind == HlslNodeKind::Literal || inner->kind == HlslNodeKind::Call ||
                  inner->kind == HlslNodeKind::Construct || inner->kind == HlslNodeKind::Cast ||
                  inner->kind == HlslNodeKind::Postfix || inner->kind == HlslNodeKind::Binary))
        {
            problems.push_back(
                {inner->first, "this is no variable, so '" + std::string(tokens.Text(node.token)) +
                                   "' cannot change it; put the value into a variable"});
        }
    }
}

} // namespace

void RequirePairs(const HlslTokens& tokens)
{
    const auto failOpen = [&](std::size_t token, const std::string& where)
    {
        throw AssetError({tokens.Error(token, std::string("a '") + ClosingOf(tokens.Text(token)) +
                                                  "' is missing for it" + where)});
    };
    std::size_t unclosed = tokens.size(); // the first
    for (std::size_t i = 0; i < tokens.size(); ++i)
    {
        const int step = tokens.Step(i);
        const std::size_t open = tokens.MatchingOpen(i);
        const std::size_t last = tokens.AfterBracket(i) - 1;
        if (step > 0 && (last == i || tokens.MatchingOpen(last) != i))
        {
            unclosed = std::min(unclosed, i);
        }
        else if (step < 0 && open == i)
        {
            throw AssetError({tokens.Error(i, "this bracket closes nothing")});
        }
        else if (step < 0 && tokens.Text(i)[0] != ClosingOf(tokens.Text(open)))
        {
            failOpen(open, " before the '" + std::string(tokens.Text(i)) + "' of line " +
                               std::to_string(tokens.Place(i).location.line));
        }
    }
    if (unclosed < tokens.size())
    {
        failOpen(unclosed, "");
    }
}

void RequireShallow(const HlslTokens& tokens)
{
    const auto fail = [&](std::size_t token, const std::string& most)
    {
        const HlslPlace place = tokens.Place(token);
        throw AssetError(place.file, place.location,
                         "HLSL: this is " + DescribeDepth(most) + "; take it apart");
    };
    StructCounter structs;
    DepthCounter counter;
    for (std::size_t i = 0; i < tokens.size(); ++i)
    {
        if (counter.Take(tokens.all()[i], tokens.Text(i + 1)) > k_DeepestOperators)
        {
            fail(i, std::to_string(k_DeepestBrackets) + " brackets or " +
                        std::to_string(k_DeepestOperators) + " operators");
        }
        if (structs.Take(tokens, i) > k_DeepestStructs)
        {
            fail(i, std::to_string(k_DeepestStructs) + " structs");
        }
    }
}

std::optional<int> FindDeepMacros(std::string_view text, int firstLine)
{
    std::size_t code = 0;
    std::size_t directive = 0;
    bool isDirective = false;
    bool isCondition = false;
    bool goesOn = false; // the line before ends in a backslash
    for (int number = firstLine; !text.empty(); ++number)
    {
        const std::size_t size = std::min(text.find('\n'), text.size());
        const std::string_view line = Trim(text.substr(0, size));
        text.remove_prefix(std::min(size + 1, text.size()));
        if (!goesOn)
        {
            isDirective = line.starts_with("#");
            const std::string_view name = isDirective ? Trim(line.substr(1)) : "";
            isCondition = name.starts_with("if") || name.starts_with("elif");
            directive = 0;
        }
        goesOn = line.ends_with("\\");
        std::size_t& depth = isDirective ? directive : code;
        for (const char c : line)
        {
            const bool isSign = isCondition && (c == '!' || c == '~' || c == '-');
            depth += c == '(' || isSign ? 1 : 0;
            depth -= c == ')' && depth > 0 ? 1 : 0;
            depth = c == ';' || c == '{' || c == '}' ? 0 : depth;
            if (depth > k_DeepestBrackets)
            {
                return number;
            }
        }
    }
    return std::nullopt;
}

std::string DescribeDeepMacros()
{
    return DescribeDepth(std::to_string(k_DeepestBrackets) + " brackets");
}

void RequireSoundNodes(const HlslNodes& nodes, const HlslTokens& tokens, const HlslGlobals& globals)
{
    std::vector<HlslProblem> problems;
    // Code that is not understood may declare names.
    const bool knowsNames = std::ranges::none_of(nodes, [](const HlslNode& node)
                                                 { return node.kind == HlslNodeKind::Unknown; });
    for (const HlslNode& node : nodes)
    {
        if (node.kind == HlslNodeKind::Label)
        {
            CheckLabel(node, tokens, globals, problems);
        }
        else if (node.kind == HlslNodeKind::Method)
        {
            CheckGather(node, tokens, problems);
        }
        else if (knowsNames &&
                 (node.kind == HlslNodeKind::Postfix || node.kind == HlslNodeKind::Ternary))
        {
            CheckOperands(node, tokens, problems);
        }
        else if (node.kind == HlslNodeKind::List && !node.child && node.parent &&
                 node.parent->kind == HlslNodeKind::List)
        {
            problems.push_back({node.first, "this inner list is empty; write its values"});
        }
    }
    tokens.Refuse(problems);
}

void RequireSound(const HlslSource& source)
{
    source.tokens.Refuse(source.declarations.problems); // others may come of them
    std::vector<HlslProblem> problems;
    for (const HlslVariable* variable : FindDuplicates(source.declarations).redefinitions)
    {
        problems.push_back(
            {variable->token, "this is a redefinition; something else has this name already"});
    }
    const HlslTokens& tokens = source.tokens;
    for (std::size_t i = 0; i + 3 < tokens.size(); ++i)
    {
        if (tokens.Text(i) == ")" && tokens.Text(i + 1) == "." && tokens.Text(i + 3) == "(" &&
            !source.globals.FindMethods(tokens.Text(i + 2)).empty())
        {
            problems.push_back({i + 2, "a method of what a function returns cannot be called; keep "
                                       "the result in a variable first"});
        }
    }
    source.tokens.Refuse(problems);
}

} // namespace limn
