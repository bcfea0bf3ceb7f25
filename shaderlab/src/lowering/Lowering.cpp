#include "lowering/Lowering.h"

#include <limn/base/WordList.h>

#include <algorithm>
#include <vector>

namespace limn
{

namespace
{

bool isTruth(const HlslNode& node)
{
    return node.type.isNumber() && !node.type.isMatrix() && node.type.scalar == HlslScalar::Bool;
}

bool isOfLoop(const HlslNode& declarator)
{
    const HlslNode* declaration = declarator.parent;
    const HlslNode* loop = declaration ? declaration->parent : nullptr;
    return loop && loop->kind == HlslNodeKind::For && loop->child == declaration;
}

/// The statement around a loop that a declaration may stand before.
const HlslNode& StatementOf(const HlslNode& loop)
{
    const HlslNode* statement = &loop;
    while (statement->parent && statement->parent->kind != HlslNodeKind::Block)
    {
        statement = statement->parent;
    }
    return *statement;
}

/// The variable that `a.b[i].xy` is a part of.
const HlslNode& RootOf(const HlslNode& target)
{
    const HlslNode* node = &target;
    while (node->child && (node->kind == HlslNodeKind::Member ||
                           node->kind == HlslNodeKind::Index || node->kind == HlslNodeKind::Paren))
    {
        node = node->child;
    }
    return *node;
}

/// Returns whether the node changes its first operand: `=`, `+=`, `++`, `--`.
bool isChange(const HlslNode& node, const HlslTokens& tokens)
{
    const std::string_view text = tokens.Text(node.token);
    return node.kind == HlslNodeKind::Assign || node.kind == HlslNodeKind::Postfix ||
           (node.kind == HlslNodeKind::Prefix && (text == "++" || text == "--"));
}

/// Returns whether a function of this name has an out or inout parameter at the index.
bool isGivenBack(std::span<const HlslFunction* const> functions, std::size_t index)
{
    return std::ranges::any_of(
        functions, [&](const HlslFunction* function)
        { return index < function->parameters.size() && function->parameters[index].isOutput(); });
}

/// Several elements of a matrix, which glslang writes to in a plain assignment only.
bool isOfElements(const HlslNode& node)
{
    return node.kind == HlslNodeKind::Member && node.child->type.isMatrix() && node.type.isVector();
}

/// Calls a function with each element that a word names, "_m00", and how many come before it.
template <typename F>
void ForEachElement(std::string_view word, F&& each)
{
    const std::size_t size = word.starts_with("_m") ? 4 : 3;
    for (std::size_t i = 0; (i + 1) * size <= word.size(); ++i)
    {
        each(i, std::string(word.substr(i * size, size)));
    }
}

/// `m._m00 = v.x; m._m11 = v.y; `.
std::string WriteElements(const std::string& matrix, std::string_view word,
                          const std::string& vector)
{
    std::string text;
    ForEachElement(word,
                   [&](std::size_t index, const std::string& element) {
                       text += matrix + "." + element + " = " + vector + "." + "xyzw"[index] + "; ";
                   });
    return text;
}

/// Returns whether an index around the written value is computed.
bool HasIndex(const HlslNode& node)
{
    const auto isComputed = [](const HlslNode& part)
    {
        return part.kind == HlslNodeKind::Index && part.last->kind != HlslNodeKind::Literal &&
               part.last->kind != HlslNodeKind::Name;
    };
    return FindNode(node, isComputed) != nullptr;
}

/// A function that calls another one with copies of what it is given, and gives them back.
struct CallWithCopies
{
    std::string parameters;
    std::string arguments;
    std::string before; ///< the call
    std::string after;
    int count = 0;

    void Add(const HlslVariable& parameter)
    {
        const std::string name = "p" + std::to_string(count);
        AddParameter(parameter, DeclarationOf(name, parameter), name);
    }

    void AddCopy(const HlslNode& argument, const HlslVariable& parameter, std::string_view word)
    {
        const std::string name = "p" + std::to_string(count);
        const std::string copy = "q" + std::to_string(count);
        const std::string type(parameter.type);
        const bool isElements = isOfElements(argument);
        const std::string given = "((" + argument.type.Spelling() + ")" + copy + ")";
        before += type + " " + copy + " = (" + type + ")" +
                  (isElements ? ReadElements(argument.type, name, word) : name) + "; ";
        after += isElements ? WriteElements(name, word, given) : name + " = " + given + "; ";
        const HlslType& handed = isElements ? argument.child->type : argument.type;
        AddParameter(parameter, handed.Spelling() + " " + name, copy);
    }

    std::string Write(const HlslFunction& function, const std::string& name,
                      const std::string& called) const
    {
        const std::string result = TypeText(function.returnType, function.returnArgument);
        const bool isVoid = result == "void";
        return " " + result + " " + name + "(" + parameters + ") { " + before +
               (isVoid ? "" : result + " r = ") + called + "(" + arguments + "); " + after +
               (isVoid ? "} " : "return r; } ");
    }

private:
    void AddParameter(const HlslVariable& parameter, const std::string& declaration,
                      const std::string& argument)
    {
        const std::string comma = count++ > 0 ? ", " : "";
        parameters += comma + (parameter.isOutput() ? "inout " : "") + declaration;
        arguments += comma + argument;
    }
};

} // namespace

void HlslLowering::Wrap(const HlslNode& node, std::string_view before, std::string_view after)
{
    m_Code.Spelling(node.first).insert(0, before);
    m_Code.Spelling(node.end - 1).append(after);
}

void HlslLowering::Need(const std::string& text)
{
    if (m_Known.insert(text).second)
    {
        m_Functions += text;
    }
}

void HlslLowering::Lower(HlslNode& node, bool isInitial)
{
    const bool isStatic = node.kind == HlslNodeKind::Declaration &&
                          m_Code.Span(node.first, node.token).starts_with("static");
    for (HlslNode* child = node.child; child; child = child->next)
    {
        Lower(*child, isInitial || isStatic);
    }
    m_IsInitial = isInitial || isStatic;
    LowerNode(node);
}

void HlslLowering::LowerNode(HlslNode& node)
{
    switch (node.kind)
    {
    case HlslNodeKind::Cast:
        LowerConstantCast(node);
        LowerCast(node);
        break;
    case HlslNodeKind::Construct:
        LowerConstantCast(node);
        LowerConstruct(node);
        break;
    case HlslNodeKind::Member:
        LowerSwizzle(node);
        break;
    case HlslNodeKind::Assign:
        LowerAssignment(node);
        LowerSwizzleAssignment(node);
        if (Text(node.token) == "=")
        {
            LowerConstantCast(node);
        }
        [[fallthrough]];
    case HlslNodeKind::Binary:
        LowerMatrixOperator(node);
        LowerFolding(node);
        break;
    case HlslNodeKind::Prefix:
        if ((Text(node.token) == "-" || Text(node.token) == "~") && isTruth(*node.child))
        {
            Cast(*node.child, node.child->type.Of(HlslScalar::Int));
        }
        [[fallthrough]];
    case HlslNodeKind::Postfix:
        LowerSwizzleStep(node);
        break;
    case HlslNodeKind::Call:
    case HlslNodeKind::Method:
        LowerCall(node);
        break;
    case HlslNodeKind::Switch:
    case HlslNodeKind::Label:
        if (node.child && node.child->type.isFloating())
        {
            Wrap(*node.child, "(int)(", ")");
        }
        break;
    case HlslNodeKind::Declarator:
        LowerConstantCast(node);
        LowerDeclarator(node);
        break;
    default:
        break;
    }
}

void HlslLowering::Rename(const HlslResolver& resolver, const HlslNodes& nodes)
{
    std::set<const HlslNode*> renamed(resolver.renamed().begin(), resolver.renamed().end());
    std::vector<const HlslNode*> loops;
    for (const HlslNode* declarator : resolver.renamed())
    {
        // All that the loop declares is hoisted, and must not meet others of its name.
        const HlslNode* const loop = isOfLoop(*declarator) ? declarator->parent->parent : nullptr;
        if (!loop || std::ranges::find(loops, loop) != loops.end())
        {
            continue;
        }
        loops.push_back(loop);
        for (const HlslNode* name = loop->child->child; name; name = name->next)
        {
            renamed.insert(name);
        }
    }
    const auto spell = [&](const HlslNode& declarator, std::size_t token)
    {
        m_Code.Spelling(token) =
            "limn_" + std::string(Text(declarator.token)) + std::to_string(declarator.token);
    };
    for (const HlslNode& node : nodes)
    {
        if (node.kind == HlslNodeKind::Declarator && renamed.contains(&node))
        {
            spell(node, node.token);
        }
        else if (node.kind == HlslNodeKind::Name && renamed.contains(node.local))
        {
            spell(*node.local, node.token);
        }
    }
    for (const HlslNode* loop : loops)
    {
        Hoist(*loop);
    }
}

/// `for (int i = 0; …)` becomes `int i; for (i = 0; …)`, all its variables with it.
void HlslLowering::Hoist(const HlslNode& loop)
{
    const HlslNode& declaration = *loop.child;
    std::string names;
    for (const HlslNode* name = declaration.child; name; name = name->next)
    {
        if (name->kind != HlslNodeKind::Declarator)
        {
            return;
        }
        names += (names.empty() ? " " : ", ") + m_Code.Spelling(name->token);
    }
    const std::string type(m_Code.Span(declaration.token, declaration.child->first));
    m_Code.Erase(declaration.first, declaration.child->first);
    m_Code.Spelling(StatementOf(loop).first).insert(0, type + names + "; ");
}

std::set<const HlslVariable*> FindWrittenUniforms(const HlslNodes& nodes, const HlslTokens& tokens,
                                                  const HlslGlobals& globals)
{
    std::set<const HlslVariable*> written;
    const auto write = [&](const HlslNode& target)
    {
        const HlslNode& variable = RootOf(target);
        if (variable.kind == HlslNodeKind::Name && !variable.local &&
            globals.isUniform(variable.variable))
        {
            written.insert(variable.variable);
        }
    };
    for (const HlslNode& node : nodes)
    {
        if (isChange(node, tokens))
        {
            write(*node.child);
        }
        const std::string_view text = tokens.Text(node.token);
        const bool isCall = node.kind == HlslNodeKind::Method || node.kind == HlslNodeKind::Call;
        const HlslNode* argument = isCall ? node.FirstArgument() : nullptr;
        for (std::size_t index = 0; argument; argument = argument->next, ++index)
        {
            if (isGivenBack(globals.FindFunctions(text), index) ||
                isGivenBack(globals.FindMethods(text), index))
            {
                write(*argument);
            }
        }
    }
    return written;
}

// The targets of writes: values that are changed in place, or passed to a function that gives them
// back.

std::string ReadElements(const HlslType& type, const std::string& matrix, std::string_view word)
{
    std::string text = type.Spelling() + "(";
    ForEachElement(word, [&](std::size_t index, const std::string& element)
                   { text += (index > 0 ? ", " : "") + matrix + "." + element; });
    return text + ")";
}

bool HasEffects(const HlslNode& node, const TokenEdits& code)
{
    const auto hasEffect = [&](const HlslNode& part)
    {
        return part.kind == HlslNodeKind::Unknown || part.function || isChange(part, code.tokens());
    };
    return FindNode(node, hasEffect) != nullptr;
}

/// Returns whether the code writes to the node or to a part of it.
bool HlslLowering::isTarget(const HlslNode& node) const
{
    const HlslNode* child = &node;
    const HlslNode* parent = node.parent;
    while (parent && child == parent->child &&
           (parent->kind == HlslNodeKind::Member || parent->kind == HlslNodeKind::Index))
    {
        child = parent;
        parent = parent->parent;
    }
    if (!parent)
    {
        return false;
    }
    if (parent->function)
    {
        const HlslNode* argument = parent->FirstArgument();
        std::size_t index = 0;
        for (; argument && argument != child; argument = argument->next)
        {
            ++index;
        }
        return argument && index < parent->function->parameters.size() &&
               parent->function->parameters[index].isOutput();
    }
    return parent->child == child && isChange(*parent, m_Code.tokens());
}

/// Spells `a &= b`, where they are true or false, as `a = a & b`, because glslang makes invalid
/// SPIR-V of the other. Does the same where an integer is changed by a number of a wider kind: the
/// language computes with that kind; glslang makes an integer of the number first.
void HlslLowering::LowerAssignment(const HlslNode& node)
{
    static const WordList s_Bitwise("&= |= ^=");
    static const WordList s_Arithmetic("+= -= *= /= %=");
    const std::string_view mark = Text(node.token);
    const HlslType& type = node.child->type;
    const HlslType& given = node.last->type;
    const bool isTruth = s_Bitwise.Has(mark) && type.isNumber() && type.scalar == HlslScalar::Bool;
    const bool isSigned = type.scalar == HlslScalar::Int;
    const bool isInteger =
        type.isNumber() && !type.isMatrix() && (isSigned || type.scalar == HlslScalar::Uint);
    const bool isOfUints = isSigned && given.scalar == HlslScalar::Uint;
    const bool isWider =
        given.isFloating() || (given.isNumber() && isOfUints && (mark == "/=" || mark == "%="));
    if (!isTruth && (!s_Arithmetic.Has(mark) || !isInteger || !isWider || given.isMatrix()))
    {
        return;
    }
    if (isTruth)
    {
        Cast(*node.last, type);
    }
    const std::string op(mark.substr(0, 1));
    const std::string name = type.Spelling();
    if (HasEffects(*node.child, m_Code))
    {
        const std::string function = "limn_change_" + std::to_string(static_cast<int>(op[0]));
        Need(name + " " + function + "(inout " + name + " a, " +
             (isTruth ? name : given.Spelling()) + " b) { a = (" + name + ")(a " + op +
             " b); return a; } ");
        m_Code.Spelling(node.token) = ",";
        Wrap(node, function + "(", ")");
        return;
    }
    const std::string target = m_Code.Spelled(node.child->first, node.child->end);
    m_Code.Spelling(node.token) = "= (" + name + ")(" + target + op + " ";
    Wrap(*node.last, "(", "))");
}

/// Several elements of a matrix can be assigned to, not changed: `m._m00_m11 += v`. glslang works
/// the matrix out for each of them.
void HlslLowering::LowerSwizzleAssignment(const HlslNode& node)
{
    const HlslNode& target = *node.child;
    const std::string_view mark = Text(node.token);
    if (!isOfElements(target))
    {
        return;
    }
    const std::string op(mark.substr(0, mark.size() - 1));
    const HlslType& given = node.last->type;
    if (given.isNumber() && (HasEffects(*target.child, m_Code) || HasIndex(*target.child)))
    {
        const std::string_view word = Text(target.token);
        const std::string type = target.type.Spelling();
        const std::string function = "limn_change" + std::string(word) + "_" +
                                     (op.empty() ? "" : std::to_string(static_cast<int>(op[0])));
        Need(type + " " + function + "(inout " + target.child->type.Spelling() + " m, " +
             given.Spelling() + " v) { " + type + " r = (" + type + ")(" +
             (op.empty() ? "" : ReadElements(target.type, "m", word) + " " + op + " ") + "v); " +
             WriteElements("m", word, "r") + "return r; } ");
        m_Code.Erase(target.token - 1, target.end);
        m_Code.Spelling(node.token) = ",";
        Wrap(node, function + "(", ")");
    }
    else if (mark == "=" && given.isNumber() && given.Spelling() != target.type.Spelling())
    {
        // glslang crashes on one number, and does not convert several.
        Cast(*node.last, target.type);
    }
    else if (mark != "=")
    {
        const std::string matrix = m_Code.Spelled(target.child->first, target.child->end);
        m_Code.Spelling(node.token) =
            "= " + SwizzleFunction(target) + "(" + matrix + ") " + op + " ";
        Wrap(*node.last, "(", ")");
    }
}

/// `m._m00_m11++` and `--m._m00_m11`.
void HlslLowering::LowerSwizzleStep(const HlslNode& node)
{
    const HlslNode& target = *node.child;
    const std::string_view mark = Text(node.token);
    if ((mark != "++" && mark != "--") || !isOfElements(target))
    {
        return;
    }
    const std::string_view word = Text(target.token);
    const std::string type = target.type.Spelling();
    const bool isBefore = node.kind == HlslNodeKind::Prefix;
    const std::string function = std::string(mark == "++" ? "limn_raise" : "limn_lower") +
                                 (isBefore ? "_first" : "") + std::string(word);
    Need(type + " " + function + "(inout " + target.child->type.Spelling() + " m) { " + type +
         " v = " + ReadElements(target.type, "m", word) + ", r = v " + std::string(mark.substr(1)) +
         " 1; " + WriteElements("m", word, "r") + "return " + (isBefore ? "r" : "v") + "; } ");
    m_Code.Erase(target.token - 1, target.end);
    m_Code.Erase(node.token, node.token + 1);
    Wrap(*target.child, function + "(", ")");
}

/// Returns whether glslang makes invalid SPIR-V of this argument of an out or inout parameter.
bool HlslLowering::IsHandedWrong(const HlslNode& argument, const HlslVariable& parameter) const
{
    const HlslType wanted = TypeOf(m_Globals.declarations(), parameter);
    const HlslType& given = argument.type;
    const bool isConverted = parameter.isOutput() && wanted.isNumber() && given.isNumber() &&
                             wanted.rows == given.rows && wanted.columns == given.columns &&
                             wanted.Spelling() != given.Spelling();
    return isConverted || (parameter.isOutput() && isOfElements(argument));
}

/// The language converts what a function changes, and converts it back: a function of its own calls
/// the author's with copies.
void HlslLowering::LowerOutputs(HlslNode& node)
{
    const HlslFunction& function = *node.function;
    CallWithCopies call;
    std::size_t index = 0;
    for (HlslNode* argument = node.child; argument; argument = argument->next, ++index)
    {
        const HlslVariable& parameter = function.parameters[index];
        const bool isCopied = IsHandedWrong(*argument, parameter);
        if (isCopied)
        {
            call.AddCopy(*argument, parameter, Text(argument->token));
        }
        else
        {
            call.Add(parameter);
        }
        if (isCopied && isOfElements(*argument))
        {
            m_Code.Erase(argument->token - 1, argument->end);
        }
    }
    if (!call.before.empty())
    {
        const std::string name = "limn_call" + std::to_string(node.token);
        m_Code.Insert(function.end - 1, call.Write(function, name, m_Code.Spelling(node.token)));
        m_Code.Spelling(node.token) = name;
    }
}

} // namespace limn
