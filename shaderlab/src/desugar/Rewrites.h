#pragma once

#include <limn/base/Diagnostic.h>
#include <limn/shaderlab/PassProgram.h>

#include "hlsl/TokenEdits.h"
#include "tokens/ColumnFinder.h"

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
/// @throws AssetError  where the text is nested too deeply, or lacks a bracket
std::string RespellForGlslang(std::string text, const PassProgram& program, ColumnFinder& lines,
                              std::vector<Diagnostic>& warnings);

/// Makes integer constants of enumerators and int of the types of `enum`s, which is all that they
/// mean; glslang does not read them.
void SpellEnums(TokenEdits& code);

/// Takes out the declarations of Direct3D 9's effects that later compilers read over: states in
/// `sampler_state { … }` or behind a sampler's name (a warning each), the texture types `texture`,
/// `texture2D`, `textureCUBE`; `unsigned int` is `uint`, structs that a typedef names are
/// declared by that name, those that variables are declared with before them, `uniform` says
/// nothing of a function's parameter, and `row_major` nothing of a uniform matrix, whose elements
/// limn sets by row and column.
void TakeOldForms(TokenEdits& code, std::vector<Diagnostic>& warnings);

/// Moves structs that are declared in a cbuffer in front of it, where glslang reads them.
void TakeStructsOutOfBuffers(TokenEdits& code);

/// Takes namespaces away, and `using namespace`: what they declare, uniforms apart, gets a name
/// with theirs in it. glslang finds no types in them, and no names of them that stand alone.
///
/// @throws AssetError  where one is used that is not there
void TakeNamespaces(TokenEdits& code);

/// Gives `struct B : A` a copy of A's members in front of its own; glslang reads over the base.
void CopyBaseMembers(TokenEdits& code);

/// Makes variables of the file, before their struct, of the static variables of structs, and calls
/// static methods by their whole name: glslang knows no such variables, and no other name of such
/// methods.
void TakeStaticMembers(TokenEdits& code);

/// Makes uniforms of the program of the `uniform` parameters of entry functions, which is what they
/// mean; in other functions they are ordinary parameters.
void TakeUniformParameters(TokenEdits& code, const std::set<std::string_view>& entries);

} // namespace limn
