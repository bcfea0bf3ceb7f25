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

// RespellForGlslang, in Spelling.cpp, calls all of the others.

/// Returns preprocessed HLSL in which code that Unity's compilers accept and glslang does not is
/// spelt another way: variables called `line` or `triangle`, samplers without a texture that are
/// declared as `sampler`, and everything that the functions below describe. Rewrites that need
/// types happen later, see lowering/Lowering.h. Lines stay where they are.
///
/// @throws AssetError  if the text is nested too deeply, or lacks a bracket
std::string RespellForGlslang(std::string text, const PassProgram& program, ColumnFinder& lines,
                              std::vector<Diagnostic>& warnings);

/// Gives a struct of limn's library another name where the author declares one of that name, and so
/// for functions with equal parameters. An author wrote it for a version of Unity's library that
/// did not have it.
void HideLibraryNames(TokenEdits& code, ColumnFinder& lines);

/// Turns enumerators into integer constants and the types of `enum`s into int, because glslang does
/// not support enums; they mean nothing more.
void SpellEnums(TokenEdits& code);

/// Removes or replaces the forms of Direct3D 9's effects that later compilers ignore: states in
/// `sampler_state { … }` or behind a sampler's name (with a warning each), and the texture types
/// `texture`, `texture2D`, `textureCUBE`. `unsigned int` becomes `uint`; a struct in a typedef is
/// declared by the typedef's name; a struct in the declaration of variables is declared before
/// them; `uniform` is dropped from a function's parameter, and `row_major` from a uniform matrix,
/// whose elements limn sets by row and column.
void TakeOldForms(TokenEdits& code, std::vector<Diagnostic>& warnings);

/// Moves structs that are declared in a cbuffer in front of it, where glslang accepts them.
void TakeStructsOutOfBuffers(TokenEdits& code);

/// Removes namespaces and `using namespace`. Their declarations, except uniforms, get a name that
/// contains the namespace's, because glslang finds neither types in namespaces nor their
/// unqualified names.
///
/// @throws AssetError  if a namespace is used that does not exist
void TakeNamespaces(TokenEdits& code);

/// Gives `struct B : A` a copy of A's members in front of its own, because glslang ignores the
/// base.
void CopyBaseMembers(TokenEdits& code);

/// Turns the static variables of structs into variables of the file before their struct, and calls
/// static methods by their whole name, because glslang supports no such variables and knows such
/// methods by no other name.
void TakeStaticMembers(TokenEdits& code);

/// Makes one vertex function of those behind `#pragma vertex`, `hull` and `domain`, under the name
/// of the first: for a patch all of whose points are the vertex, which is what the domain function
/// makes of a corner. So the mesh's own vertices are moved, and none are added.
///
/// @throws AssetError  if there is no function of a name behind `hull` or `domain`
void TakeTessellation(TokenEdits& code, const PassProgram& program);

/// Turns the `uniform` parameters of entry functions into uniforms of the program, which is their
/// meaning; in other functions they are ordinary parameters.
void TakeUniformParameters(TokenEdits& code, const std::set<std::string_view>& entries);

} // namespace limn
