// Entry points of a full-screen pass that draws one triangle.
#pragma once

PackedVaryings vert(Attributes input)
{
    Varyings output = (Varyings)0;
    output.positionCS = GetDrawProceduralVertexPosition(input.vertexID);
    BuildVaryings(input, output);
    return PackVaryings(output);
}

FragOutput frag(PackedVaryings packedInput)
{
    return DefaultFullscreenFragmentShader(packedInput);
}
