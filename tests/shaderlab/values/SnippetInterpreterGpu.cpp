#include "values/SnippetArithmetic.h"

#include <numeric>
#include <utility>

// What a snippet's values are, worked out statement by statement.

namespace limn::test::snippets
{

namespace
{

/// Where the letters of a swizzle are.
Numbers Letters(const Type& type, const std::string& text)
{
    Numbers offsets;
    if (!type.isMatrix())
    {
        for (const char letter : text)
        {
            const std::size_t place = std::string("xyzwrgba").find(letter);
            offsets.push_back(static_cast<double>(place % 4));
        }
        return offsets;
    }
    const bool isFromZero = text[1] == 'm';
    for (std::size_t i = isFromZero ? 2 : 1; i < text.size(); i += isFromZero ? 4 : 3)
    {
        const int base = isFromZero ? '0' : '1';
        offsets.push_back((text[i] - base) * type.columns + text[i + 1] - base);
    }
    return offsets;
}

/// Numbers of a variable, which are read and written.
struct Place
{
    Numbers* numbers = nullptr;
    std::vector<std::size_t> at;

    Numbers Read() const
    {
        Numbers result;
        for (const std::size_t index : at)
        {
            result.push_back(numbers->at(index));
        }
        return result;
    }
    void Write(const Numbers& values) const
    {
        for (std::size_t i = 0; i < at.size(); ++i)
        {
            numbers->at(at[i]) = values.at(i);
        }
    }
};

enum class Flow : std::uint8_t
{
    Next,
    Break,
    Continue,
    Return,
};

using Frame = std::map<std::string, Numbers>;

class Interpreter
{
public:
    Numbers Run(const Snippet& snippet, const Input& input)
    {
        for (const Node& global : snippet.globals)
        {
            m_Globals[global.text] = ConvertedTo(global.type, global.children[0]);
        }
        m_Frame["a"] = input.floats;
        m_Frame["n"] = input.integers;
        for (const Node& statement : snippet.body.children)
        {
            Execute(statement);
        }
        Numbers results;
        for (const Variable& result : snippet.results)
        {
            const Numbers& numbers = *Find(result.name);
            results.insert(results.end(), numbers.begin(), numbers.end());
        }
        return results;
    }

private:
    Numbers* Find(const std::string& name)
    {
        const auto found = m_Frame.find(name);
        return found != m_Frame.end() ? &found->second : &m_Globals.at(name);
    }

    Numbers ConvertedTo(const Type& type, const Node& node)
    {
        const Numbers given = Evaluate(node);
        return node.type == type ? given : Convert(node.type, type, given);
    }

    bool isTrue(const Node& node) { return Evaluate(node)[0] != 0.0; }

    /// What a member, an index or a swizzle picks of the numbers before it.
    std::vector<std::size_t> Picked(const Node& node)
    {
        const Type& type = node.children[0].type;
        std::size_t begin = 0;
        std::vector<std::size_t> picked(node.type.Parts().size());
        if (node.kind == Kind::Swizzle)
        {
            const Numbers letters = Letters(type, node.text);
            picked.assign(letters.begin(), letters.end());
            return picked;
        }
        if (node.kind == Kind::Index)
        {
            const double index = Evaluate(node.children[1])[0];
            if (index < 0.0 || (index + 1.0) * static_cast<double>(picked.size()) >
                                   static_cast<double>(type.Parts().size()))
            {
                throw Unfit();
            }
            begin = static_cast<std::size_t>(index) * picked.size();
        }
        for (std::size_t i = 0; node.kind == Kind::Member; ++i)
        {
            const Variable& member = type.record->members.at(i);
            if (member.name == node.text)
            {
                break;
            }
            begin += member.type.Parts().size();
        }
        std::iota(picked.begin(), picked.end(), begin);
        return picked;
    }

    Place Locate(const Node& node)
    {
        Place place;
        if (node.kind == Kind::Name)
        {
            place.numbers = Find(node.text);
            place.at.resize(place.numbers->size());
            std::iota(place.at.begin(), place.at.end(), std::size_t{0});
            return place;
        }
        const Place whole = Locate(node.children.at(0));
        place.numbers = whole.numbers;
        for (const std::size_t index : Picked(node))
        {
            place.at.push_back(whole.at.at(index));
        }
        return place;
    }

    Numbers Evaluate(const Node& node)
    {
        if (++m_Steps > 50000)
        {
            throw Unfit();
        }
        switch (node.kind)
        {
        case Kind::Number:
            return {Fit(node.type.scalar, node.number)};
        case Kind::Name:
            return *Find(node.text);
        case Kind::Member:
        case Kind::Swizzle:
        case Kind::Index:
        {
            Numbers whole = Evaluate(node.children[0]);
            return Place{&whole, Picked(node)}.Read();
        }
        case Kind::Cast:
            return Convert(node.children[0].type, node.type, Evaluate(node.children[0]));
        case Kind::Construct:
        case Kind::List:
            return Listed(node);
        case Kind::Intrinsic:
            return CallIntrinsic(node, EvaluateAll(node.children));
        case Kind::Call:
            return Call(node);
        case Kind::Ternary:
            return Choose(node);
        default:
            return Operate(node);
        }
    }

    std::vector<Numbers> EvaluateAll(const std::vector<Node>& nodes)
    {
        std::vector<Numbers> all;
        for (const Node& node : nodes)
        {
            all.push_back(Evaluate(node));
        }
        return all;
    }

    /// The numbers of a list or of a constructor, one behind the other.
    Numbers Listed(const Node& list)
    {
        const std::vector<Scalar> wanted = list.type.Parts();
        Numbers result;
        for (const Node& item : list.children)
        {
            const Numbers numbers = Evaluate(item);
            const std::vector<Scalar> given = item.type.Parts();
            for (std::size_t i = 0; i < numbers.size(); ++i)
            {
                const Scalar scalar = wanted.at(result.size());
                result.push_back(Convert(given.at(i), scalar, numbers[i]));
            }
        }
        return result;
    }

    /// HLSL works out both values, as it does of && and ||: none of them is an order to branch.
    Numbers Choose(const Node& node)
    {
        const Node& condition = node.children[0];
        const Numbers chosen =
            Convert(condition.type, node.type.Of(Scalar::Bool), Evaluate(condition));
        const Numbers first = ConvertedTo(node.type, node.children[1]);
        Numbers result = ConvertedTo(node.type, node.children[2]);
        for (std::size_t i = 0; i < result.size(); ++i)
        {
            result[i] = chosen[i] != 0.0 ? first[i] : result[i];
        }
        return result;
    }

    Numbers Step(const Node& node)
    {
        const Place place = Locate(node.children[0]);
        const Numbers before = place.Read();
        const Numbers after =
            Convert(BinaryType("+", node.type, Type{Scalar::Bool}), node.type,
                    Calculate(node.text.substr(1), node.type, before, Type{Scalar::Bool}, {1.0}));
        place.Write(after);
        return node.kind == Kind::Prefix ? after : before;
    }

    Numbers Operate(const Node& node)
    {
        const Node& first = node.children[0];
        if (node.text == "++" || node.text == "--")
        {
            return Step(node);
        }
        if (node.kind == Kind::Prefix)
        {
            Numbers result = ConvertedTo(node.type, first);
            for (double& x : result)
            {
                x = Fit(node.type.scalar, node.text == "-"   ? -x
                                          : node.text == "!" ? 1.0 - x
                                                             : -1.0 - x);
            }
            return result;
        }
        if (node.kind == Kind::Assign)
        {
            return Assign(node);
        }
        const Numbers x = Evaluate(first);
        return Calculate(node.text, first.type, x, node.children[1].type,
                         Evaluate(node.children[1]));
    }

    Numbers Assign(const Node& node)
    {
        const Node& target = node.children[0];
        const Node& source = node.children[1];
        if (node.text == "=")
        {
            const Numbers given = ConvertedTo(target.type, source);
            Locate(target).Write(given);
            return given;
        }
        const std::string op = node.text.substr(0, node.text.size() - 1);
        const Numbers given = Evaluate(source);
        const Place place = Locate(target);
        const Numbers result =
            Convert(BinaryType(op, target.type, source.type), target.type,
                    Calculate(op, target.type, place.Read(), source.type, given));
        place.Write(result);
        return result;
    }

    Numbers Call(const Node& node)
    {
        const Function& function = *node.function;
        Frame frame;
        std::map<std::size_t, Place> outputs;
        for (std::size_t i = 0; i < function.parameters.size(); ++i)
        {
            const Variable& parameter = function.parameters[i];
            const Node& argument = node.children[i];
            const bool isOutput = parameter.mode == "out" || parameter.mode == "inout";
            if (isOutput)
            {
                outputs[i] = Locate(argument);
            }
            frame[parameter.name] = parameter.mode == "out" ? Numbers(parameter.type.Parts().size())
                                    : isOutput
                                        ? Convert(argument.type, parameter.type, outputs[i].Read())
                                        : ConvertedTo(parameter.type, argument);
        }
        std::swap(frame, m_Frame);
        m_Returned.clear();
        Execute(function.body);
        std::swap(frame, m_Frame);
        for (const auto& [i, place] : outputs)
        {
            const Variable& parameter = function.parameters[i];
            place.Write(Convert(parameter.type, node.children[i].type, frame[parameter.name]));
        }
        return m_Returned;
    }

    Flow ExecuteAll(const Node& node, std::size_t first = 0)
    {
        Flow flow = Flow::Next;
        for (std::size_t i = first; i < node.children.size() && flow == Flow::Next; ++i)
        {
            flow = Execute(node.children[i]);
        }
        return flow;
    }

    Flow Loop(const Node& node)
    {
        const bool isFor = node.kind == Kind::For;
        const Node& body = node.children[isFor ? 3 : node.kind == Kind::While ? 1 : 0];
        const Node& condition = node.children[node.kind == Kind::While ? 0 : 1];
        if (isFor)
        {
            Execute(node.children[0]);
        }
        bool goesOn = node.kind == Kind::Do || isTrue(condition);
        while (goesOn)
        {
            const Flow flow = Execute(body);
            if (flow == Flow::Return)
            {
                return flow;
            }
            if (isFor && flow != Flow::Break)
            {
                Evaluate(node.children[2]);
            }
            goesOn = flow != Flow::Break && isTrue(condition);
        }
        return Flow::Next;
    }

    Flow ExecuteSwitch(const Node& node)
    {
        const double value = Evaluate(node.children[0])[0];
        for (std::size_t i = 1; i < node.children.size(); ++i)
        {
            if (node.children[i].text == "default" || node.children[i].number == value)
            {
                return ExecuteAll(node.children[i]);
            }
        }
        return Flow::Next;
    }

    Flow Execute(const Node& node)
    {
        switch (node.kind)
        {
        case Kind::Declare:
            m_Frame[node.text] = ConvertedTo(node.type, node.children[0]);
            return Flow::Next;
        case Kind::Sentence:
            Evaluate(node.children[0]);
            return Flow::Next;
        case Kind::If:
            return isTrue(node.children[0])   ? Execute(node.children[1])
                   : node.children.size() > 2 ? Execute(node.children[2])
                                              : Flow::Next;
        case Kind::For:
        case Kind::While:
        case Kind::Do:
            return Loop(node);
        case Kind::Switch:
            return ExecuteSwitch(node);
        case Kind::Break:
            return Flow::Break;
        case Kind::Continue:
            return Flow::Continue;
        case Kind::Return:
            if (!node.children.empty())
            {
                m_Returned = ConvertedTo(node.type, node.children[0]);
            }
            return Flow::Return;
        default:
            return ExecuteAll(node);
        }
    }

    Frame m_Globals;
    Frame m_Frame;
    Numbers m_Returned;
    int m_Steps = 0;
};

} // namespace

Numbers Interpret(const Snippet& snippet, const Input& input)
{
    return Interpreter().Run(snippet, input);
}

} // namespace limn::test::snippets
