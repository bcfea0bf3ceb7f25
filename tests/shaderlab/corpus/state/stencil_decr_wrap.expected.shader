Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Pass DecrWrap
            }
        }
    }
}
