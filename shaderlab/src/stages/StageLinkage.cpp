#include "stages/StageLinkage.h"

#include <algorithm>
#include <set>

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
/// @param known  the semantics of the border's other values
void AddSemantic(const StageInterface& interface, const StageValue& value,
                 std::set<std::string>& known)
{
    if (!known.insert(value.semanticName()).second)
    {
        throw StageInterfaceError{"semantic '" + value.semanticName() +
                                      "' is given to two values; each needs its own",
                                  value.token, interface.function};
    }
}

void CollectVertexInputs(const StageInterface& vertex, StageLinkage& linkage)
{
    auto next = static_cast<std::uint32_t>(std::size(k_FixedInputs));
    std::set<std::string> semantics;
    for (const StageValue& value : vertex.inputs)
    {
        if (value.isSystemValue)
        {
            continue;
        }
        const std::string semantic = value.semanticName();
        AddSemantic(vertex, value, semantics);
        const auto* const fixed = std::ranges::find(k_FixedInputs, semantic);
        const std::uint32_t location =
            fixed == std::end(k_FixedInputs)
                ? next++
                : static_cast<std::uint32_t>(fixed - std::begin(k_FixedInputs));
        linkage.vertexInputs.push_back(
            {semantic, location, TypeOf(value.scalar), value.components});
    }
}

void CollectVaryings(const StageInterface& writer, StageBorder& border)
{
    std::set<std::string> semantics;
    for (const StageValue& value : writer.outputs)
    {
        if (!value.isSystemValue)
        {
            AddSemantic(writer, value, semantics);
            const int location = static_cast<int>(border.varyings.size());
            border.varyings.push_back({value.semanticName(),
                                       value.scalar == "bool" ? "uint" : value.scalar,
                                       value.components, location});
        }
    }
}

void MatchInputs(const StageInterface& reader, StageBorder& border)
{
    for (const StageValue& value : reader.inputs)
    {
        if (value.isSystemValue)
        {
            continue;
        }
        const std::string semantic = value.semanticName();
        const auto varying = std::ranges::find(border.varyings, semantic, &Varying::semantic);
        if (varying == border.varyings.end())
        {
            border.unwritten.push_back(semantic);
            continue;
        }
        varying->components = std::max(varying->components, value.components);
    }
}

StageBorder LinkBorder(const StageInterface& writer, const StageInterface& reader)
{
    StageBorder border;
    CollectVaryings(writer, border);
    MatchInputs(reader, border);
    return border;
}

int CountColorOutputs(const StageInterface& fragment)
{
    int count = 0;
    std::set<std::string> semantics;
    for (const StageValue& value : fragment.outputs)
    {
        AddSemantic(fragment, value, semantics);
        count = value.semantic == "SV_TARGET" ? std::max(count, value.index + 1) : count;
    }
    return count;
}

} // namespace

const Varying& StageBorder::Find(const std::string& semantic) const
{
    return *std::ranges::find(varyings, semantic, &Varying::semantic);
}

const StageBorder& StageLinkage::Before(ShaderStage stage) const
{
    return stage == ShaderStage::Geometry ? behindVertex : beforeFragment;
}

const StageBorder& StageLinkage::Behind(ShaderStage stage) const
{
    return stage == ShaderStage::Vertex ? behindVertex : beforeFragment;
}

StageLinkage LinkStages(const StageInterface& vertex, const StageInterface* geometry,
                        const StageInterface& fragment)
{
    StageLinkage linkage;
    CollectVertexInputs(vertex, linkage);
    linkage.behindVertex = LinkBorder(vertex, geometry ? *geometry : fragment);
    linkage.beforeFragment = geometry ? LinkBorder(*geometry, fragment) : linkage.behindVertex;
    linkage.colorOutputs = CountColorOutputs(fragment);
    return linkage;
}

} // namespace limn
