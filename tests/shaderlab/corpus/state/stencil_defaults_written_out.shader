Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Ref 0
                ReadMask 255
                WriteMask 255
                Comp Always
                Pass Keep
                Fail Keep
                ZFail Keep
            }
        }
    }
}
