#pragma once

#include "console/Texts.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limn/base/Diagnostic.h>
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

/// A part of a file's text.
struct CSharpRange
{
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// A C# file in words.
struct CSharpTokens
{
    std::vector<CSharpToken> tokens; ///< ends with End; brackets match
    std::vector<CSharpCondition> conditions;
    std::vector<CSharpRange> leftOut; ///< directives, and what #if leaves out, by lines
};

/// The Unity that the conditions of C# are answered for.
struct CSharpTarget
{
    int year = 2022; ///< of Unity: the version that limn mirrors
    int release = 3;
    bool isUnknownDefined = false; ///< symbols of a project, whose values no file says

    int urp() const { return year >= 6000 ? 17 : 14; }
    std::string name() const; ///< "Unity 2022.3 (URP 14)"
};

/// Whether the symbol is defined: UNITY_2021_3_OR_NEWER, UNITY_2022_3, URP_12_OR_NEWER,
/// UNITY_STANDALONE and the like. The version of URP is that of the target, under whatever name a
/// project asks for it.
bool IsDefinedFor(std::string_view symbol, const CSharpTarget& target);

/// Cuts C# into words: comments go, so does what #if leaves out.
/// @param text  must outlive the result
/// @param file  for messages
/// @throws AssetError with line and column if a text or a comment does not end, brackets do not
///     match, an #if is broken, or the file is not text
CSharpTokens TokenizeCSharp(std::string_view text, const std::string& file,
                            const CSharpTarget& target = {});

/// A type that nobody said.
inline constexpr const char* k_UnknownType = "?";

/// Words of the language, but for types, `new`, `this` and `base`.
bool IsCSharpKeyword(std::string_view word);

/// Of "T[]" and "List<T>" T.
std::string ElementType(const std::string& type);

} // namespace limn
