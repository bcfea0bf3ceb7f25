// Names of earlier versions of the library; see ShaderVariablesFunctions.deprecated.hlsl.
#pragma once
#ifndef UNIVERSAL_DEPRECATED_INCLUDED
#define UNIVERSAL_DEPRECATED_INCLUDED

#endif
