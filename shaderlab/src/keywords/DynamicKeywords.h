#pragma once

#include <limn/shaderlab/PassProgram.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace limn
{

/// The keywords of a program's dynamic_branch sets. One that a multi_compile set has as well is
/// dynamic all the same, as in Unity.
std::set<std::string, std::less<>> DynamicKeywords(const PassProgram& program);

/// HLSL that makes each of them a uniform int, and a macro X_KEYWORD_DECLARED; "" for none.
std::string DeclareDynamicKeywords(const PassProgram& program);

/// A warning for each preprocessor condition of the program's own text that asks for one of them:
/// it sees no macro. Conditions in included files are not looked at.
std::vector<Diagnostic> CheckDynamicKeywords(const PassProgram& program);

} // namespace limn
