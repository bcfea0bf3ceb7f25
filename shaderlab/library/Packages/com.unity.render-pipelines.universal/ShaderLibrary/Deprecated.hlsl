// Names of earlier versions of the library; see ShaderVariablesFunctions.deprecated.hlsl.
#pragma once
#define UNIVERSAL_DEPRECATED_INCLUDED
