Shader "Test/Plain" { SubShader { Pass { Name "Plain" } } }
