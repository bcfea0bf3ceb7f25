#include "StageLinkage.h"

#include <algorithm>

namespace limn
{

namespace
{

// Locations are the same in every shader, so that one vertex layout serves all of them.
constexpr std::string_view k_FixedInputs[] = {
    "POSITION",  "NORMAL",    "TANGENT",      "COLOR",       "TEXCOORD0",
    "TEXCOORD1", "TEXCOORD2", "TEXCOORD3",    "TEXCOORD4",   "TEXCOORD5",
    "TEXCOORD6", "TEXCOORD7", "BLENDWEIGHTS", "BLENDINDICES"};

UniformType TypeOf(const std::string& scalar)
{
    return scalar == "float" ? UniformType::Float
           : scalar == "int" ? UniformType::Int
                             : UniformType::UInt;
}

/// A semantic may be used once per border.
template <typename T>
void RequireNew(const std::vector<T>& values, const std::string& semantic)
{
    const bool isKnown = std::any_of(values.begin(), values.end(),
                                     [&](const T& value) { return value.semantic == semantic; });
    if (isKnown)
    {
        throw StageInterfaceError{"semantic '" + semantic +
                                  "' is given to two values; each needs its own"};
    }
}

void CollectVertexInputs(const StageInterface& vertex, StageLinkage& linkage)
{
    auto next = static_cast<std::uint32_t>(std::size(k_FixedInputs));
    for (const StageValue& value : vertex.inputs)
    {
        if (value.isSystemValue)
        {
            continue;
        }
        const std::string semantic = value.semanticName();
        RequireNew(linkage.vertexInputs, semantic);
        const auto fixed = std::find(std::begin(k_FixedInputs), std::end(k_FixedInputs), semantic);
        const std::uint32_t location =
            fixed == std::end(k_FixedInputs)
                ? next++
                : static_cast<std::uint32_t>(fixed - std::begin(k_FixedInputs));
        linkage.vertexInputs.push_back(
            {semantic, location, TypeOf(value.scalar), value.components});
    }
}

void CollectVaryings(const StageInterface& vertex, StageLinkage& linkage)
{
    for (const StageValue& value : vertex.outputs)
    {
        if (!value.isSystemValue)
        {
            RequireNew(linkage.varyings, value.semanticName());
            const int location = static_cast<int>(linkage.varyings.size());
            linkage.varyings.push_back({value.semanticName(),
                                        value.scalar == "bool" ? "uint" : value.scalar,
                                        value.components, location});
        }
    }
}

void MatchFragmentInputs(const StageInterface& fragment, StageLinkage& linkage)
{
    for (const StageValue& value : fragment.inputs)
    {
        if (value.isSystemValue)
        {
            continue;
        }
        const std::string semantic = value.semanticName();
        const auto varying =
            std::find_if(linkage.varyings.begin(), linkage.varyings.end(),
                         [&](const Varying& candidate) { return candidate.semantic == semantic; });
        if (varying == linkage.varyings.end())
        {
            linkage.unwritten.push_back(semantic);
            continue;
        }
        varying->components = std::max(varying->components, value.components);
    }
}

int CountColorOutputs(const StageInterface& fragment)
{
    int count = 0;
    for (const StageValue& value : fragment.outputs)
    {
        count = value.semantic == "SV_TARGET" ? std::max(count, value.index + 1) : count;
    }
    return count;
}

} // namespace

StageLinkage LinkStages(const StageInterface& vertex, const StageInterface& fragment)
{
    StageLinkage linkage;
    CollectVertexInputs(vertex, linkage);
    CollectVaryings(vertex, linkage);
    MatchFragmentInputs(fragment, linkage);
    linkage.colorOutputs = CountColorOutputs(fragment);
    return linkage;
}

} // namespace limn
