#include "hlsl/rewrites/Rewrites.h"

#include "hlsl/Declarations.h"
#include "hlsl/Editor.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace limn
{

namespace
{

/// The type of which arguments are cut to `parameter`; "" where there is none.
std::string LargerType(const HlslVariable& parameter)
{
    const std::string_view type = parameter.type;
    if (!parameter.dimensions.empty() || parameter.Has("out") || parameter.Has("inout"))
    {
        return "";
    }
    if (type == "float" || type == "int" || type == "uint" || type == "bool")
    {
        return std::string(type) + "2"; // from where glslang goes on to longer vectors
    }
    const bool isMatrix = type.size() == 8 && type.starts_with("float") && type[6] == 'x';
    return isMatrix && type != "float4x4" ? "float4x4" : "";
}

/// `float f(float2 limn_0, float3 limn_1) { return f((float)limn_0, limn_1); }`
///
/// @param larger  which parameters are
std::string WriteOverload(const HlslFunction& function, const std::vector<bool>& larger)
{
    std::string parameters;
    std::string arguments;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
    {
        const HlslVariable& parameter = function.parameters[i];
        const std::string name = "limn_" + std::to_string(i);
        const std::string separator = i > 0 ? ", " : "";
        parameters += separator;
        for (const std::string_view modifier : parameter.modifiers)
        {
            parameters.append(modifier).append(" ");
        }
        parameters.append(larger[i] ? LargerType(parameter) : parameter.type);
        if (!parameter.templateArgument.empty())
        {
            parameters.append("<").append(parameter.templateArgument).append(">");
        }
        parameters += " " + name;
        for (const std::string_view size : parameter.dimensions)
        {
            parameters.append("[").append(size).append("]");
        }
        arguments += separator;
        arguments += larger[i] ? "(" + std::string(parameter.type) + ")" + name : name;
    }
    const std::string name(function.name);
    return " " + std::string(function.returnType) + " " + name + "(" + parameters + ") { " +
           (function.returnType == "void" ? "" : "return ") + name + "(" + arguments + "); }";
}

/// One overload for each choice among the parameters that have a larger type.
std::string WriteOverloads(const HlslFunction& function)
{
    constexpr std::size_t k_MostChoices = 5;
    std::vector<std::size_t> choices;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
    {
        if (!LargerType(function.parameters[i]).empty() && choices.size() < k_MostChoices)
        {
            choices.push_back(i);
        }
    }
    std::string overloads;
    for (std::size_t mask = 1; mask < std::size_t{1} << choices.size(); ++mask)
    {
        std::vector<bool> larger(function.parameters.size());
        for (std::size_t i = 0; i < choices.size(); ++i)
        {
            larger[choices[i]] = (mask >> i & 1u) != 0;
        }
        overloads += WriteOverload(function, larger);
    }
    return overloads;
}

} // namespace

std::string AddConversions(const std::string& hlsl, const std::set<std::string>& functions)
{
    HlslEditor code(hlsl);
    const HlslDeclarations declarations = ReadDeclarations(TokenizeHlsl(hlsl));
    std::set<std::pair<std::string_view, std::size_t>> known;
    for (const HlslFunction& function : declarations.functions)
    {
        // Of several overloads with as many parameters it is not ours to say which one is meant.
        const auto isSame = [&](const HlslFunction& other)
        {
            return other.hasBody && other.name == function.name &&
                   other.parameters.size() == function.parameters.size();
        };
        const auto& all = declarations.functions;
        const bool isFirst = known.insert({function.name, function.parameters.size()}).second;
        if (isFirst && functions.count(std::string(function.name)) > 0 &&
            std::count_if(all.begin(), all.end(), isSame) == 1)
        {
            code.Spelling(function.end - 1) += WriteOverloads(function);
        }
    }
    return code.Assemble();
}

} // namespace limn
