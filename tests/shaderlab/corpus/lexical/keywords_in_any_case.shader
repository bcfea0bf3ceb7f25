SHADER "T"
{
    subshader
    {
        pass
        {
            zwrite OFF
            COLORMASK rgb
        }
    }
    FallBack "X"
}
