Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Comp Greater
            }
        }
    }
}
