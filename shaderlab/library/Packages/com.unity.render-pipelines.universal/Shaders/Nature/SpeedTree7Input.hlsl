// Properties of SpeedTree 7.
#pragma once
#ifndef UNIVERSAL_SPEEDTREE7_INPUT_INCLUDED
#define UNIVERSAL_SPEEDTREE7_INPUT_INCLUDED

#ifdef GEOM_TYPE_BRANCH_DETAIL
#define GEOM_TYPE_BRANCH
#endif
#if defined(GEOM_TYPE_FROND) || defined(GEOM_TYPE_LEAF) || defined(GEOM_TYPE_FACING_LEAF)
#define SPEEDTREE_ALPHATEST
half _Cutoff;
#endif
#include "SpeedTree7CommonInput.hlsl"

#define _Surface 0.0 // opaque
#ifdef GEOM_TYPE_BRANCH_DETAIL
sampler2D _DetailTex;
#endif
#endif
