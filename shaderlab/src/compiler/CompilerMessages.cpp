#include "compiler/CompilerMessages.h"

#include "hlsl/TokenEdits.h"

#include <algorithm>
#include <optional>

namespace limn
{

namespace
{

constexpr std::string_view k_Constructor = "'constructor'";

class MessagePlacer
{
public:
    MessagePlacer(const HlslSource& source, const RewrittenHlsl& hlsl)
        : m_Source(source), m_Hlsl(hlsl)
    {
        for (const std::size_t token : hlsl.unknownTypes)
        {
            m_Errors.push_back({token, source.tokens.Place(token)});
        }
    }

    std::vector<Diagnostic> Place(const std::vector<Diagnostic>& messages)
    {
        std::vector<Diagnostic> placed;
        for (Diagnostic message : messages)
        {
            const std::optional<std::size_t> token = TokenOf(message);
            if (!token || PlaceAt(*token, message))
            {
                placed.push_back(std::move(message));
            }
        }
        return placed;
    }

private:
    struct PlacedError
    {
        std::size_t token = 0;
        HlslPlace place;
    };

    /// Returns the token of a message. A message of the linker has no place, but it may begin with
    /// the name of a function.
    std::optional<std::size_t> TokenOf(const Diagnostic& message) const
    {
        const auto line = static_cast<std::size_t>(message.location.line);
        if (message.file == k_TokenFile && line > 0 && line <= m_Source.tokens.size())
        {
            return line - 1;
        }
        const std::string_view text = message.message;
        const HlslFunction* function =
            line == 0 && text.starts_with("'")
                ? m_Source.declarations.FindDefinition(text.substr(1, text.find('\'', 1) - 1))
                : nullptr;
        return function ? std::optional(function->token) : std::nullopt;
    }

    /// Returns false for a message that only follows from an error before it.
    bool PlaceAt(std::size_t token, Diagnostic& message)
    {
        const bool isGrammar = message.message.ends_with(" expected");
        const HlslNode* node = isGrammar ? nullptr : NodeOf(token);
        const HlslNode* construct =
            message.message.starts_with(k_Constructor) ? ConstructOf(token) : nullptr;
        if (construct)
        {
            node = construct;
            token = construct->first;
            message.message.replace(0, k_Constructor.size(),
                                    "'" + std::string(m_Source.tokens.Text(token)) + "'");
        }
        const bool isValue =
            node && node->kind == HlslNodeKind::Declarator && message.message.starts_with("'=': ");
        const HlslPlace place = m_Source.tokens.Place(isValue ? node->child->first - 1 : token);
        message.file = place.file;
        message.location = place.location;
        if (message.severity != Severity::Error)
        {
            return true;
        }
        if (isConsequence(node, place))
        {
            return false;
        }
        m_Errors.push_back({token, place});
        return true;
    }

    /// Returns whether an earlier error is in an operand of the node or, if no expression is known,
    /// in the line.
    bool isConsequence(const HlslNode* node, const HlslPlace& place) const
    {
        const auto isWithin = [&](const PlacedError& error)
        {
            return node ? error.token >= node->first && error.token < node->end
                        : error.place.file == place.file &&
                              error.place.location.line == place.location.line;
        };
        return std::ranges::any_of(m_Errors, isWithin);
    }

    /// The innermost one around the token, or before it: such are told of where they end.
    const HlslNode* ConstructOf(std::size_t token) const
    {
        const HlslNode* innermost = nullptr;
        for (const HlslNode& node : m_Hlsl.nodes)
        {
            const bool isAround =
                node.kind == HlslNodeKind::Construct && node.first <= token && token <= node.end;
            innermost =
                isAround && (!innermost || node.first > innermost->first) ? &node : innermost;
        }
        return innermost;
    }

    /// Returns the node at the token if it has operands, or null.
    const HlslNode* NodeOf(std::size_t token) const
    {
        const auto node = std::ranges::find_if(m_Hlsl.nodes, [&](const HlslNode& known)
                                               { return known.token == token && known.child; });
        return node == m_Hlsl.nodes.end() ? nullptr : &*node;
    }

    const HlslSource& m_Source;
    const RewrittenHlsl& m_Hlsl;
    std::vector<PlacedError> m_Errors;
};

} // namespace

std::vector<Diagnostic> PlaceMessages(const std::vector<Diagnostic>& messages,
                                      const HlslSource& source, const RewrittenHlsl& hlsl)
{
    return MessagePlacer(source, hlsl).Place(messages);
}

std::vector<Diagnostic> DescribeUndeclared(const HlslSource& source, const RewrittenHlsl& hlsl)
{
    std::vector<std::string_view> known = {"float",  "half",     "int",     "uint",  "bool",
                                           "float2", "float3",   "float4",  "half2", "half3",
                                           "half4",  "float3x3", "float4x4"};
    for (const HlslStruct& type : source.declarations.structs)
    {
        known.push_back(type.name);
    }
    std::vector<Diagnostic> diagnostics;
    for (const std::size_t token : hlsl.unknownTypes)
    {
        const std::string_view text = source.tokens.Text(token);
        constexpr std::string_view k_Fixed = "fixed"; // of CG programs, where it is half
        const std::string nearest = text.starts_with(k_Fixed)
                                        ? "half" + std::string(text.substr(k_Fixed.size()))
                                        : std::string(NearestName(text, known));
        diagnostics.push_back(source.tokens.Error(
            token,
            nearest.empty() ? "unknown type" : "unknown type; did you mean '" + nearest + "'?"));
    }
    for (const auto& [token, problem] : hlsl.unknownNames)
    {
        diagnostics.push_back(source.tokens.Error(token, problem));
    }
    return diagnostics;
}

} // namespace limn
