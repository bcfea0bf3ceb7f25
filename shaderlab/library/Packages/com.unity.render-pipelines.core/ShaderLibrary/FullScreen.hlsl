// One triangle that covers the target, and a quad, from SV_VertexID alone.
#pragma once

// 0, 1, 2: (-1,-1), (3,-1), (-1,3)
float4 GetFullScreenTriangleVertexPosition(uint vertexID, float z = UNITY_NEAR_CLIP_VALUE)
{
    float2 corner = float2(vertexID == 1 ? 3.0 : -1.0, vertexID == 2 ? 3.0 : -1.0);
    return float4(corner, z, 1.0);
}

// 0, 1, 2: (0,1), (2,1), (0,-1): v = 0 is the top row
float2 GetFullScreenTriangleTexCoord(uint vertexID)
{
    return float2(vertexID == 1 ? 2.0 : 0.0, vertexID == 2 ? -1.0 : 1.0);
}

// 0...3: (0,1), (0,0), (1,0), (1,1), in 0...1
float4 GetQuadVertexPosition(uint vertexID, float z = UNITY_NEAR_CLIP_VALUE)
{
    float x = vertexID >= 2 ? 1.0 : 0.0;
    float y = vertexID == 0 || vertexID == 3 ? 1.0 : 0.0;
    return float4(x, y, z, 1.0);
}

// The same corners: y points down where a quad's corners become clip space, as v does.
float2 GetQuadTexCoord(uint vertexID)
{
    return GetQuadVertexPosition(vertexID, UNITY_NEAR_CLIP_VALUE).xy;
}
