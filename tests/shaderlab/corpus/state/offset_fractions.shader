Shader "T"
{
    SubShader
    {
        Pass
        {
            Offset -.5,-.5
        }
    }
}
