Shader "T"
{
    Properties
    {
        [Enum(OFF, 0, ON, 1,] _TransparentEnabled("Transparent", Int) = 0
    }
}
