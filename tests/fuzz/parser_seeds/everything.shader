Shader "Folder/Name" {
    HLSLINCLUDE
    #pragma multi_compile _ A
    ENDHLSL
    Properties {
        [HDR][MainColor] _C ("c", Color) = (1,.5,0)
        _R ("r", Range(-1, 10)) = 3
        _T ("t", 2D) = "white" { TexGen CubeReflect }
        _I ("i", Integer) = 2
    }
    Category {
        Tags { "Queue" = "Geometry+1" } LOD 200 Cull Off
        SubShader {
            PackageRequirements { "com.unity.x" : "1.2" "y" }
            Tags { RenderType = Opaque }
            UsePass "A/B"
            GrabPass { "_G" }
            ZWrite Off
            Pass {
                Name "X"
                Tags { "LightMode" = "Meta" }
                ZTest [_Z] Offset -1, [_U] Blend 1 One [_D], Zero One BlendOp Max, Min
                ColorMask RG 3 AlphaToMask On Conservative True ZClip False
                Stencil { Ref 5 ReadMask 15 CompFront Equal PassBack Invert ZFail DecrSat }
                HLSLPROGRAM
                #pragma vertex v
                #pragma fragment f
                float4 v() { return 0; } // }
                ENDHLSL
            }
        }
    }
    Fallback "Diffuse", 1
    CustomEditor "E"
    CustomEditorForRenderPipeline "E" "P"
    Dependency "A" = "B"
}
