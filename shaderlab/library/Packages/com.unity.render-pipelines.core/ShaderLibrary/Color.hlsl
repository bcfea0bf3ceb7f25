#pragma once

float SRGBToLinear(float c)
{
    return c <= 0.04045 ? c / 12.92 : pow(abs((c + 0.055) / 1.055), 2.4);
}
float3 SRGBToLinear(float3 c)
{
    return float3(SRGBToLinear(c.r), SRGBToLinear(c.g), SRGBToLinear(c.b));
}
float4 SRGBToLinear(float4 c) { return float4(SRGBToLinear(c.rgb), c.a); }

float LinearToSRGB(float c)
{
    return c <= 0.0031308 ? c * 12.92 : 1.055 * pow(abs(c), 1.0 / 2.4) - 0.055;
}
float3 LinearToSRGB(float3 c)
{
    return float3(LinearToSRGB(c.r), LinearToSRGB(c.g), LinearToSRGB(c.b));
}
float4 LinearToSRGB(float4 c) { return float4(LinearToSRGB(c.rgb), c.a); }

float Gamma22ToLinear(float c) { return pow(abs(c), 2.2); }
float3 Gamma22ToLinear(float3 c) { return pow(abs(c), 2.2); }
float LinearToGamma22(float c) { return pow(abs(c), 1.0 / 2.2); }
float3 LinearToGamma22(float3 c) { return pow(abs(c), 1.0 / 2.2); }

// Rec. 709 weights, linear colours
float Luminance(float3 linearRgb) { return dot(linearRgb, float3(0.2126729, 0.7151522, 0.0721750)); }
float Luminance(float4 linearRgba) { return Luminance(linearRgba.rgb); }

float3 HsvToRgb(float3 c)
{
    float3 distance = abs(frac(c.xxx + float3(1.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0);
    return c.z * lerp(float3(1, 1, 1), saturate(distance - 1.0), c.y);
}

float3 RgbToHsv(float3 c)
{
    float high = max(c.r, max(c.g, c.b));
    float range = high - min(c.r, min(c.g, c.b));
    float safeRange = max(range, 1e-10);
    float hue = high == c.r   ? (c.g - c.b) / safeRange
                : high == c.g ? (c.b - c.r) / safeRange + 2.0
                              : (c.r - c.g) / safeRange + 4.0;
    return float3(frac(hue / 6.0), range / max(high, 1e-10), high);
}
