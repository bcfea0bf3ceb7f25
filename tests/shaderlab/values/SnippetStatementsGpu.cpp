#include "values/SnippetDraft.h"

#include <algorithm>

// Initial values and statements by chance.

namespace limn::test::snippets
{

namespace
{

std::size_t CountChildren(const Type& type)
{
    return type.sizes.empty() ? type.record->members.size()
                              : static_cast<std::size_t>(type.sizes[0]);
}

/// A list for what has this many numbers, of which brackets may stand around any.
Node List(Draft& draft, const Type& type)
{
    Node list = MakeNode(Kind::List, type, "");
    draft.depth = std::min(draft.depth, 1);
    const bool isGrouped = !type.isNumber() && draft.random.OneIn(2);
    for (std::size_t i = 0; isGrouped && i < CountChildren(type); ++i)
    {
        const Type& member = type.sizes.empty() ? type.record->members[i].type : type.Element();
        const bool isList = !member.isNumber() || draft.random.OneIn(3);
        list.children.push_back(isList ? List(draft, member) : Exact(draft, member));
    }
    const std::vector<Scalar> parts = type.Parts();
    for (std::size_t i = 0; !isGrouped && i < parts.size();)
    {
        const auto left = static_cast<int>(parts.size() - i);
        const int size = std::min(left, 1 + draft.random.Below(4));
        list.children.push_back(Exact(draft, Type().Of(parts[i]).As(size)));
        i += static_cast<std::size_t>(size);
    }
    return list;
}

const Node& RootOf(const Node& place)
{
    return place.children.empty() || place.kind == Kind::Call ? place : RootOf(place.children[0]);
}

Node Declare(Draft& draft, const Type& type, Node value)
{
    const std::string name = NewName(draft, "v");
    draft.scope.push_back({type, name, ""});
    return MakeNode(Kind::Declare, type, name, {std::move(value)});
}

/// A statement that calls a function which gives something back by its parameters.
Node CallWithOutputs(Draft& draft)
{
    const auto function = OneOf(draft, draft.snippet.functions);
    Node call = Call(draft, function);
    std::vector<std::string> roots;
    for (std::size_t i = 0; i < call.children.size(); ++i)
    {
        const Variable& parameter = function->parameters[i];
        if (parameter.mode != "out" && parameter.mode != "inout")
        {
            continue;
        }
        auto place = PlaceOf(draft, parameter.type, true, !draft.random.OneIn(4));
        const std::string root = place ? RootOf(*place).text : "";
        if (root.empty() || std::find(roots.begin(), roots.end(), root) != roots.end())
        {
            throw Unfit();
        }
        roots.push_back(root);
        call.children[i] = *place;
    }
    return function->type.columns == 0 ? MakeSentence(call) : Declare(draft, function->type, call);
}

Node Assign(Draft& draft)
{
    const Type shape = AnyNumber(draft);
    auto place = PlaceOf(draft, shape, true);
    if (!place)
    {
        const Type type = AnyType(draft);
        Node value = Initial(draft, type);
        return Declare(draft, type, std::move(value));
    }
    const Type type = place->type;
    const std::string op =
        type.scalar == Scalar::Bool ? OneOf(draft, {"=", "=", "&=", "|=", "^="})
        : isFloating(type.scalar)
            ? OneOf(draft, {"=", "=", "=", "+=", "-=", "*="})
            : OneOf(draft, {"=", "=", "+=", "-=", "*=", "&=", "|=", "^=", "<<="});
    const int form = draft.random.Below(8);
    const Scalar kind =
        op.size() > 1 && op.find_first_of("&|^<") == 0 ? type.scalar : Scalar::Float;
    Node value = op == "<<="                    ? MakeInteger(draft.random.Below(4))
                 : form == 0 && type.isVector() ? Expression(draft, type.As(1))
                 : form == 1 && type.columns == 3 && type.isVector() ? Expression(draft, type.As(4))
                                                                     : Expression(draft, type);
    if (kind == type.scalar || draft.random.OneIn(2))
    {
        value = MakeCast(value.type.Of(type.scalar), value);
    }
    return MakeSentence(MakeAssign(op, std::move(*place), std::move(value)));
}

Node Step(Draft& draft)
{
    const int columns = 1 + draft.random.Below(3);
    const Type shape = Type().As(columns).Of(draft.random.OneIn(2) ? Scalar::Int : Scalar::Float);
    auto place = PlaceOf(draft, shape, true);
    if (!place || place->type.scalar == Scalar::Bool)
    {
        throw Unfit();
    }
    const Kind kind = draft.random.OneIn(2) ? Kind::Prefix : Kind::Postfix;
    const Type type = place->type;
    Node step = MakeNode(kind, type, OneOf(draft, {"++", "--"}), {std::move(*place)});
    return draft.random.OneIn(2) ? MakeSentence(std::move(step))
                                 : Declare(draft, type, std::move(step));
}

Node Block(Draft& draft, Node first = MakeNode(Kind::Block, {}, ""))
{
    const std::vector<Variable> outer = draft.scope;
    const int statements = 1 + draft.random.Below(2);
    for (int i = 0; i < statements; ++i)
    {
        AddStatement(draft, first);
    }
    draft.scope = outer;
    return first;
}

Node If(Draft& draft)
{
    Node condition =
        draft.random.OneIn(4) ? Exact(draft, Type().Of(AnyScalar(draft))) : Truth(draft, Type());
    Node node = MakeNode(Kind::If, {}, "", {std::move(condition), Block(draft)});
    if (draft.random.OneIn(2))
    {
        node.children.push_back(Block(draft));
    }
    if (draft.returns && draft.random.OneIn(4))
    {
        draft.counts = false;
        Node& block = node.children[1];
        block.children.push_back(draft.returns->columns > 0 ? Return(draft)
                                                            : MakeNode(Kind::Return, {}, ""));
    }
    return node;
}

/// Leaves the loop or goes on with it, sometimes.
Node Jump(Draft& draft, const Variable& counter)
{
    const int limit = draft.random.Below(3);
    // lavapipe 22.3.6 runs loops wrongly that end by two conditions on one counter: what they
    // change has not changed behind them, or they run 65535 times.
    const bool isOther = draft.random.OneIn(2) || draft.isLavapipe;
    Node condition =
        isOther ? Truth(draft, Type()) : MakeBinary("==", MakeName(counter), MakeInteger(limit));
    const Kind kind = draft.random.OneIn(2) ? Kind::Break : Kind::Continue;
    Node block = MakeNode(Kind::Block, {}, "", {MakeNode(kind, {}, "")});
    return MakeNode(Kind::If, {}, "", {std::move(condition), std::move(block)});
}

Node Loop(Draft& draft)
{
    const Variable counter{Type().Of(Scalar::Int), NewName(draft, "i"), "const"};
    const bool isFor = draft.random.OneIn(2);
    const bool isDo = draft.random.OneIn(2);
    const int limit = 1 + draft.random.Below(4);
    const std::vector<Variable> outer = draft.scope;
    draft.scope.push_back(counter);
    draft.loops.push_back(counter);
    Node start = MakeNode(Kind::Declare, counter.type, counter.name, {MakeInteger(0)});
    Node step = MakeNode(draft.random.OneIn(2) ? Kind::Prefix : Kind::Postfix, counter.type, "++",
                         {MakeName(counter)});
    Node condition = MakeBinary("<", MakeName(counter), MakeInteger(limit));
    Node body = MakeNode(Kind::Block, {}, "");
    if (!isFor)
    {
        body.children.push_back(MakeSentence(step));
    }
    if (draft.random.OneIn(2))
    {
        AddStatement(draft, body);
    }
    if (draft.random.OneIn(2))
    {
        draft.counts = false;
        body.children.push_back(Jump(draft, counter));
    }
    body = Block(draft, std::move(body));
    draft.loops.pop_back();
    draft.scope = outer;
    if (isFor)
    {
        return MakeNode(Kind::For, {}, "", {start, condition, step, body});
    }
    Node loop = isDo ? MakeNode(Kind::Do, {}, "", {body, condition})
                     : MakeNode(Kind::While, {}, "", {condition, body});
    return MakeNode(Kind::Block, {}, "", {start, loop});
}

Node Switch(Draft& draft)
{
    Node value = MakeBinary("&", Exact(draft, Type().Of(Scalar::Int)), MakeInteger(3));
    Node node = MakeNode(Kind::Switch, {}, "", {std::move(value)});
    const int cases = 1 + draft.random.Below(3);
    for (int i = 0; i < cases; ++i)
    {
        Node block = Block(draft);
        block.kind = Kind::Case;
        block.text = "case " + std::to_string(i);
        block.number = i;
        node.children.push_back(std::move(block));
    }
    Node block = Block(draft);
    block.kind = Kind::Case;
    block.text = "default";
    node.children.push_back(std::move(block));
    return node;
}

Node Statement(Draft& draft)
{
    const int form = draft.random.Below(draft.nested < 2 ? 13 : 8);
    if (form < 3)
    {
        const Type type = AnyType(draft);
        Node value = Initial(draft, type);
        return Declare(draft, type, std::move(value));
    }
    ++draft.nested;
    Node node = form < 6    ? Assign(draft)
                : form == 6 ? Step(draft)
                : form == 7 ? CallWithOutputs(draft)
                : form < 10 ? If(draft)
                : form < 12 ? Loop(draft)
                            : Switch(draft);
    --draft.nested;
    return node;
}

} // namespace

Node Initial(Draft& draft, const Type& type)
{
    const int form = draft.random.Below(6);
    if (type.isNumber())
    {
        return form == 0 && !type.isScalar() ? List(draft, type)
               : form == 1 && type.isVector() && type.columns < 4
                   ? Expression(draft, type.As(type.columns + 1))
               : form == 2 && type.isVector() ? Exact(draft, type.As(1))
                                              : Expression(draft, type);
    }
    const bool isCast = form == 0 && type.sizes.empty() && !draft.isConstant;
    if (isCast)
    {
        return MakeCast(type, MakeInteger(draft.random.Below(3)));
    }
    for (const Variable& variable : draft.scope)
    {
        if (variable.type == type && form < 3 && !draft.isConstant)
        {
            return MakeName(variable);
        }
    }
    return List(draft, type);
}

Node Return(Draft& draft)
{
    Node value = Expression(draft, *draft.returns);
    return MakeNode(Kind::Return, *draft.returns, "", {std::move(value)});
}

void AddStatement(Draft& draft, Node& block)
{
    const std::vector<Variable> scope = draft.scope;
    const std::vector<Variable> loops = draft.loops;
    const int nested = draft.nested;
    draft.depth = draft.random.OneIn(4) ? 2 : 1;
    draft.counts = !draft.returns;
    try
    {
        block.children.push_back(Statement(draft));
    }
    catch (const Unfit&)
    {
        draft.scope = scope;
        draft.loops = loops;
        draft.nested = nested;
    }
}

} // namespace limn::test::snippets
