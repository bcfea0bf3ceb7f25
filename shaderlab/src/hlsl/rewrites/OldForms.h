#pragma once

#include <limn/shaderlab/Diagnostic.h>

#include <string>
#include <vector>

namespace limn
{

/// Preprocessed HLSL without the declarations of Direct3D 9's effects that later compilers read
/// over: states in `sampler_state { … }` or behind a sampler's name (a warning each), the texture
/// types `texture`, `texture2D`, `textureCUBE`; `unsigned int` is `uint`, and `row_major` says
/// nothing of a uniform matrix, whose elements limn sets by row and column. Lines stay where they
/// are.
std::string TakeOldForms(std::string text, std::vector<Diagnostic>& warnings);

} // namespace limn
