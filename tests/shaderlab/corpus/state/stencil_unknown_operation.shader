Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil { Pass Replcae }
        }
    }
}
