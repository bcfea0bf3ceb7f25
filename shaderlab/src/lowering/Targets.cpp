#include "lowering/Lowering.h"

// The targets of writes: values that are changed in place, or passed to a function that gives them
// back.

namespace limn
{

namespace
{

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

/// `float2(m._m00, m._m11)`.
std::string ReadElements(const HlslType& type, const std::string& matrix, std::string_view word)
{
    std::string text = type.Spelling() + "(";
    ForEachElement(word, [&](std::size_t index, const std::string& element)
                   { text += (index > 0 ? ", " : "") + matrix + "." + element; });
    return text + ")";
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

std::string TypeText(std::string_view type, std::string_view argument)
{
    return std::string(type) + (argument.empty() ? "" : "<" + std::string(argument) + ">");
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
        AddParameter(parameter, TypeText(parameter.type, parameter.templateArgument), name, name);
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
        AddParameter(parameter, (isElements ? argument.child->type : argument.type).Spelling(),
                     name, copy);
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
    void AddParameter(const HlslVariable& parameter, const std::string& type,
                      const std::string& name, const std::string& argument)
    {
        const std::string comma = count++ > 0 ? ", " : "";
        parameters += comma + (parameter.isOutput() ? "inout " : "") + type + " " + name;
        for (const std::string_view dimension : parameter.dimensions)
        {
            parameters.append("[").append(dimension).append("]");
        }
        arguments += comma + argument;
    }
};

} // namespace

/// Returns whether computing the expression may change something, so that it must be computed once.
bool HlslLowering::HasEffects(const HlslNode& node) const
{
    const auto hasEffect = [&](const HlslNode& part)
    {
        const std::string_view text = Text(part.token);
        return part.kind == HlslNodeKind::Assign || part.kind == HlslNodeKind::Unknown ||
               part.kind == HlslNodeKind::Postfix || part.function ||
               (part.kind == HlslNodeKind::Prefix && (text == "++" || text == "--"));
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
    const std::string_view text = Text(parent->token);
    const bool isStep = text == "++" || text == "--";
    return parent->child == child &&
           (parent->kind == HlslNodeKind::Assign || parent->kind == HlslNodeKind::Postfix ||
            (parent->kind == HlslNodeKind::Prefix && isStep));
}

/// glslang makes invalid SPIR-V of `a &= b` where they are true or false, not of `a = a & b`.
void HlslLowering::LowerTruthAssignment(const HlslNode& node)
{
    const std::string_view mark = Text(node.token);
    const HlslType& type = node.child->type;
    if ((mark != "&=" && mark != "|=" && mark != "^=") || type.scalar != HlslScalar::Bool ||
        !type.isNumber())
    {
        return;
    }
    const std::string op(mark.substr(0, 1));
    const std::string name = type.Spelling();
    Cast(*node.child->next, type);
    if (HasEffects(*node.child))
    {
        const std::string function = op == "&" ? "limn_and" : op == "|" ? "limn_or" : "limn_xor";
        Need(name + " " + function + "(inout " + name + " a, " + name + " b) { a = a " + op +
             " b; return a; } ");
        m_Code.Spelling(node.token) = ",";
        Wrap(node, function + "(", ")");
        return;
    }
    const std::string target = m_Code.Spelled(node.child->first, node.child->end);
    m_Code.Spelling(node.token) = "= " + target + " " + op + " ";
}

/// An integer that is changed by a number of a wider kind: the language computes with that kind;
/// glslang makes an integer of the number first.
void HlslLowering::LowerIntegerAssignment(const HlslNode& node)
{
    const std::string_view mark = Text(node.token);
    const HlslType& type = node.child->type;
    const HlslType& given = node.last->type;
    const bool isInteger = type.scalar == HlslScalar::Int || type.scalar == HlslScalar::Uint;
    const bool isDivision = mark == "/=" || mark == "%=";
    const bool isOther = given.isFloating() || (isDivision && given.scalar == HlslScalar::Uint &&
                                                type.scalar == HlslScalar::Int);
    if ((mark != "+=" && mark != "-=" && mark != "*=" && !isDivision) || !type.isNumber() ||
        type.isMatrix() || !isInteger || !given.isNumber() || given.isMatrix() || !isOther)
    {
        return;
    }
    const std::string op(mark.substr(0, 1));
    const std::string name = type.Spelling();
    if (HasEffects(*node.child))
    {
        const std::string function = "limn_change_" + std::to_string(static_cast<int>(op[0]));
        Need(name + " " + function + "(inout " + name + " a, " + given.Spelling() + " b) { a = (" +
             name + ")(a " + op + " b); return a; } ");
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
    if (node.kind != HlslNodeKind::Assign || !isOfElements(target))
    {
        return;
    }
    const std::string op(mark.substr(0, mark.size() - 1));
    const HlslType& given = node.last->type;
    if (given.isNumber() && (HasEffects(*target.child) || HasIndex(*target.child)))
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
