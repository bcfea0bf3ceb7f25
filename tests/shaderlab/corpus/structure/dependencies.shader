Shader "T"
{
    Dependency "BaseMapShader" = "Hidden/Base"
    Dependency "AddPassShader" = "Hidden/Add"
}
