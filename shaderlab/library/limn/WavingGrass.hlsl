// How the wind moves the grass of a terrain. A file that includes it has declared _WavingTint,
// _WaveAndDistance and _CameraPosition.
#pragma once

// Sine and cosine of angles from half a turn back to half a turn ahead, for values from 0 to 1, by
// the first terms of their series; the cosine's last one is as Unity has it, a power too low.
void FastSinCos(float4 val, out float4 s, out float4 c)
{
    val = val * 6.408849 - 3.1415927;
    float4 x2 = val * val;
    s = val * (1.0 + x2 * (-0.16161616 + x2 * (0.0083333 + x2 * -0.00019841)));
    c = 1.0 + x2 * (-0.5 + x2 * (0.041666666 + x2 * (-0.0013888889 + 0.000024801587)));
}

// Moves a vertex of grass by four waves that run over the terrain; gives the colour, lit where the
// waves bend it and fading out towards the largest distance.
half4 TerrainWaveGrass(inout float4 vertex, float waveAmount, half4 color)
{
    const float4 sizeX = float4(0.012, 0.02, 0.06, 0.024);
    const float4 sizeZ = float4(0.006, 0.02, 0.02, 0.05);
    const float4 speed = float4(1.2, 2.0, 1.6, 4.8);
    const float4 moveX = float4(0.024, 0.04, -0.12, 0.096);
    const float4 moveZ = float4(0.006, 0.02, -0.02, 0.1);

    float4 waves = (vertex.x * sizeX + vertex.z * sizeZ) * _WaveAndDistance.y;
    float4 s, c;
    FastSinCos(frac(waves + _WaveAndDistance.x * speed), s, c);
    s = s * s * s * s;
    float lighting = dot(s, normalize(float4(1.0, 1.0, 0.4, 0.2))) * 0.7;
    vertex.xz -= waveAmount * _WaveAndDistance.z * float2(dot(s, moveX), dot(s, moveZ));

    float3 away = vertex.xyz - _CameraPosition.xyz;
    float3 tint = lerp(float3(0.5, 0.5, 0.5), _WavingTint.rgb, lighting);
    return half4(2.0 * tint * color.rgb,
                  saturate(2.0 * (_WaveAndDistance.w - dot(away, away)) * _CameraPosition.w));
}
