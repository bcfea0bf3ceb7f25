Shader "T"
{
    SubShader
    {
        UsePass "Legacy Shaders/VertexLit/SHADOWCASTER"
        Pass
        {
        }
        UsePass "A/b"
    }
}
