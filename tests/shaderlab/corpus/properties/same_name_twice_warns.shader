Shader "T"
{
    Properties
    {
        [Drawer] _D("a", Float) = 1
        _D("b", Float) = 2
    }
}
