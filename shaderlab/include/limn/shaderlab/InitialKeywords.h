#pragma once

#include <limn/shaderlab/ShaderLabDocument.h>

#include <span>
#include <string>
#include <vector>

namespace limn
{

/// Returns the keywords that a new material enables, by its properties' defaults and their
/// attributes Toggle, MaterialToggle, ToggleOff and KeywordEnum. They are sorted, each once.
/// A program need not know them. Unity: MaterialPropertyDrawer.Apply (2022.3).
std::vector<std::string> InitialKeywords(const ShaderLabDocument& document);
/// Returns the keywords for properties that hold the values of a material in place of their
/// defaults.
std::vector<std::string> InitialKeywords(std::span<const ShaderProperty> properties);

/// Returns the variant of a program for a material: the first enabled keyword of each keyword set,
/// or else the set's default. The keywords are sorted, each once, without "" and without those of a
/// dynamic_branch, which make no variants. Use it for ShaderCompiler::Compile.
/// @param enabled        the keywords that the material enables
/// @param globalKeywords the keywords enabled for all materials; local keyword sets ignore them
std::vector<std::string> SelectVariant(const PassProgram& program,
                                       std::span<const std::string> enabled,
                                       std::span<const std::string> globalKeywords = {});

} // namespace limn
