// The older name of the file.
#pragma once
#include "TextCore_Properties.cginc"
