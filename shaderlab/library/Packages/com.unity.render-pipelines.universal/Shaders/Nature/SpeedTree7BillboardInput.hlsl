// Properties of the billboards of SpeedTree 7. Scripts set the globals: limn has no billboard renderer.
#pragma once
#ifndef UNIVERSAL_SPEEDTREE7BILLBOARD_INPUT_INCLUDED
#define UNIVERSAL_SPEEDTREE7BILLBOARD_INPUT_INCLUDED

#define SPEEDTREE_PI 3.14159265359
#define SPEEDTREE_ALPHATEST
half _Cutoff;
#include "SpeedTree7CommonInput.hlsl"
#include "limn/SpeedTreeBillboard.hlsl"

#define _Surface 0.0 // opaque
#endif
