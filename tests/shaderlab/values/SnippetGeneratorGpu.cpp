#include "values/SnippetDraft.h"

#include <algorithm>

// Whole snippets by chance.

namespace limn::test::snippets
{

namespace
{

bool isFit(const Draft& draft)
{
    try
    {
        for (const Input& input : draft.inputs)
        {
            Interpret(draft.snippet, input);
        }
        return true;
    }
    catch (const Unfit&)
    {
        return false;
    }
}

void AddRecords(Draft& draft)
{
    const int records = draft.random.Below(3);
    for (int i = 0; i < records; ++i)
    {
        Record record{"S" + std::to_string(i) + draft.suffix, {}};
        const int members = 1 + draft.random.Below(3);
        for (int k = 0; k < members; ++k)
        {
            record.members.push_back({AnyType(draft), "m" + std::to_string(k), ""});
        }
        draft.snippet.records.push_back(std::make_shared<const Record>(std::move(record)));
    }
}

/// A function that gives another number each time: it shows how often it was called.
void AddCounter(Draft& draft)
{
    const Variable counter{Type().Of(Scalar::Int), "s_Count" + draft.suffix, ""};
    draft.snippet.globals.push_back(
        MakeNode(Kind::Declare, counter.type, counter.name, {MakeInteger(0)}));
    Node value = MakeNode(Kind::Postfix, counter.type, "++", {MakeName(counter)});
    Node result = MakeNode(Kind::Return, counter.type, "", {std::move(value)});
    draft.counter = std::make_shared<const Function>(Function{
        "Count" + draft.suffix, counter.type, {}, MakeNode(Kind::Block, {}, "", {result})});
    draft.snippet.functions.push_back(draft.counter);
    draft.snippet.results.push_back(counter);
}

void AddConstants(Draft& draft)
{
    const int constants = draft.random.Below(3);
    for (int i = 0; i < constants; ++i)
    {
        Variable constant{AnyType(draft), NewName(draft, "k") + draft.suffix, "const"};
        draft.isConstant = true;
        draft.depth = constant.type.isNumber() ? 2 : 0;
        Node node =
            MakeNode(Kind::Declare, constant.type, constant.name, {Initial(draft, constant.type)});
        draft.isConstant = false;
        node.number = 1.0;
        draft.snippet.globals.push_back(std::move(node));
        if (isFit(draft))
        {
            draft.scope.push_back(std::move(constant));
        }
        else
        {
            draft.snippet.globals.pop_back();
        }
    }
}

/// Whether a call may mean either of them, as kinds of numbers that are one to the compiler.
bool isClose(const Function& a, const Function& b)
{
    bool isClose = a.name == b.name && a.parameters.size() == b.parameters.size();
    for (std::size_t i = 0; isClose && i < a.parameters.size(); ++i)
    {
        const Type& x = a.parameters[i].type;
        const Type& y = b.parameters[i].type;
        isClose = x.record == y.record && x.rows == y.rows && x.columns == y.columns &&
                  x.sizes == y.sizes && isFloating(x.scalar) == isFloating(y.scalar);
    }
    return isClose;
}

void AddFunction(Draft& draft)
{
    draft.depth = 1;
    Function function;
    const bool isOverload = draft.snippet.functions.size() > 1 && draft.random.OneIn(2);
    function.name =
        isOverload ? draft.snippet.functions.back()->name : NewName(draft, "F") + draft.suffix;
    function.type = AnyNumber(draft);
    if (draft.random.OneIn(6))
    {
        function.type.columns = 0;
        function.type.rows = 0;
    }
    const int parameters = 1 + draft.random.Below(3);
    Node body = MakeNode(Kind::Block, {}, "");
    for (int i = 0; i < parameters; ++i)
    {
        const std::string mode = OneOf(draft, {"", "", "in", "out", "inout"});
        const bool isInput = mode.size() < 3;
        function.parameters.push_back(
            {isInput ? AnyType(draft) : AnyNumber(draft), NewName(draft, "p"), mode});
    }
    for (const Variable& parameter : function.parameters)
    {
        if (parameter.mode == "out")
        {
            Node value = Exact(draft, parameter.type);
            body.children.push_back(
                MakeSentence(MakeAssign("=", MakeName(parameter), std::move(value))));
        }
        draft.scope.push_back({parameter.type, parameter.name, ""});
    }
    draft.returns = function.type;
    const int statements = 1 + draft.random.Below(3);
    for (int i = 0; i < statements; ++i)
    {
        AddStatement(draft, body);
    }
    if (function.type.columns > 0)
    {
        body.children.push_back(Return(draft));
    }
    function.body = std::move(body);
    const bool isNew = std::none_of(draft.snippet.functions.begin(), draft.snippet.functions.end(),
                                    [&](const auto& other) { return isClose(*other, function); });
    if (isNew)
    {
        draft.snippet.functions.push_back(std::make_shared<const Function>(std::move(function)));
    }
}

/// Adds a statement to the snippet for which all its values are fit, if a few tries find one.
void AddFitting(Draft& draft)
{
    const std::vector<Variable> scope = draft.scope;
    const std::vector<Variable> results = draft.snippet.results;
    for (int i = 0; i < 10; ++i)
    {
        const std::size_t before = draft.snippet.body.children.size();
        AddStatement(draft, draft.snippet.body);
        draft.snippet.results.insert(
            draft.snippet.results.end(),
            draft.scope.begin() + static_cast<std::ptrdiff_t>(scope.size()), draft.scope.end());
        if (draft.snippet.body.children.size() > before && isFit(draft))
        {
            return;
        }
        draft.snippet.body.children.resize(before);
        draft.snippet.results = results;
        draft.scope = scope;
    }
}

} // namespace

Snippet Generate(std::uint64_t seed, const std::vector<Input>& inputs, bool isLavapipe)
{
    Draft draft{Random(seed), inputs, isLavapipe, "_" + std::to_string(seed)};
    draft.snippet.name = "Snippet" + draft.suffix;
    AddRecords(draft);
    AddCounter(draft);
    AddConstants(draft);
    const int functions = draft.random.Below(3);
    for (int i = 0; i < functions; ++i)
    {
        const std::vector<Variable> outer = draft.scope;
        try
        {
            AddFunction(draft);
        }
        catch (const Unfit&)
        {
        }
        draft.returns.reset();
        draft.scope = outer;
    }
    draft.scope.push_back({Type().As(4), "a", "const"});
    draft.scope.push_back({Type().As(4).Of(Scalar::Int), "n", "const"});
    const int statements = 4 + draft.random.Below(4);
    draft.counts = true;
    for (int i = 0; i < statements; ++i)
    {
        AddFitting(draft);
    }
    return draft.snippet;
}

} // namespace limn::test::snippets
