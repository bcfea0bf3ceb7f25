#pragma once
#include "HLSLSupport.cginc"
