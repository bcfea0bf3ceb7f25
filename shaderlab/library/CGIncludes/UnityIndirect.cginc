// The arguments of indirect draws. Those in a buffer of the shader's own are read from there; limn does
// not hand a draw's own to its shader.
#pragma once
#ifndef UNITY_INDIRECT_INCLUDED
#define UNITY_INDIRECT_INCLUDED

uint GetCommandID(uint svDrawID) { return svDrawID; }

struct IndirectDrawArgs
{
    uint vertexCountPerInstance;
    uint instanceCount;
    uint startVertex;
    uint startInstance;
};
void GetIndirectDrawArgs(out IndirectDrawArgs args, ByteAddressBuffer argsBuffer, uint commandId)
{
    uint4 words = argsBuffer.Load4(commandId * 16);
    args.vertexCountPerInstance = words.x;
    args.instanceCount = words.y;
    args.startVertex = words.z;
    args.startInstance = words.w;
}
uint GetIndirectInstanceCount(IndirectDrawArgs args) { return args.instanceCount; }
uint GetIndirectVertexCount(IndirectDrawArgs args) { return args.vertexCountPerInstance; }
// In Vulkan SV_InstanceID and SV_VertexID start where the draw does.
uint GetIndirectInstanceID(IndirectDrawArgs args, uint svInstanceID)
{
    return svInstanceID - args.startInstance;
}
uint GetIndirectInstanceID_Base(IndirectDrawArgs args, uint svInstanceID) { return svInstanceID; }
uint GetIndirectVertexID(IndirectDrawArgs args, uint svVertexID)
{
    return svVertexID - args.startVertex;
}
uint GetIndirectVertexID_Base(IndirectDrawArgs args, uint svVertexID) { return svVertexID; }

struct IndirectDrawIndexedArgs
{
    uint indexCountPerInstance;
    uint instanceCount;
    uint startIndex;
    uint baseVertexIndex;
    uint startInstance;
};
void GetIndirectDrawArgs(out IndirectDrawIndexedArgs args, ByteAddressBuffer argsBuffer,
                         uint commandId)
{
    uint4 words = argsBuffer.Load4(commandId * 20);
    args.indexCountPerInstance = words.x;
    args.instanceCount = words.y;
    args.startIndex = words.z;
    args.baseVertexIndex = words.w;
    args.startInstance = argsBuffer.Load(commandId * 20 + 16);
}
uint GetIndirectInstanceCount(IndirectDrawIndexedArgs args) { return args.instanceCount; }
uint GetIndirectVertexCount(IndirectDrawIndexedArgs args) { return args.indexCountPerInstance; }
uint GetIndirectInstanceID(IndirectDrawIndexedArgs args, uint svInstanceID)
{
    return svInstanceID - args.startInstance;
}
uint GetIndirectInstanceID_Base(IndirectDrawIndexedArgs args, uint svInstanceID)
{
    return svInstanceID;
}
uint GetIndirectVertexID(IndirectDrawIndexedArgs args, uint svVertexID) { return svVertexID; }
uint GetIndirectVertexID_Base(IndirectDrawIndexedArgs args, uint svVertexID)
{
    return svVertexID + args.startIndex;
}

#ifdef UNITY_INDIRECT_DRAW_ARGS
static UNITY_INDIRECT_DRAW_ARGS globalIndirectDrawArgs;
[limn_Lacks("the arguments of an indirect draw in its shader", "they are 0 there")]
void InitIndirectDrawArgs(uint svDrawID)
{
    globalIndirectDrawArgs = (UNITY_INDIRECT_DRAW_ARGS)0;
}
uint GetIndirectInstanceCount() { return GetIndirectInstanceCount(globalIndirectDrawArgs); }
uint GetIndirectVertexCount() { return GetIndirectVertexCount(globalIndirectDrawArgs); }
uint GetIndirectInstanceID(uint svInstanceID)
{
    return GetIndirectInstanceID(globalIndirectDrawArgs, svInstanceID);
}
uint GetIndirectInstanceID_Base(uint svInstanceID)
{
    return GetIndirectInstanceID_Base(globalIndirectDrawArgs, svInstanceID);
}
uint GetIndirectVertexID(uint svVertexID)
{
    return GetIndirectVertexID(globalIndirectDrawArgs, svVertexID);
}
uint GetIndirectVertexID_Base(uint svVertexID)
{
    return GetIndirectVertexID_Base(globalIndirectDrawArgs, svVertexID);
}
#endif
#endif
