// How much of a pixel's square a straight edge leaves, and where the edge is that leaves so much.
#pragma once

// The part of a square of side 1 that is behind a straight edge.
// normal: of the edge, unit length; depth: how far the square's centre is behind it.
float BoxCoverage(float2 normal, float depth)
{
    float large = max(abs(normal.x), abs(normal.y));
    float small = min(abs(normal.x), abs(normal.y));
    float aside = abs(depth);
    float rest = max((large + small) * 0.5 - aside, 0.0);
    // Within the corners a triangle is left, between them the part grows evenly.
    float outside = aside > (large - small) * 0.5 ? rest * rest / max(2.0 * large * small, 1e-12)
                                                  : 0.5 - aside / large;
    return depth > 0.0 ? 1.0 - outside : outside;
}

// The depth for which BoxCoverage gives `coverage`.
float BoxDepth(float2 normal, float coverage)
{
    float large = max(abs(normal.x), abs(normal.y));
    float small = min(abs(normal.x), abs(normal.y));
    float less = min(coverage, 1.0 - coverage);
    float outside = less * 2.0 * large < small
        ? (large + small) * 0.5 - sqrt(2.0 * large * small * less)
        : (0.5 - less) * large;
    return coverage > 0.5 ? outside : -outside;
}
