#include "parser/Parser.h"

#include <limn/base/Text.h>
#include <limn/base/WordList.h>

#include <algorithm>

namespace limn
{

namespace
{

constexpr std::size_t k_MaxTags = 256; ///< of a scope: each new one is compared with the others
constexpr std::size_t k_MaxTypos = 2;

// Any key and any value is legal; these are only what a typo is measured against.
const auto k_TagKeys =
    SplitWords("Queue RenderType RenderPipeline LightMode DisableBatching ForceNoShadowCasting "
               "IgnoreProjector CanUseSpriteAtlas PreviewType PassFlags UniversalMaterialType "
               "TerrainCompatible");
const auto k_Pipelines =
    SplitWords("UniversalPipeline HDRenderPipeline UniversalRenderPipeline LightweightPipeline");
const auto k_LightModes = SplitWords(
    "UniversalForward UniversalForwardOnly UniversalGBuffer Universal2D NormalsRendering "
    "SRPDefaultUnlit ShadowCaster DepthOnly DepthNormals DepthNormalsOnly MotionVectors "
    "SceneSelectionPass LightweightForward ForwardBase ForwardAdd Deferred PrepassBase "
    "PrepassFinal Always Meta Picking Vertex");

/// The name that was probably meant; "" for one that is known, or that is near none. Names that
/// differ by their last letters only ("Outline2") are meant as they are.
std::string_view Meant(std::string_view name, const std::vector<std::string_view>& known)
{
    const bool isKnown = std::ranges::any_of(known, [&](std::string_view candidate)
                                             { return EqualsIgnoringCase(name, candidate); });
    const std::string_view nearest = isKnown ? "" : NearestName(name, known);
    const bool isMeant = !nearest.empty() &&
                         EditDistance(name, nearest) <= std::min(k_MaxTypos, nearest.size() / 4) &&
                         !EqualsIgnoringCase(name.substr(0, nearest.size()), nearest);
    return isMeant ? nearest : "";
}

bool isTagWord(const Token& token)
{
    return token.kind == TokenKind::String || token.kind == TokenKind::Identifier;
}

} // namespace

void Parser::ParseTags()
{
    const SourceLocation opening = m_Token.location;
    if (!Expect("Tags", '{'))
    {
        return;
    }
    while (!Accept('}'))
    {
        if (m_Token.kind == TokenKind::End ||
            (m_Token.kind == TokenKind::Identifier && isAnyCommand() && !m_Lexer.isNext('=')))
        {
            ReportStillOpen("Tags", opening);
            return;
        }
        if (!isTagWord(m_Token))
        {
            Error("Tags: unexpected " + Found() + "; a tag is \"key\" = \"value\"");
            Advance();
            continue;
        }
        ParseTag(m_Scope.tags);
    }
}

void Parser::ParseTag(ShaderTags& tags)
{
    const Token key = Advance();
    if (!Expect("Tags", '='))
    {
        if (m_Token.kind == TokenKind::String)
        {
            Advance(); // the value, most likely
        }
        return;
    }
    if (!isTagWord(m_Token))
    {
        Error("Tags: the value of \"" + std::string(key.text.substr(0, 80)) +
              "\" is missing before " + Found());
        return;
    }
    const Token value = Advance();
    if (key.kind != value.kind)
    {
        Report(Severity::Error, key.location,
               "Tags: only one of key and value is in quotes; put both in quotes");
    }
    CheckTag(key, value);
    if (tags.items.size() == k_MaxTags)
    {
        Report(Severity::Error, key.location,
               "Tags: there are more than " + std::to_string(k_MaxTags) +
                   "; the tags after these are not kept");
    }
    else if (Count())
    {
        tags.Set({key.location, std::string(key.text), std::string(value.text)});
    }
}

/// Warns of names that are nearly, but not quite, ones that Unity or URP asks for.
void Parser::CheckTag(const Token& key, const Token& value)
{
    const auto warn = [this](const Token& token, std::string_view meant)
    {
        if (!meant.empty())
        {
            Report(Severity::Warning, token.location,
                   "Tags: \"" + std::string(token.text) + "\" is no name that Unity knows; did " +
                       "you mean \"" + std::string(meant) + "\"?");
        }
    };
    warn(key, Meant(key.text, k_TagKeys));
    if (EqualsIgnoringCase(key.text, "RenderPipeline"))
    {
        warn(value, Meant(value.text, k_Pipelines));
    }
    else if (EqualsIgnoringCase(key.text, "LightMode"))
    {
        warn(value, Meant(value.text, k_LightModes));
    }
}

void Parser::ParseLod()
{
    const auto number = ParseNumber("LOD");
    // A Pass may name one too, without effect.
    if (number && !m_Pass)
    {
        m_Scope.lod = static_cast<int>(std::clamp(*number, 0.0f, 1e6f));
    }
}

void Parser::ParsePackageRequirements()
{
    auto& requirements = m_Pass ? m_Pass->packageRequirements : m_SubShader->packageRequirements;
    if (!Expect("PackageRequirements", '{'))
    {
        return;
    }
    while (!Accept('}'))
    {
        if (m_Token.kind != TokenKind::String)
        {
            Error("PackageRequirements: unexpected " + Found() +
                  "; an entry is \"package\" or \"package\" : \"versions\"");
            if (m_Token.kind == TokenKind::End || isAnyCommand())
            {
                return;
            }
            Advance();
            continue;
        }
        const Token package = Advance();
        std::string range;
        if (Accept(':'))
        {
            range = ParseString("PackageRequirements").value_or("");
        }
        if (Count())
        {
            requirements.push_back({package.location, std::string(package.text), std::move(range)});
        }
    }
}

} // namespace limn
