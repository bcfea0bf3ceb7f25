Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                CompFront Equal
                PassBack Replace
                FailFront Zero
                ZFailBack Invert
            }
        }
    }
}
