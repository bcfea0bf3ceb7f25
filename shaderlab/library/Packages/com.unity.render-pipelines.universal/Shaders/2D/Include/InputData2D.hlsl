#pragma once
#ifndef INPUT_DATA_2D_INCLUDED
#define INPUT_DATA_2D_INCLUDED

struct InputData2D
{
    float2 uv;
    float2 lightingUV; // place on the screen
};

void InitializeInputData(float2 uv, half2 lightingUV, out InputData2D inputData)
{
    inputData.uv = uv;
    inputData.lightingUV = lightingUV;
}
void InitializeInputData(float2 uv, out InputData2D inputData)
{
    InitializeInputData(uv, half2(0, 0), inputData);
}
#endif
