#include "Assets/Somewhere/ProbeStrength.cginc" // as in the project that it came from

half4 ProbeColor()
{
    return half4(_Strength, 0, 0, 1);
}
