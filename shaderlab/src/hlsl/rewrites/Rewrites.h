#pragma once

#include <limn/shaderlab/Diagnostic.h>
#include <limn/shaderlab/PassProgram.h>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace limn
{

// Each is in a file of its own: RespellForGlslang, in Spelling.cpp, calls all but AddConversions,
// which is for what glslang has complained of.

/// Preprocessed HLSL with what Unity's compilers take and glslang does not spelt another way:
/// variables called `line` or `triangle`, swizzles of several elements of a matrix, samplers
/// without a texture declared as `sampler`, and what the headers that are included by its source
/// tell. Lines stay where they are.
std::string RespellForGlslang(std::string text, const PassProgram& program,
                              std::vector<Diagnostic>& warnings);

/// HLSL with overloads of the named functions that take larger arguments and cut them to what the
/// function wants: a float4x4 where it has a float3x3, a vector where it has a scalar. The language
/// does so by itself; glslang only from vector to vector. Lines stay where they are.
std::string AddConversions(const std::string& hlsl, const std::set<std::string>& functions);

/// Preprocessed HLSL in which enumerators are integer constants and the types of `enum`s int, which
/// is all that they mean; glslang does not read them. Lines stay where they are.
std::string SpellEnums(std::string text);

/// Preprocessed HLSL in which the numbers that an array of vectors or matrices is initialised with
/// stand in constructors: `float2 a[] = {1, 2, float2(3, 4)}` means `{float2(1, 2), float2(3, 4)}`,
/// which glslang does not see by itself. Lines stay where they are.
std::string GroupInitializers(std::string text);

/// Preprocessed HLSL in which the variables of a `for` loop, if one is used after the loop, are
/// declared before it: Unity's compilers let it live to the end of the block, glslang to the end of
/// the loop. Lines stay where they are.
std::string HoistLoopVariables(std::string text);

/// Preprocessed HLSL in which a cast to a matrix and a swizzle of several elements of one are calls
/// of functions that stand before it: of an integer cast to a matrix glslang takes the bits for
/// floats, and what it makes of the swizzle is not valid. Lines stay where they are.
std::string SpellMatrices(std::string text);

/// Preprocessed HLSL without the declarations of Direct3D 9's effects that later compilers read
/// over: states in `sampler_state { … }` or behind a sampler's name (a warning each), the texture
/// types `texture`, `texture2D`, `textureCUBE`; `unsigned int` is `uint`, and `row_major` says
/// nothing of a uniform matrix, whose elements limn sets by row and column. Lines stay where they
/// are.
std::string TakeOldForms(std::string text, std::vector<Diagnostic>& warnings);

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
