Shader "Test/Glow" { SubShader { Pass { Name "Glow" } } }
