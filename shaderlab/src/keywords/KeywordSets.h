#pragma once

#include <limn/shaderlab/PassProgram.h>

#include <string_view>
#include <vector>

namespace limn
{

/// Whether `#pragma name` declares keywords: multi_compile, shader_feature and dynamic_branch with
/// any of their suffixes, and the shortcuts such as multi_compile_fog.
bool isKeywordDirective(std::string_view name);

/// Names of such directives, with the suffixes that most shaders use, for whoever misspelt one.
std::vector<std::string> KeywordDirectives();

/// The sets that `#pragma name words` declares; a shortcut declares those of its own.
std::vector<KeywordSet> ReadKeywordSets(SourceLocation location, std::string_view name,
                                        std::string_view words);

} // namespace limn
