Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Comp Equal
                Pass Zero
            }
        }
    }
}
