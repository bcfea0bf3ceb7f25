// The UI Toolkit in the editor, whose pictures are always sRGB.
#pragma once
#ifndef UNITY_EDITOR_UIE_INCLUDED
#define UNITY_EDITOR_UIE_INCLUDED
#include "HLSLSupport.cginc"

fixed _EditorColorSpace; // 1: textures are read as linear
#define UIE_CUSTOM_SHADER
#define UIE_COLORSPACE_GAMMA 1
#include "UnityUIE.cginc"

fixed4 uie_editor_frag(v2f IN)
{
    // The tint is sRGB already, and comes last.
    bool isTintedLater = IN.typeTexSettings.x == limn_UIE_TEXT && IN.typeTexSettings.w >= 2.0;
    fixed4 tint = isTintedLater ? fixed4(1, 1, 1, 1) : IN.color;
    IN.color = fixed4(1, 1, 1, 1);
    fixed4 color = uie_std_frag(IN);
    fixed isLinear = IN.typeTexSettings.x == limn_UIE_TEXTURED ? _EditorColorSpace : 0;
    return fixed4(lerp(color.rgb, uie_linear_to_gamma(color.rgb), isLinear), color.a) * tint;
}
#endif
