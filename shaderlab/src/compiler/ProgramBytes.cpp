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
                    stream.Value(member.name);
                    stream.Value(member.type);
                    stream.Value(member.components);
                    stream.Value(member.offset);
                    stream.Value(member.size);
                    stream.Value(member.arraySize);
                    stream.Value(member.arrayStride);
                });
}

template <typename Stream, typename Item>
void TransferHead(Stream& stream, Item& item)
{
    stream.Value(item.name);
    stream.Value(item.stages);
    stream.Value(item.binding);
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
                    stream.Value(texture.dimension);
                    stream.Value(texture.multisampled);
                    stream.Value(texture.combinedSampler);
                    stream.Value(texture.type);
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
                    stream.Value(buffer.stride);
                    stream.Value(buffer.isWritten);
                    stream.Value(buffer.isCounter);
                });
    stream.List(layout.storageTextures,
                [&](auto& texture)
                {
                    TransferHead(stream, texture);
                    stream.Value(texture.dimension);
                    stream.Value(texture.type);
                    stream.Value(texture.isRead);
                });
    stream.List(layout.vertexInputs,
                [&](auto& input)
                {
                    stream.Value(input.semantic);
                    stream.Value(input.location);
                    stream.Value(input.type);
                    stream.Value(input.components);
                });
    stream.Value(layout.colorOutputs);
    stream.List(layout.outputTypes, [&](auto& type) { stream.Value(type); });
    stream.Value(layout.geometryInput);
    stream.Value(layout.pushStages);
    stream.Value(layout.fragmentHasInputs);
}

template <typename Stream, typename Pass>
void TransferPass(Stream& stream, Pass& pass)
{
    const auto word = [&](auto& value)
    {
        stream.Value(value);
    };
    stream.List(pass.vertexSpirv, word);
    stream.List(pass.geometrySpirv, word);
    stream.List(pass.fragmentSpirv, word);
    stream.List(pass.computeSpirv, word);
    for (auto& size : pass.threadGroupSize)
    {
        stream.Value(size);
    }
    TransferLayout(stream, pass.layout);
    stream.List(pass.diagnostics,
                [&](auto& diagnostic)
                {
                    stream.Value(diagnostic.severity);
                    stream.Value(diagnostic.file);
                    stream.Value(diagnostic.location.line);
                    stream.Value(diagnostic.location.column);
                    stream.Value(diagnostic.message);
                });
}

template <typename Stream, typename Dependencies>
void TransferDependencies(Stream& stream, Dependencies& dependencies)
{
    stream.List(dependencies,
                [&](auto& dependency)
                {
                    stream.Value(dependency.path);
                    stream.Value(dependency.contentHash);
                });
}

template <typename Stream, typename Files>
void TransferFiles(Stream& stream, Files& files)
{
    stream.List(files,
                [&](auto& file)
                {
                    stream.Value(file.name);
                    stream.Value(file.text);
                });
}

template <typename Stream, typename Place>
void TransferPlaced(Stream& stream, Place& place)
{
    stream.Value(place.name);
    stream.Value(place.location.line);
    stream.Value(place.location.column);
}

template <typename Stream, typename Program>
void TransferSource(Stream& stream, Program& program)
{
    stream.Value(program.file);
    stream.Value(program.location.line);
    stream.Value(program.location.column);
    stream.Value(program.language);
    stream.List(program.chunks,
                [&](auto& chunk)
                {
                    stream.Value(chunk.text);
                    stream.Value(chunk.firstLine);
                });
    TransferPlaced(stream, program.vertex);
    TransferPlaced(stream, program.fragment);
    TransferPlaced(stream, program.geometry);
    TransferPlaced(stream, program.kernel);
    stream.Value(program.target);
    stream.List(program.keywordSets,
                [&](auto& set)
                {
                    stream.Value(set.location.line);
                    stream.Value(set.location.column);
                    stream.Value(set.directive);
                    stream.List(set.keywords, [&](auto& keyword) { stream.Value(keyword); });
                    stream.Value(set.stages);
                    stream.Value(set.isLocal);
                    stream.Value(set.isFeature);
                    stream.Value(set.isDynamic);
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
