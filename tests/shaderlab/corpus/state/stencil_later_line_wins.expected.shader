Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Ref 2
                Comp Equal
                Pass Replace
            }
        }
    }
}
