Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Ref 1
                Comp Equal
            }
        }
        Pass
        {
            Stencil
            {
                Pass Zero
            }
        }
    }
}
