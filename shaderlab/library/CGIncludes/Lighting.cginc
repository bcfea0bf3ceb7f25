#pragma once
#include "UnityCG.cginc"
