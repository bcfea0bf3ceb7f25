#include "parser/Parser.h"

#include <limn/base/Text.h>

#include <algorithm>

namespace limn
{

namespace
{

template <typename Table>
bool Knows(const Table& table, std::string_view word)
{
    return std::ranges::any_of(table, [&](const auto& command)
                               { return EqualsIgnoringCase(command.name, word); });
}

} // namespace

const Parser::CommandTable& Parser::ShaderCommands()
{
    static const CommandTable table = {
        {"Properties", &Parser::ParseProperties},
        {"SubShader", &Parser::ParseSubShader},
        {"Category", &Parser::ParseCategory},
        {"Fallback", &Parser::ParseFallback},
        {"CustomEditor", &Parser::ParseCustomEditor},
        {"CustomEditorForRenderPipeline", &Parser::ParsePipelineEditor},
        {"Dependency", &Parser::ParseDependency},
        {"HLSLINCLUDE", &Parser::ParseIncludeBlock, true},
        {"CGINCLUDE", &Parser::ParseIncludeBlock, true},
        {"GLSLINCLUDE", &Parser::ParseIncludeBlock, true},
    };
    return table;
}

const Parser::CommandTable& Parser::CategoryCommands()
{
    static const CommandTable table = WithCommonCommands({
        {"SubShader", &Parser::ParseSubShader},
        {"Category", &Parser::ParseCategory},
        {"Tags", &Parser::ParseTags},
        {"LOD", &Parser::ParseLod},
        {"Fallback", &Parser::ParseFallback},
        {"CustomEditor", &Parser::ParseCustomEditor},
        {"CustomEditorForRenderPipeline", &Parser::ParsePipelineEditor},
        {"Dependency", &Parser::ParseDependency},
    });
    return table;
}

const Parser::CommandTable& Parser::SubShaderCommands()
{
    static const CommandTable table = WithCommonCommands({
        {"Pass", &Parser::ParsePass},
        {"Tags", &Parser::ParseTags},
        {"LOD", &Parser::ParseLod},
        {"Name", &Parser::ParseIgnoredName},
        {"UsePass", &Parser::ParseUsePass},
        {"GrabPass", &Parser::ParseGrabPass},
        {"PackageRequirements", &Parser::ParsePackageRequirements},
        {"HLSLPROGRAM", &Parser::ParseSurface, true},
        {"CGPROGRAM", &Parser::ParseSurface, true},
        {"GLSLPROGRAM", &Parser::ParseSurface, true},
    });
    return table;
}

const Parser::CommandTable& Parser::PassCommands()
{
    static const CommandTable table = WithCommonCommands({
        {"Name", &Parser::ParseName},
        {"Tags", &Parser::ParseTags},
        {"LOD", &Parser::ParseLod},
        {"PackageRequirements", &Parser::ParsePackageRequirements},
        {"HLSLPROGRAM", &Parser::ParseProgram, true},
        {"CGPROGRAM", &Parser::ParseProgram, true},
        {"GLSLPROGRAM", &Parser::ParseProgram, true},
        {"SetTexture", &Parser::ParseSetTexture},
    });
    return table;
}

/// State, legacy state and include blocks may stand in every scope from Category to Pass.
Parser::CommandTable Parser::WithCommonCommands(CommandTable table)
{
    const CommandTable common = {
        {"Cull", &Parser::ParseState<CullMode, &RenderState::cull, k_CullModes>},
        {"ZTest", &Parser::ParseState<CompareFunction, &RenderState::zTest, k_DepthTests>},
        {"ZWrite", &Parser::ParseState<bool, &RenderState::zWrite, k_Bools>},
        {"ZClip", &Parser::ParseState<bool, &RenderState::zClip, k_Bools>},
        {"Offset", &Parser::ParseOffset},
        {"Blend", &Parser::ParseBlend},
        {"BlendOp", &Parser::ParseBlendOp},
        {"ColorMask", &Parser::ParseColorMask},
        {"AlphaToMask", &Parser::ParseState<bool, &RenderState::alphaToMask, k_Bools>},
        {"Conservative", &Parser::ParseState<bool, &RenderState::conservative, k_Bools>},
        {"Stencil", &Parser::ParseStencil},
        {"Lighting", &Parser::ParseLegacySwitch},
        {"SeparateSpecular", &Parser::ParseLegacySwitch},
        {"ColorMaterial", &Parser::ParseColorMaterial},
        {"Color", &Parser::ParseLegacyColor},
        {"Material", &Parser::ParseLegacyBlock},
        {"Fog", &Parser::ParseLegacyBlock},
        {"AlphaTest", &Parser::ParseAlphaTest},
        {"BindChannels", &Parser::ParseLegacyBlock},
        {"HLSLINCLUDE", &Parser::ParseIncludeBlock, true},
        {"CGINCLUDE", &Parser::ParseIncludeBlock, true},
        {"GLSLINCLUDE", &Parser::ParseIncludeBlock, true},
    };
    table.insert(table.end(), common.begin(), common.end());
    return table;
}

/// Returns the place of a command that the current scope does not know, "" if there is no such
/// command.
std::string_view Parser::PlaceOf(std::string_view word) const
{
    return Knows(PassCommands(), word)        ? "a Pass"
           : Knows(SubShaderCommands(), word) ? "a SubShader"
           : Knows(StencilCommands(), word)   ? "a Stencil block"
                                              : "";
}

} // namespace limn
