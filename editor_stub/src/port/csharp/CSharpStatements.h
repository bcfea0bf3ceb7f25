#pragma once

#include "port/csharp/CSharpTokens.h"

#include <initializer_list>
#include <string_view>

namespace limn
{

/// Statements may stand in each other this often; no person writes more.
inline constexpr int k_MostStatements = 100;

/// Returns the first word from `at` on, outside of brackets, that is one of these signs, or `end`.
const CSharpToken* FindOutsideOfBrackets(const CSharpToken* at, const CSharpToken* end,
                                         std::initializer_list<std::string_view> words);

/// Returns the word behind the statement that begins at `at`, with all that belongs to it.
const CSharpToken* EndOfStatement(const CSharpToken* at, const CSharpToken* end);

} // namespace limn
