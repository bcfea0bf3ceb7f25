Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                ReadMask 44
                WriteMask 231
            }
        }
    }
}
