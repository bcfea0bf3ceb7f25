#pragma once

#include <limn/shaderlab/ShaderLabDocument.h>

#include <span>
#include <string>
#include <vector>

namespace limn
{

/// The keywords that a new material has on, by its properties' defaults and their attributes
/// Toggle, MaterialToggle, ToggleOff and KeywordEnum; sorted, each once. Whether a program knows
/// them does not matter. Unity: MaterialPropertyDrawer.Apply (2022.3).
std::vector<std::string> InitialKeywords(const ShaderLabDocument& document);
/// The same for properties whose values, as in a material, stand where their defaults are.
std::vector<std::string> InitialKeywords(std::span<const ShaderProperty> properties);

/// The variant of a program for a material: of each keyword set the first keyword that is enabled,
/// else the set's default. Sorted, each once, without "" and without the keywords of a
/// dynamic_branch, which make no variants. Made for ShaderCompiler::Compile.
/// @param enabled        by the material
/// @param globalKeywords enabled for all, which only sets look at that are not local ones
std::vector<std::string> SelectVariant(const PassProgram& program,
                                       std::span<const std::string> enabled,
                                       std::span<const std::string> globalKeywords = {});

} // namespace limn
