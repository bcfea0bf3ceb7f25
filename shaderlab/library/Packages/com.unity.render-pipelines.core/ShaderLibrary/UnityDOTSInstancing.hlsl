// Instancing of entities. limn has none, so that DOTS_INSTANCING_ON, which all of it hangs on, is never
// defined.
#pragma once
#define UNITY_DOTS_INSTANCING_INCLUDED
