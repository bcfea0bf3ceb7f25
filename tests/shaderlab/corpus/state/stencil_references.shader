Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Ref [_Ref]
                ReadMask [_R]
                WriteMask [_W]
                Comp [_Comp]
                Pass [_Pass]
                Fail [_Fail]
                ZFail [_ZFail]
            }
        }
    }
}
