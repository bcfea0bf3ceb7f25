Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Pass DecrSat
                Fail Invert
                ZFail IncrWrap
            }
        }
    }
}
