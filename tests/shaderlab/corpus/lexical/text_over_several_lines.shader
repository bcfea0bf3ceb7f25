Shader "T"
{
    Properties
    {
        _A("A {
  'json': [1, 2]
}", Float) = 1
    }
}
