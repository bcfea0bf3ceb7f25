// Steep parallax: the view ray walks down into a height map (1: the surface, 0: as deep as it gets)
// and is refined by false position. The including file defines PerPixelHeightDisplacementParam and
// ComputePerPixelHeightDisplacement; with POM_NAME_ID it may include this more than once.
#ifndef POM_USER_DATA_PARAMETERS
#define POM_USER_DATA_PARAMETERS
#endif
#ifndef POM_USER_DATA_ARGUMENTS
#define POM_USER_DATA_ARGUMENTS
#endif
#undef limn_POM_NAME
#ifdef POM_NAME_ID
#define limn_POM_NAME CALL_MERGE_NAME(ParallaxOcclusionMapping, POM_NAME_ID)
#else
#define limn_POM_NAME ParallaxOcclusionMapping
#endif

// Gives what to add to the texture coordinates. viewDirTS: scaled by the depth of the map.
float2 limn_POM_NAME(float lod, float lodThreshold, int numSteps, float3 viewDirTS,
                     PerPixelHeightDisplacementParam ppdParam,
                     out float outHeight POM_USER_DATA_PARAMETERS)
{
    float2 deepest = viewDirTS.xy / -viewDirTS.z;
    float stepSize = 1.0 / (float)numSteps;
    float above = 1.0;
    float below = 1.0 - stepSize;
    float heightAbove =
        ComputePerPixelHeightDisplacement(float2(0, 0), lod, ppdParam POM_USER_DATA_ARGUMENTS);
    float heightBelow = ComputePerPixelHeightDisplacement(stepSize * deepest, lod,
                                                          ppdParam POM_USER_DATA_ARGUMENTS);
    for (int i = 0; i < numSteps && heightBelow <= below; ++i)
    {
        above = below;
        heightAbove = heightBelow;
        below -= stepSize;
        heightBelow = ComputePerPixelHeightDisplacement((1.0 - below) * deepest, lod,
                                                        ppdParam POM_USER_DATA_ARGUMENTS);
    }

    float gapAbove = above - heightAbove;
    float gapBelow = below - heightBelow;
    float2 offset = float2(0, 0);
    outHeight = heightBelow;
    for (int j = 0; j < 3; ++j)
    {
        float hit = (above * gapBelow - below * gapAbove) / (gapBelow - gapAbove);
        offset = (1.0 - hit) * deepest;
        outHeight =
            ComputePerPixelHeightDisplacement(offset, lod, ppdParam POM_USER_DATA_ARGUMENTS);
        float gap = hit - outHeight;
        if (abs(gap) <= 0.01)
        {
            break;
        }
        if (gap < 0.0)
        {
            gapBelow = gap;
            below = hit;
        }
        else
        {
            gapAbove = gap;
            above = hit;
        }
    }
    return offset * (1.0 - saturate(lod - lodThreshold));
}
