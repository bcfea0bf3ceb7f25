#pragma once

#include <limn/core/ShaderId.h>

namespace limn
{

// These are the names of the camera's matrices in shaders, and of the world's origin in its spaces:
// see Globals.hlsl.
inline const ShaderPropertyId unity_MatrixV{"unity_MatrixV"};
inline const ShaderPropertyId unity_MatrixInvV{"unity_MatrixInvV"};
inline const ShaderPropertyId glstate_matrix_projection{"glstate_matrix_projection"};
inline const ShaderPropertyId unity_MatrixInvP{"unity_MatrixInvP"};
inline const ShaderPropertyId unity_MatrixVP{"unity_MatrixVP"};
inline const ShaderPropertyId unity_MatrixInvVP{"unity_MatrixInvVP"};
inline const ShaderPropertyId limn_Origin{"limn_Origin"};
inline const ShaderPropertyId limn_OriginVS{"limn_OriginVS"};
inline const ShaderPropertyId limn_OriginCS{"limn_OriginCS"};

} // namespace limn
