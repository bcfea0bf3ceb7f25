// Exposure: apertures are f-numbers, shutter speeds are seconds, luminances are cd/m2; EV100 is the
// exposure value at ISO 100 (ISO 2720; Lagarde and de Rousiers, "Moving Frostbite to PBR", 2014).
#pragma once
#ifndef UNITY_PHYSICAL_CAMERA_INCLUDED
#define UNITY_PHYSICAL_CAMERA_INCLUDED

float ComputeEV100(float aperture, float shutterSpeed, float ISO)
{
    return log2(100.0 * aperture * aperture / (ISO * shutterSpeed));
}
float ComputeISO(float aperture, float shutterSpeed, float targetEV100)
{
    return 100.0 * aperture * aperture * exp2(-targetEV100) / shutterSpeed;
}

// The calibration constant is that of a meter for reflected light.
float ComputeEV100FromAvgLuminance(float avgLuminance, float calibrationConstant)
{
    return log2(avgLuminance / (0.01 * calibrationConstant));
}
float ComputeEV100FromAvgLuminance(float avgLuminance)
{
    return ComputeEV100FromAvgLuminance(avgLuminance, 12.5);
}

// Luminances are multiplied by it. The scale is 78 / (100 * transmission of the lens).
float ConvertEV100ToExposure(float EV100, float exposureScale) { return exp2(-EV100) / exposureScale; }
float ConvertEV100ToExposure(float EV100) { return ConvertEV100ToExposure(EV100, 1.2); }
float ConvertExposureToEV100(float exposure, float exposureScale)
{
    return -log2(exposure * exposureScale);
}
float ConvertExposureToEV100(float exposure) { return ConvertExposureToEV100(exposure, 1.2); }

// Speeds are per second.
float ComputeLuminanceAdaptation(float previousLuminance, float currentLuminance,
                                 float speedDarkToLight, float speedLightToDark, float deltaTime)
{
    float speed = currentLuminance > previousLuminance ? speedDarkToLight : speedLightToDark;
    return lerp(currentLuminance, previousLuminance, exp2(-speed * deltaTime));
}
#endif
