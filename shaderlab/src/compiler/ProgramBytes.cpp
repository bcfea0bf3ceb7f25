#include "compiler/ProgramBytes.h"

namespace limn
{

namespace
{

// One description of the format serves both directions: Stream is ByteWriter or ByteReader, and the
// values are const for the one and not for the other.
template <typename Stream, typename Members>
void TransferMembers(Stream& stream, Members& members)
{
    stream.List(members,
                [&](auto& member)
                {
                    stream.Values(member.name, member.type, member.components, member.offset,
                                  member.size, member.arraySize, member.arrayStride);
                });
}

template <typename Stream, typename Item>
void TransferHead(Stream& stream, Item& item)
{
    stream.Values(item.name, item.stages, item.binding);
}

template <typename Stream, typename Layout>
void TransferLayout(Stream& stream, Layout& layout)
{
    stream.List(layout.buffers,
                [&](auto& buffer)
                {
                    TransferHead(stream, buffer);
                    stream.Value(buffer.size);
                    TransferMembers(stream, buffer.members);
                });
    stream.List(layout.textures,
                [&](auto& texture)
                {
                    TransferHead(stream, texture);
                    stream.Values(texture.dimension, texture.multisampled, texture.combinedSampler,
                                  texture.type);
                });
    stream.List(layout.samplers,
                [&](auto& sampler)
                {
                    TransferHead(stream, sampler);
                    stream.Value(sampler.comparison);
                });
    stream.List(layout.storageBuffers,
                [&](auto& buffer)
                {
                    TransferHead(stream, buffer);
                    stream.Values(buffer.stride, buffer.isWritten, buffer.isCounter);
                });
    stream.List(layout.storageTextures,
                [&](auto& texture)
                {
                    TransferHead(stream, texture);
                    stream.Values(texture.dimension, texture.type, texture.isRead);
                });
    stream.List(layout.vertexInputs, [&](auto& input)
                { stream.Values(input.semantic, input.location, input.type, input.components); });
    stream.Value(layout.colorOutputs);
    stream.List(layout.outputTypes, [&](auto& type) { stream.Value(type); });
    stream.Values(layout.geometryInput, layout.pushStages, layout.fragmentHasInputs);
}

template <typename Stream, typename Pass>
void TransferPass(Stream& stream, Pass& pass)
{
    for (auto* words :
         {&pass.vertexSpirv, &pass.geometrySpirv, &pass.fragmentSpirv, &pass.computeSpirv})
    {
        stream.List(*words, [&](auto& word) { stream.Value(word); });
    }
    for (auto& size : pass.threadGroupSize)
    {
        stream.Value(size);
    }
    TransferLayout(stream, pass.layout);
    stream.List(pass.diagnostics,
                [&](auto& diagnostic)
                {
                    stream.Values(diagnostic.severity, diagnostic.file, diagnostic.location.line,
                                  diagnostic.location.column, diagnostic.message);
                });
}

template <typename Stream, typename Dependencies>
void TransferDependencies(Stream& stream, Dependencies& dependencies)
{
    stream.List(dependencies,
                [&](auto& dependency) { stream.Values(dependency.path, dependency.contentHash); });
}

template <typename Stream, typename Files>
void TransferFiles(Stream& stream, Files& files)
{
    stream.List(files, [&](auto& file) { stream.Values(file.name, file.text); });
}

template <typename Stream, typename Place>
void TransferPlaced(Stream& stream, Place& place)
{
    stream.Values(place.name, place.location.line, place.location.column);
}

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

} // namespace

void Transfer(ByteWriter& stream, const ShaderProgram& program)
{
    TransferPass(stream, program);
}

void Transfer(ByteWriter& stream, const PassProgram& program)
{
    TransferSource(stream, program);
}

void Transfer(ByteWriter& stream, const std::vector<IncludeDependency>& dependencies)
{
    TransferDependencies(stream, dependencies);
}

void Transfer(ByteReader& stream, ShaderProgram& program)
{
    TransferPass(stream, program);
}

void Transfer(ByteReader& stream, PassProgram& program)
{
    TransferSource(stream, program);
}

void Transfer(ByteReader& stream, std::vector<IncludeDependency>& dependencies)
{
    TransferDependencies(stream, dependencies);
}

void Transfer(ByteWriter& stream, const FilesBeside& files)
{
    TransferFiles(stream, files);
}

void Transfer(ByteReader& stream, FilesBeside& files)
{
    TransferFiles(stream, files);
}

} // namespace limn
