// Colours and textures of the built-in pipeline.
#pragma once
#include "limn/GammaSpace.hlsl"

// In linear space the weights of unity_ColorSpaceLuminance give 0.504 for white, as Unity's do.
// LinearRgbToLuminance has the weights of Rec. 709.
half Luminance(half3 rgb) { return dot(rgb, unity_ColorSpaceLuminance.rgb); }
half LinearRgbToLuminance(half3 linearRgb)
{
    return dot(linearRgb, half3(0.2126729, 0.7151522, 0.0721750));
}

// The curve of sRGB, for values above 1 the plain power 2.2.
float GammaToLinearSpaceExact(float value)
{
    if (value <= 0.04045)
    {
        return value / 12.92;
    }
    return value < 1.0 ? pow((value + 0.055) / 1.055, 2.4) : pow(value, 2.2);
}
float LinearToGammaSpaceExact(float value)
{
    if (value <= 0.0031308)
    {
        return max(value, 0.0) * 12.92;
    }
    return value < 1.0 ? 1.055 * pow(value, 0.4166667) - 0.055 : pow(value, 0.45454545);
}

// The same by a cubic and by one power: within 0.002 of the exact curve in 0...1.
half3 GammaToLinearSpace(half3 sRGB)
{
    return sRGB * (sRGB * (sRGB * 0.305306011 + 0.682171111) + 0.012522878);
}
half3 LinearToGammaSpace(half3 linRGB)
{
    return max(1.055 * pow(max(linRGB, 0.0), 0.416666667) - 0.055, 0.0);
}

// RGBM and the like: alpha multiplies, as far as decodeInstructions.w says.
// x: multiplier, y: exponent of alpha.
half3 DecodeHDR(half4 data, half4 decodeInstructions)
{
    half alpha = decodeInstructions.w * (data.a - 1.0) + 1.0;
    half factor = decodeInstructions.y == 1.0 ? alpha : pow(max(alpha, 0.0), decodeInstructions.y);
    return decodeInstructions.x * factor * data.rgb;
}
// Colours of gamma space are multiplied by alpha itself.
half3 DecodeHDR(half4 data, half4 decodeInstructions, int colorspaceIsGamma)
{
    half exponent = colorspaceIsGamma != 0 ? 1.0 : decodeInstructions.y;
    return DecodeHDR(data, half4(decodeInstructions.x, exponent, decodeInstructions.zw));
}

half3 DecodeLightmapDoubleLDR(fixed4 color, half4 decodeInstructions)
{
    return decodeInstructions.x * color.rgb;
}
half3 DecodeLightmapRGBM(half4 data, half4 decodeInstructions)
{
    return decodeInstructions.x * pow(max(data.a, 0.0), decodeInstructions.y) * data.rgb;
}
// Light maps hold floating-point numbers.
half3 DecodeLightmap(fixed4 color, half4 decodeInstructions) { return color.rgb; }
half3 DecodeLightmap(fixed4 color) { return color.rgb; }

half3 DecodeRealtimeLightmap(fixed4 color)
{
    return pow(max(unity_DynamicLightmap_HDR.x * color.a * color.rgb, 0.0),
               unity_DynamicLightmap_HDR.y);
}

// dirTex: main direction of the light, from 0...1; w: what is in all directions on average.
half3 DecodeDirectionalLightmap(half3 color, fixed4 dirTex, half3 normalWorld)
{
    half3 mainDirection = dirTex.xyz - 0.5; // half as long as the light is of one direction
    half share = 0.5 + dot(mainDirection, normalWorld);
    return color * share / max(dirTex.w, 1e-4);
}
