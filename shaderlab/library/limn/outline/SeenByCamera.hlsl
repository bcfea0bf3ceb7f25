// Whether the camera's depth says that nothing stands in front of what is drawn into a texture which
// shows another part of the view than the camera's target does.
#pragma once

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/DeclareDepthTexture.hlsl"

// position: SV_POSITION; place: xy the texture's top left corner in the picture, pixels, zw 1 / the
// picture's size. What is outside of the picture counts as seen.
bool SeenByCamera(float4 position, float4 place)
{
    float2 uv = (position.xy + place.xy) * place.zw;
    // The camera's depth may be that of another place in the pixel: allow for the slope.
    float slope = abs(ddx(position.z)) + abs(ddy(position.z));
    bool isOutside = any(uv < 0.0) || any(uv > 1.0);
    float own = limn_Nearness(position.z);
    return isOutside || own + limn_DepthMagnitude(own) * 1e-6 + slope >=
                            limn_Nearness(SampleSceneDepth(saturate(uv)));
}
