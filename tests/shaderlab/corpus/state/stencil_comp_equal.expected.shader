Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Comp Equal
            }
        }
    }
}
