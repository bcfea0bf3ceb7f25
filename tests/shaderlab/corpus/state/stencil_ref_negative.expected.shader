Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Ref 255
            }
        }
    }
}
