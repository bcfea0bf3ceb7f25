// Entry points of a full-screen pass that draws a quad.
#pragma once

PackedVaryings vert(Attributes input)
{
    Varyings output = (Varyings)0;
    output.positionCS = GetBlitVertexPosition(input.vertexID);
    BuildVaryings(input, output);
    return PackVaryings(output);
}

FragOutput frag(PackedVaryings packedInput)
{
    return DefaultFullscreenFragmentShader(packedInput);
}
