Shader "T"
{
    SubShader
    {
        Pass
        {
            Blend[_S][_D],[_SA][_DA]
            BlendOp[_O],[_OA]
            ZTest[_Z]
        }
    }
}
