#include "compiler/WorkerMessages.h"

#include "compiler/ProgramBytes.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <sys/socket.h>

namespace limn
{

namespace
{

/// The message that carries a descriptor from one process to another: one byte and the descriptor.
struct DescriptorMessage
{
    char byte = 0;
    iovec bytes{&byte, 1};
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
    msghdr header{};

    DescriptorMessage()
    {
        header.msg_iov = &bytes;
        header.msg_iovlen = 1;
        header.msg_control = control;
        header.msg_controllen = sizeof(control);
    }
    DescriptorMessage(const DescriptorMessage&) = delete;
    DescriptorMessage& operator=(const DescriptorMessage&) = delete;
};

bool SendAll(int socket, std::string_view bytes)
{
    while (!bytes.empty())
    {
        const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR)
        {
            return false;
        }
        bytes.remove_prefix(sent < 0 ? 0 : static_cast<std::size_t>(sent));
    }
    return true;
}

/// Returns fewer bytes where the other side stops sending.
std::string Receive(int socket, std::uint64_t size)
{
    std::string bytes;
    char buffer[1 << 16];
    while (bytes.size() < size)
    {
        const std::size_t wanted = std::min<std::uint64_t>(size - bytes.size(), sizeof(buffer));
        const ssize_t received = recv(socket, buffer, wanted, 0);
        if (received == 0 || (received < 0 && errno != EINTR))
        {
            break;
        }
        bytes.append(buffer, received < 0 ? 0 : static_cast<std::size_t>(received));
    }
    return bytes;
}

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
    stream.Values(answer.outcome, answer.isLast, answer.waitStatus);
    Transfer(stream, answer.dependencies);
    Transfer(stream, answer.program);
}

void Transfer(ByteReader& stream, CompilerAnswer& answer)
{
    stream.Values(answer.outcome, answer.isLast, answer.waitStatus);
    Transfer(stream, answer.dependencies);
    Transfer(stream, answer.program);
}

bool SendMessage(int socket, std::string_view bytes)
{
    const std::uint64_t size = bytes.size();
    const std::string_view header(reinterpret_cast<const char*>(&size), sizeof(size));
    return SendAll(socket, header) && SendAll(socket, bytes);
}

std::optional<std::string> ReceiveMessage(int socket)
{
    std::uint64_t size = 0;
    const std::string header = Receive(socket, sizeof(size));
    if (header.size() < sizeof(size))
    {
        return std::nullopt;
    }
    std::memcpy(&size, header.data(), sizeof(size));
    std::string bytes = Receive(socket, size);
    return bytes.size() == size ? std::optional(std::move(bytes)) : std::nullopt;
}

bool SendDescriptor(int socket, int descriptor)
{
    DescriptorMessage message;
    cmsghdr* const part = CMSG_FIRSTHDR(&message.header);
    part->cmsg_level = SOL_SOCKET;
    part->cmsg_type = SCM_RIGHTS;
    part->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(part), &descriptor, sizeof(int));
    return sendmsg(socket, &message.header, MSG_NOSIGNAL) == 1;
}

int ReceiveDescriptor(int socket)
{
    DescriptorMessage message;
    ssize_t size = -1;
    do
    {
        size = recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC);
    } while (size < 0 && errno == EINTR);
    const cmsghdr* const part = size == 1 ? CMSG_FIRSTHDR(&message.header) : nullptr;
    int descriptor = -1;
    if (part)
    {
        std::memcpy(&descriptor, CMSG_DATA(part), sizeof(int));
    }
    return descriptor;
}

} // namespace limn
