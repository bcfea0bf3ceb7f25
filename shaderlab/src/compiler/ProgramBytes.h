#pragma once

#include <limn/shaderlab/PassProgram.h>
#include <limn/shaderlab/ShaderProgram.h>

#include "includes/IncludeResolver.h"
#include <limn/base/ByteStream.h>

namespace limn
{

// Converts the data of the cache and of messages between processes to bytes, for this version of
// limn on this machine. Reading throws std::out_of_range if the bytes are invalid. One description
// of the format serves both directions: Stream is ByteWriter or ByteReader, and the values may be
// const for the one and not for the other.

template <typename Stream, typename Layout>
void TransferLayout(Stream& stream, Layout& layout)
{
    const auto members = [&](auto& member)
    {
        stream.Values(member.name, member.type, member.components, member.offset, member.size,
                      member.arraySize, member.arrayStride);
    };
    stream.List(layout.buffers,
                [&](auto& item)
                {
                    stream.Values(item.name, item.stages, item.binding, item.size);
                    stream.List(item.members, members);
                });
    stream.List(layout.textures,
                [&](auto& item)
                {
                    stream.Values(item.name, item.stages, item.binding, item.dimension,
                                  item.multisampled, item.combinedSampler, item.type);
                });
    stream.List(layout.samplers, [&](auto& item)
                { stream.Values(item.name, item.stages, item.binding, item.comparison); });
    stream.List(layout.storageBuffers,
                [&](auto& item)
                {
                    stream.Values(item.name, item.stages, item.binding, item.stride, item.isWritten,
                                  item.isCounter);
                });
    stream.List(layout.storageTextures,
                [&](auto& item) {
                    stream.Values(item.name, item.stages, item.binding, item.dimension, item.type,
                                  item.isRead);
                });
    stream.List(layout.vertexInputs, [&](auto& input)
                { stream.Values(input.semantic, input.location, input.type, input.components); });
    stream.Value(layout.colorOutputs);
    stream.List(layout.outputTypes, [&](auto& type) { stream.Value(type); });
    stream.Values(layout.geometryInput, layout.pushStages, layout.fragmentHasInputs);
}

/// Transfers a ShaderProgram.
template <typename Stream, typename Program>
void TransferProgram(Stream& stream, Program& program)
{
    for (auto* words : {&program.vertexSpirv, &program.geometrySpirv, &program.fragmentSpirv,
                        &program.computeSpirv})
    {
        stream.List(*words, [&](auto& word) { stream.Value(word); });
    }
    auto& size = program.threadGroupSize;
    stream.Values(size[0], size[1], size[2]);
    TransferLayout(stream, program.layout);
    stream.List(program.diagnostics,
                [&](auto& diagnostic)
                {
                    stream.Values(diagnostic.severity, diagnostic.file, diagnostic.location.line,
                                  diagnostic.location.column, diagnostic.message);
                });
}

/// Transfers a list of IncludeDependency.
template <typename Stream, typename Dependencies>
void TransferDependencies(Stream& stream, Dependencies& dependencies)
{
    stream.List(dependencies,
                [&](auto& dependency) { stream.Values(dependency.path, dependency.contentHash); });
}

template <typename Stream, typename Place>
void TransferPlaced(Stream& stream, Place& place)
{
    stream.Values(place.name, place.location.line, place.location.column);
}

/// Transfers a PassProgram.
template <typename Stream, typename Program>
void TransferSource(Stream& stream, Program& program)
{
    stream.Values(program.file, program.location.line, program.location.column, program.language);
    stream.List(program.chunks, [&](auto& chunk) { stream.Values(chunk.text, chunk.firstLine); });
    TransferPlaced(stream, program.vertex);
    TransferPlaced(stream, program.fragment);
    TransferPlaced(stream, program.geometry);
    TransferPlaced(stream, program.kernel);
    stream.Value(program.target);
    stream.List(program.keywordSets,
                [&](auto& set)
                {
                    stream.Values(set.location.line, set.location.column, set.directive);
                    stream.List(set.keywords, [&](auto& keyword) { stream.Value(keyword); });
                    stream.Values(set.stages, set.isLocal, set.isFeature, set.isDynamic);
                });
    stream.List(program.pragmas,
                [&](auto& pragma)
                {
                    TransferPlaced(stream, pragma);
                    stream.Value(pragma.arguments);
                });
}

} // namespace limn
