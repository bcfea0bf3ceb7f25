Shader "T"
{
    CustomEditorForRenderPipeline "A.B" "C.D"
    CustomEditorForRenderPipeline "E" ""
}
