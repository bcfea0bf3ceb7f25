#pragma once

#include <limn/shaderlab/Diagnostic.h>
#include <limn/shaderlab/PassProgram.h>

#include "hlsl/Editor.h"
#include "hlsl/SourceLines.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

// Each is in a file of its own; RespellForGlslang, in Spelling.cpp, calls all.

/// Preprocessed HLSL with what Unity's compilers take and glslang does not spelt another way:
/// variables called `line` or `triangle`, samplers without a texture declared as `sampler`, and
/// what the functions below tell. What needs types is done later, see lowering/Lowering.h. Lines
/// stay where they are.
///
/// @throws AssetError  where the text is nested too deeply
std::string RespellForGlslang(std::string text, const PassProgram& program, SourceLines& lines,
                              std::vector<Diagnostic>& warnings);

/// Preprocessed HLSL in which enumerators are integer constants and the types of `enum`s int, which
/// is all that they mean; glslang does not read them. Lines stay where they are.
std::string SpellEnums(std::string text);

/// Takes out the declarations of Direct3D 9's effects that later compilers read over: states in
/// `sampler_state { … }` or behind a sampler's name (a warning each), the texture types `texture`,
/// `texture2D`, `textureCUBE`; `unsigned int` is `uint`, structs that a typedef names are
/// declared by that name, those that variables are declared with before them, `uniform` says
/// nothing of a function's parameter, and `row_major` nothing of a uniform matrix, whose elements
/// limn sets by row and column.
void TakeOldForms(HlslEditor& code, std::vector<Diagnostic>& warnings);

/// Preprocessed HLSL in which `struct B : A` has a copy of A's members in front of its own, and
/// names A no more: glslang reads over the base. Lines stay where they are.
std::string CopyBaseMembers(std::string text);

/// Preprocessed HLSL in which the static variables of structs are variables of the file, before
/// their struct, and static methods are called by their whole name: glslang knows no such
/// variables, and no other name of such methods. Lines stay where they are.
std::string TakeStaticMembers(std::string text);

/// Preprocessed HLSL in which the `uniform` parameters of entry functions are uniforms of the
/// program, which is what they mean; in other functions they are ordinary parameters. Lines stay
/// where they are.
std::string TakeUniformParameters(std::string text, const std::set<std::string_view>& entries);

} // namespace limn
