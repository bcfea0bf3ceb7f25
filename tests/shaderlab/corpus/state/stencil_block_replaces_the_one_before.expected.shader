Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Pass Zero
            }
        }
    }
}
