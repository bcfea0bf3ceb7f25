#include "compiler/WorkerMessages.h"

#include "compiler/ProgramBytes.h"

namespace limn
{

namespace
{

void TransferPath(ByteWriter& stream, const std::filesystem::path& path)
{
    stream.Value(path.string());
}

void TransferPath(ByteReader& stream, std::filesystem::path& path)
{
    std::string text;
    stream.Value(text);
    path = text;
}

} // namespace

void Transfer(ByteWriter& stream, const CompilerRequest& request)
{
    Transfer(stream, request.program);
    stream.List(request.keywords, [&](const std::string& keyword) { stream.Value(keyword); });
    const auto& packages = request.options.packages;
    stream.List(std::vector(packages.begin(), packages.end()),
                [&](const auto& package)
                {
                    stream.Value(package.first);
                    TransferPath(stream, package.second);
                });
    TransferPath(stream, request.options.projectRoot);
    stream.List(request.options.includeFolders,
                [&](const std::filesystem::path& folder) { TransferPath(stream, folder); });
    stream.Value(request.options.timeLimit.count());
    Transfer(stream, request.filesBeside);
}

void Transfer(ByteReader& stream, CompilerRequest& request)
{
    Transfer(stream, request.program);
    stream.List(request.keywords, [&](std::string& keyword) { stream.Value(keyword); });
    std::vector<std::pair<std::string, std::filesystem::path>> packages;
    stream.List(packages,
                [&](auto& package)
                {
                    stream.Value(package.first);
                    TransferPath(stream, package.second);
                });
    request.options.packages.insert(packages.begin(), packages.end());
    TransferPath(stream, request.options.projectRoot);
    stream.List(request.options.includeFolders,
                [&](std::filesystem::path& folder) { TransferPath(stream, folder); });
    std::chrono::milliseconds::rep limit = 0;
    stream.Value(limit);
    request.options.timeLimit = std::chrono::milliseconds(limit);
    Transfer(stream, request.filesBeside);
}

void Transfer(ByteWriter& stream, const CompilerAnswer& answer)
{
    stream.Value(answer.outcome);
    Transfer(stream, answer.dependencies);
    Transfer(stream, answer.program);
}

void Transfer(ByteReader& stream, CompilerAnswer& answer)
{
    stream.Value(answer.outcome);
    Transfer(stream, answer.dependencies);
    Transfer(stream, answer.program);
}

} // namespace limn
