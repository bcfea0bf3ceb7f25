float4 x;
