#pragma once
#include "limn/PerDraw.hlsl"
#include "limn/Globals.hlsl"
