// Entry points of the generated passes by which the editor selects objects.
#pragma once
#define SG_SELECTION_PICKING_PASS_INCLUDED

PackedVaryings vert(Attributes input) { return PackVaryings(BuildVaryings(input)); }

half4 frag(PackedVaryings packedInput) : SV_TARGET
{
    SurfaceDescription surface = BuildSurfaceDescription(UnpackVaryings(packedInput));
#ifdef _ALPHATEST_ON
#if ALPHA_CLIP_THRESHOLD
    clip(surface.Alpha - surface.AlphaClipThreshold);
#else
    clip(surface.Alpha - 0.01); // sprites
#endif
#endif
#if defined(SCENESELECTIONPASS)
    return half4(_ObjectId, _PassValue, 1.0, 1.0);
#elif defined(SCENEPICKINGPASS)
    return _SelectionID;
#else
    return 0;
#endif
}
