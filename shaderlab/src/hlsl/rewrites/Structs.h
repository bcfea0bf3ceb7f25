#pragma once

#include <string>

namespace limn
{

/// Preprocessed HLSL in which `struct B : A` has a copy of A's members in front of its own, and
/// names A no more: glslang reads over the base. Lines stay where they are.
std::string CopyBaseMembers(std::string text);

/// Preprocessed HLSL in which the static variables of structs are variables of the file, before
/// their struct, and static methods are called by their whole name: glslang knows no such
/// variables, and no other name of such methods. Lines stay where they are.
std::string TakeStaticMembers(std::string text);

} // namespace limn
