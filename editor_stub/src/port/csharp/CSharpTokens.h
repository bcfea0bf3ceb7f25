#pragma once

#include "console/Texts.h"

#include <cstddef>
#include <limn/base/Diagnostic.h>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

enum class CSharpTokenKind
{
    Identifier, ///< also keywords; without the @ of a verbatim one
    Number,
    String, ///< a string of any kind, with its quotes
    Character,
    Punctuation, ///< one character each, except => :: ?. ?? and operators with =
    End          ///< the last of every list
};

struct CSharpToken;

/// Words of a CSharpFile; a part of them has no End.
using CSharpWords = std::span<const CSharpToken>;

/// A word of C#.
struct CSharpToken
{
    CSharpTokenKind kind = CSharpTokenKind::End;
    std::string_view text; ///< a part of the file's text
    std::size_t offset = 0;
    SourceLocation location;
    std::ptrdiff_t match = 0;      ///< for a bracket: how many words further the matching one is
    std::vector<CSharpToken> hole; ///< the expressions of an interpolated string

    bool Is(std::string_view other) const
    {
        return text == other &&
               (kind == CSharpTokenKind::Identifier || kind == CSharpTokenKind::Punctuation);
    }
    bool isName() const { return kind == CSharpTokenKind::Identifier; }
    /// Returns whether the word is a bracket with words between it and the matching one.
    bool isOpen() const { return match > 0; }
    /// Returns the words between an opening bracket and the matching one.
    CSharpWords Inside() const { return {this + 1, this + match}; }
    /// Returns the word behind this one, or behind the bracket that matches it.
    const CSharpToken* Behind() const { return this + (match > 0 ? match : 0) + 1; }
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
    std::vector<CSharpRange> leftOut; ///< the lines of directives, and those that #if leaves out
};

/// The Unity that the conditions of C# are answered for.
struct CSharpTarget
{
    int year = 2022; ///< the year of the Unity version; the default is the one that limn mirrors
    int release = 3;
    /// The answer for the project's own symbols, whose values no file gives: true if they count as
    /// defined.
    bool isUnknownDefined = false;

    int urp() const { return year >= 6000 ? 17 : 14; }
    std::string name() const; ///< "Unity 2022.3 (URP 14)"
};

/// Returns whether the symbol is defined: UNITY_2021_3_OR_NEWER, UNITY_2022_3, URP_12_OR_NEWER,
/// UNITY_STANDALONE and the like. The version of URP is that of the target, whatever name a project
/// uses for it.
bool IsDefinedFor(std::string_view symbol, const CSharpTarget& target);

/// Returns whether a byte may stand in a name of C#.
bool IsNamePart(char c);

/// Cuts C# into words. Comments and what #if leaves out are removed.
/// @param text  must outlive the result
/// @param file  the file's name in messages
/// @throws AssetError with line and column if a text or a comment does not end, brackets do not
///     match, an #if is broken, or the file is not text
CSharpTokens TokenizeCSharp(std::string_view text, const std::string& file,
                            const CSharpTarget& target = {});

} // namespace limn
