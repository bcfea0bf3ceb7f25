Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Comp LEqual
            }
        }
    }
}
