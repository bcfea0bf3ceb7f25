#include "hlsl/Undeclared.h"

#include <string>

namespace limn
{

std::vector<Diagnostic> HlslUndeclared::Describe(const HlslTokens& tokens,
                                                 const HlslDeclarations& declarations) const
{
    std::vector<std::string_view> known = {"float",  "half",     "int",     "uint",  "bool",
                                           "float2", "float3",   "float4",  "half2", "half3",
                                           "half4",  "float3x3", "float4x4"};
    for (const HlslStruct& type : declarations.structs)
    {
        known.push_back(type.name);
    }
    std::vector<Diagnostic> diagnostics;
    const auto add = [&](std::size_t token, const std::string& problem)
    {
        const HlslPlace place = tokens.Place(token);
        diagnostics.push_back({Severity::Error, place.file, place.location,
                               "'" + std::string(tokens.Text(token)) + "': " + problem});
    };
    for (const std::size_t token : types)
    {
        const std::string_view text = tokens.Text(token);
        constexpr std::string_view k_Fixed = "fixed"; // of CG programs, where it is half
        const std::string nearest = text.starts_with(k_Fixed)
                                        ? "half" + std::string(text.substr(k_Fixed.size()))
                                        : std::string(NearestName(text, known));
        add(token,
            nearest.empty() ? "unknown type" : "unknown type; did you mean '" + nearest + "'?");
    }
    for (const auto& [token, problem] : names)
    {
        add(token, std::string(problem));
    }
    return diagnostics;
}

} // namespace limn
