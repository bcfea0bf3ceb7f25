Shader "T"
{
    SubShader
    {
        Pass
        {
            Stencil
            {
                CompFront Equal
                CompBack Equal
                PassFront Zero
                PassBack Zero
            }
        }
    }
}
