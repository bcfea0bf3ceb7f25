#pragma once

#include <cstddef>
#include <limn/shaderlab/Diagnostic.h>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

enum class CSharpTokenKind
{
    Identifier, ///< keywords too; without the @ of a verbatim one
    Number,
    String, ///< of any kind, with its quotes
    Character,
    Punctuation, ///< one character each, but for => :: ?. ?? and operators with =
    End          ///< the last of every list
};

/// A word of C#.
struct CSharpToken
{
    CSharpTokenKind kind = CSharpTokenKind::End;
    std::string_view text; ///< of the file
    std::size_t offset = 0;
    SourceLocation location;
    std::ptrdiff_t match = 0;      ///< of a bracket: how many words on the other one is
    std::vector<CSharpToken> hole; ///< what an interpolated string computes

    bool Is(std::string_view other) const
    {
        return text == other &&
               (kind == CSharpTokenKind::Identifier || kind == CSharpTokenKind::Punctuation);
    }
    bool isName() const { return kind == CSharpTokenKind::Identifier; }
};

/// A condition of the preprocessor and how it was answered.
struct CSharpCondition
{
    std::string text; ///< "UNITY_6000_0_OR_NEWER"
    bool isTrue = false;
    SourceLocation location;
};

/// A C# file in words.
struct CSharpTokens
{
    std::vector<CSharpToken> tokens; ///< ends with End; brackets match
    std::vector<CSharpCondition> conditions;
};

/// Whether a symbol of Unity's is defined for limn, which mirrors Unity 2022.3: its version and
/// those before.
bool IsDefinedForLimn(std::string_view symbol);

/// Cuts C# into words: comments go, so does what #if leaves out.
/// @param text  must outlive the result
/// @param file  for messages
/// @throws AssetError with line and column if a text or a comment does not end, brackets do not
///     match, an #if is broken, or the file is not text
CSharpTokens TokenizeCSharp(std::string_view text, const std::string& file);

} // namespace limn
