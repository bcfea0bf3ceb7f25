#pragma once

float PerceptualRoughnessToRoughness(float perceptualRoughness)
{
    return perceptualRoughness * perceptualRoughness;
}
float RoughnessToPerceptualRoughness(float roughness) { return sqrt(roughness); }
float PerceptualSmoothnessToPerceptualRoughness(float perceptualSmoothness)
{
    return 1.0 - perceptualSmoothness;
}
