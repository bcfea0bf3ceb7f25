Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Pass Zero
                Fail Replace
                ZFail IncrSat
            }
        }
    }
}
