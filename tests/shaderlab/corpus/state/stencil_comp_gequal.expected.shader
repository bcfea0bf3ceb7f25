Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Comp GEqual
            }
        }
    }
}
