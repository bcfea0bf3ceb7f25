Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend 0 One One
            Blend 7 SrcAlpha OneMinusSrcAlpha, One Zero
        }
    }
}
