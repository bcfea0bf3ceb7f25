Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Comp NotEqual
            }
        }
    }
}
