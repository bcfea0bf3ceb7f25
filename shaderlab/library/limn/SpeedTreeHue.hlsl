#pragma once

// Towards another hue, about as bright as before.
half3 limn_VaryHue(half3 color, half3 hue, half amount)
{
    half3 shifted = lerp(color, hue, amount);
    half brightness = max(color.r, max(color.g, color.b)) /
                      max(shifted.r, max(shifted.g, shifted.b));
    return saturate(shifted * (brightness * 0.5 + 0.5));
}
