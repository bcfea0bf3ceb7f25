// Comes before every program, behind the macros that Unity's compiler defines by itself
// (k_PredefinedMacros).
#pragma once

// Unity's compilers know textures and samplers by their precision too.
#define sampler2D_half sampler2D
#define sampler2D_float sampler2D
#define sampler3D_half sampler3D
#define sampler3D_float sampler3D
#define samplerCUBE_half samplerCUBE
#define samplerCUBE_float samplerCUBE
#define Texture2D_half Texture2D
#define Texture2D_float Texture2D
#define Texture2DArray_half Texture2DArray
#define Texture2DArray_float Texture2DArray
#define Texture3D_half Texture3D
#define Texture3D_float Texture3D
#define TextureCube_half TextureCube
#define TextureCube_float TextureCube
#define TextureCubeArray_half TextureCubeArray
#define TextureCubeArray_float TextureCubeArray

// limn::DrawConstants; the generated entry functions read them.
[[vk::push_constant]] cbuffer limn_PushConstants
{
    uint limn_FirstInstance;
    uint limn_InstanceBase;
};
