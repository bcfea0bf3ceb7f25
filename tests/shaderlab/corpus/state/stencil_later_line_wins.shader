Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                CompFront Less
                Comp Equal
                Pass Zero
                Pass Replace
                Ref 1
                Ref 2
            }
        }
    }
}
