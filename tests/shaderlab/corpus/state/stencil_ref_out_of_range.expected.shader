Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
            }
        }
    }
}
