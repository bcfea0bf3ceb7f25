Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                Ref 5
                ReadMask 15
                WriteMask 0
            }
        }
    }
}
