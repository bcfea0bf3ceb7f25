#pragma once

#include <limn/shaderlab/PassProgram.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace limn
{

/// Returns the keywords of a program's dynamic_branch sets. A keyword that is also in a
/// multi_compile set is nevertheless dynamic, as in Unity.
std::set<std::string, std::less<>> DynamicKeywords(const PassProgram& program);

/// Returns HLSL that declares each dynamic keyword as a uniform int, and a macro
/// X_KEYWORD_DECLARED; "" if there are none.
std::string DeclareDynamicKeywords(const PassProgram& program);

/// Returns a warning for each preprocessor condition of the program's own text that tests a dynamic
/// keyword, which is no macro. Conditions in included files are ignored.
std::vector<Diagnostic> CheckDynamicKeywords(const PassProgram& program);

} // namespace limn
