#include "hlsl/Globals.h"

#include <algorithm>
#include <optional>

namespace limn
{

namespace
{

/// Returns the distance of a type from the wanted one, the least for the best, or nothing if it
/// cannot be converted.
std::optional<int> Distance(const HlslType& from, const HlslType& to)
{
    constexpr int k_Truncation = 1000;
    constexpr int k_OtherSize = 100;
    if (from.kind == to.kind && from.dimensions == to.dimensions &&
        (from == to || from.kind == HlslType::Kind::Object))
    {
        return 0; // which textures and samplers fit is not told apart
    }
    const bool isSpread = from.isScalar() && to.isNumber();
    if (!isSpread && (!from.isNumber() || !to.isNumber() || from.components() < to.components()))
    {
        return std::nullopt;
    }
    int distance = from.scalar == to.scalar                                          ? 0
                   : from.isFloating() && to.isFloating() && from.scalar < to.scalar ? 1
                   : from.isFloating() == to.isFloating()                            ? 2
                                                                                     : 4;
    const bool isSameSize = from.rows == to.rows && from.columns == to.columns;
    if (!isSameSize)
    {
        distance += from.components() > to.components() ? k_Truncation : k_OtherSize;
    }
    return distance;
}

/// half counting as float.
bool hasSameParameters(const HlslFunction& a, const HlslFunction& b)
{
    const auto isSame = [](const HlslVariable& left, const HlslVariable& right)
    {
        return left.dimensions.size() == right.dimensions.size() &&
               isSameType(left.type, right.type);
    };
    return std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(),
                      b.parameters.end(), isSame);
}

/// Returns whether a call may have this number of arguments. Omitted parameters have default
/// values.
bool takes(const HlslFunction& function, std::size_t arguments)
{
    return arguments <= function.parameters.size() &&
           std::ranges::all_of(std::span(function.parameters).subspan(arguments),
                               [](const HlslVariable& parameter)
                               { return parameter.valueToken > 0; });
}

/// Returns the distance of all arguments, or nothing if one cannot be converted. Unknown types do
/// not count.
std::optional<int> DistanceOf(const HlslDeclarations& declarations, const HlslFunction& function,
                              std::span<const HlslType> arguments)
{
    int sum = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i)
    {
        const HlslType wanted = TypeOf(declarations, function.parameters[i]);
        const bool isKnown =
            arguments[i].kind != HlslType::Kind::Unknown && wanted.kind != HlslType::Kind::Unknown;
        const std::optional<int> distance =
            isKnown ? Distance(arguments[i], wanted) : std::optional(0);
        if (!distance)
        {
            return std::nullopt;
        }
        sum += *distance;
    }
    return sum;
}

} // namespace

HlslGlobals::HlslGlobals(const HlslDeclarations& declarations) : m_Declarations(declarations)
{
    for (const auto* list : {&declarations.uniforms, &declarations.objects, &declarations.statics})
    {
        for (const HlslVariable& variable : *list)
        {
            m_Variables[variable.name] = &variable;
        }
    }
    for (const HlslFunction& function : declarations.functions)
    {
        m_Functions[function.name].push_back(&function);
    }
    for (const HlslStruct& type : declarations.structs)
    {
        for (const HlslFunction& method : type.methods)
        {
            m_Methods[method.name].push_back(&method);
        }
    }
    for (const auto& [name, overloads] : m_Functions)
    {
        if (overloads.size() > 1)
        {
            TellHalfApart(overloads);
        }
    }
}

void HlslGlobals::TellHalfApart(std::span<const HlslFunction* const> overloads)
{
    const auto halves = [](const HlslFunction& function)
    {
        std::string text;
        for (const HlslVariable& parameter : function.parameters)
        {
            const auto type = NumberType(parameter.type);
            text += type && type->scalar == HlslScalar::Half ? 'h' : 'f';
        }
        return text;
    };
    for (const HlslFunction* function : overloads)
    {
        const std::string own = halves(*function);
        const auto isOther = [&](const HlslFunction* other)
        {
            return halves(*other) != own && hasSameParameters(*function, *other) &&
                   std::ranges::count(halves(*other), 'h') < std::ranges::count(own, 'h');
        };
        if (std::ranges::any_of(overloads, isOther))
        {
            m_Spellings[function] = "limn_" + own + "_" + std::string(function->name);
        }
    }
}

const std::string* HlslGlobals::FindSpelling(const HlslFunction& function) const
{
    const auto found = m_Spellings.find(&function);
    return found == m_Spellings.end() ? nullptr : &found->second;
}

const HlslVariable* HlslGlobals::FindVariable(std::string_view name) const
{
    const auto found = m_Variables.find(name);
    return found == m_Variables.end() ? nullptr : found->second;
}

bool HlslGlobals::isUniform(const HlslVariable* variable) const
{
    const std::vector<HlslVariable>& uniforms = m_Declarations.uniforms;
    return variable && !uniforms.empty() && variable >= uniforms.data() &&
           variable < uniforms.data() + uniforms.size();
}

std::span<const HlslFunction* const> HlslGlobals::FindFunctions(std::string_view name) const
{
    const auto found = m_Functions.find(name);
    return found == m_Functions.end() ? std::span<const HlslFunction* const>() : found->second;
}

std::span<const HlslFunction* const> HlslGlobals::FindMethods(std::string_view name) const
{
    const auto found = m_Methods.find(name);
    return found == m_Methods.end() ? std::span<const HlslFunction* const>() : found->second;
}

std::vector<const HlslFunction*> HlslGlobals::FindCalled(const HlslNode& node,
                                                         std::string_view name) const
{
    const bool isMethod = node.kind == HlslNodeKind::Method;
    const bool isOfStruct = isMethod && node.child->type.kind == HlslType::Kind::Struct;
    std::vector<const HlslFunction*> called;
    if (const auto* type = isOfStruct ? m_Declarations.FindStruct(node.child->type.name) : nullptr)
    {
        for (const HlslFunction& method : type->methods)
        {
            if (method.name == name)
            {
                called.push_back(&method);
            }
        }
        return called;
    }
    const auto functions = isMethod ? std::span<const HlslFunction* const>() : FindFunctions(name);
    const auto all = functions.empty() ? FindMethods(name) : functions;
    return {all.begin(), all.end()};
}

const HlslFunction* ChooseOverload(const HlslDeclarations& declarations,
                                   std::span<const HlslFunction* const> overloads,
                                   std::span<const HlslType> arguments)
{
    const HlslFunction* best = nullptr;
    int least = 0;
    bool isTie = false;
    for (const HlslFunction* function : overloads)
    {
        if (!takes(*function, arguments.size()))
        {
            continue;
        }
        const std::optional<int> sum = DistanceOf(declarations, *function, arguments);
        const bool isSame = best && sum && *sum == least;
        isTie = isSame ? isTie || best->hasBody == function->hasBody : isTie;
        if (sum && (!best || *sum < least || (isSame && function->hasBody)))
        {
            isTie = isTie && isSame;
            best = function;
            least = *sum;
        }
    }
    return isTie ? nullptr : best;
}

bool TakesNone(const HlslDeclarations& declarations, std::span<const HlslFunction* const> overloads,
               std::span<const HlslType> arguments)
{
    return std::ranges::none_of(arguments, [](const HlslType& type)
                                { return type.kind == HlslType::Kind::Unknown; }) &&
           std::ranges::none_of(overloads,
                                [&](const HlslFunction* function) {
                                    return takes(*function, arguments.size()) &&
                                           DistanceOf(declarations, *function, arguments);
                                });
}

ReachableFunctions::ReachableFunctions(const HlslTokens& tokens, const HlslGlobals& globals,
                                       std::string_view entry)
    : m_Tokens(tokens), m_IsLeftOut(tokens.size(), false)
{
    for (const HlslFunction& function : globals.declarations().functions)
    {
        Mark(function, true);
    }
    std::vector<std::string_view> pending = {entry};
    const auto addWords = [&](std::size_t first, std::size_t end)
    {
        for (; first < end; ++first)
        {
            if (tokens.isWord(first) && !m_IsLeftOut[first])
            {
                pending.push_back(tokens.Text(first));
            }
        }
    };
    addWords(0, tokens.size());
    while (!pending.empty())
    {
        const auto functions = globals.FindFunctions(pending.back());
        pending.pop_back();
        for (const HlslFunction* function : functions)
        {
            if (m_Functions.insert(function).second)
            {
                Mark(*function, false);
                addWords(function->begin, function->end);
            }
        }
    }
}

void ReachableFunctions::Mark(const HlslFunction& function, bool isLeftOut)
{
    std::fill(m_IsLeftOut.begin() + static_cast<std::ptrdiff_t>(function.begin),
              m_IsLeftOut.begin() + static_cast<std::ptrdiff_t>(function.end), isLeftOut);
}

bool ReachableFunctions::Names(std::string_view word) const
{
    const auto names = [&](const HlslFunction* function)
    {
        const auto tokens = std::span(m_Tokens.all()).subspan(function->begin);
        return std::ranges::any_of(tokens.first(function->end - function->begin),
                                   [&](const HlslToken& token) { return token.text == word; });
    };
    return std::ranges::any_of(m_Functions, names);
}

} // namespace limn
