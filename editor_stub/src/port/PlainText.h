#pragma once

#include "port/csharp/CSharpFile.h"

#include <optional>
#include <string>
#include <vector>

namespace limn
{

/// The text of a plain string word, or of such ones with + between them; nothing for any other.
std::optional<std::string> PlainText(CSharpWords words);

/// The arguments of `new T(...)` or `new(...)`, whatever stands behind it; nothing for others.
std::optional<std::vector<CSharpWords>> NewArguments(CSharpWords words);

} // namespace limn
