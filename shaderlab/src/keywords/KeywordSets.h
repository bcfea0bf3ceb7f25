#pragma once

#include <limn/shaderlab/PassProgram.h>

#include <string_view>
#include <vector>

namespace limn
{

/// Returns whether `#pragma name` declares keywords: multi_compile, shader_feature and
/// dynamic_branch with any of their suffixes, and shortcuts such as multi_compile_fog.
bool isKeywordDirective(std::string_view name);

/// Returns the names of such directives with the most common suffixes, to suggest one for a
/// misspelt name.
std::vector<std::string> KeywordDirectives();

/// Returns the sets that `#pragma name words` declares; a shortcut declares sets of its own.
std::vector<KeywordSet> ReadKeywordSets(SourceLocation location, std::string_view name,
                                        std::string_view words);

} // namespace limn
