#include "platform/posix/SocketMessages.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/socket.h>

namespace limn
{

namespace
{

/// The message that carries a descriptor from one process to another: a number and the descriptor.
struct DescriptorMessage
{
    std::uint64_t number = 0;
    iovec bytes{&number, sizeof(number)};
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

/// Returns fewer bytes where the other side stops sending. Memory is taken as bytes come, not by
/// what a broken size says.
std::string Receive(int socket, std::uint64_t size)
{
    constexpr std::uint64_t k_Part = 1 << 20;
    std::string bytes;
    std::size_t count = 0;
    while (count < size)
    {
        if (count == bytes.size())
        {
            bytes.resize(std::min(size, std::max(k_Part, std::uint64_t{2} * count)));
        }
        const ssize_t received = recv(socket, bytes.data() + count, bytes.size() - count, 0);
        if (received == 0 || (received < 0 && errno != EINTR))
        {
            break;
        }
        count += received < 0 ? 0 : static_cast<std::size_t>(received);
    }
    bytes.resize(count);
    return bytes;
}

} // namespace

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

bool SendDescriptor(int socket, const SentDescriptor& sent)
{
    DescriptorMessage message;
    message.number = sent.number;
    cmsghdr* const part = CMSG_FIRSTHDR(&message.header);
    part->cmsg_level = SOL_SOCKET;
    part->cmsg_type = SCM_RIGHTS;
    part->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(part), &sent.descriptor, sizeof(int));
    return sendmsg(socket, &message.header, MSG_NOSIGNAL) ==
           static_cast<ssize_t>(sizeof(message.number));
}

SentDescriptor ReceiveDescriptor(int socket)
{
    DescriptorMessage message;
    ssize_t size = -1;
    do
    {
        size = recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC);
    } while (size < 0 && errno == EINTR);
    SentDescriptor sent;
    const cmsghdr* const part = size == static_cast<ssize_t>(sizeof(message.number))
                                    ? CMSG_FIRSTHDR(&message.header)
                                    : nullptr;
    if (part)
    {
        std::memcpy(&sent.descriptor, CMSG_DATA(part), sizeof(int));
        sent.number = message.number;
    }
    return sent;
}

} // namespace limn
