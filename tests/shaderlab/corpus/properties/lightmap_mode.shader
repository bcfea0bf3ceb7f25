Shader "T"
{
    Properties
    {
        _A("a", 2D) = "white" { LightmapMode }
    }
}
