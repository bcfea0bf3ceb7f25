// How much of a pixel something covers, exactly for straight borders.
#pragma once

// The share of a pixel that lies on the near side of a straight border.
// distance: of the border from the pixel's centre along the normal, pixels; negative = the centre
//           is beyond it
// normal:   of the border, unit length
float PixelCoverage(float distance, float2 normal)
{
    float2 slope = abs(normal);
    float a = max(slope.x, slope.y);
    float b = min(slope.x, slope.y);
    float t = abs(distance);
    float corner = max(0.5 * (a + b) - t, 0.0); // how far the pixel's farthest corner is beyond it
    // Where both corners of a side are beyond it, the rest is a trapezium, else all but a triangle.
    float trapezium = 0.5 + t / max(a, 1e-6);
    float triangleLeft = 1.0 - corner * corner / max(2.0 * a * b, 1e-6);
    float covered = min(t <= 0.5 * (a - b) ? trapezium : triangleLeft, 1.0);
    return distance < 0.0 ? 1.0 - covered : covered;
}
