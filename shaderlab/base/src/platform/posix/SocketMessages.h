#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

// What a WorkerProcess and its workers send to each other.

/// Sends the number of bytes and the bytes. Returns false where the other side is gone.
bool SendMessage(int socket, std::string_view bytes);
/// Returns nothing where the other side is gone.
std::optional<std::string> ReceiveMessage(int socket);

/// A file descriptor that goes from one process to another, and a number with it.
struct SentDescriptor
{
    int descriptor = -1; ///< -1 where the other side is gone
    std::uint64_t number = 0;
};

/// Returns false where the other side is gone.
bool SendDescriptor(int socket, const SentDescriptor& sent);
SentDescriptor ReceiveDescriptor(int socket);

/// The whole life of the process of a WorkerProcess: starts a worker for each socket that comes,
/// until the other side is gone.
[[noreturn]] void ServeWorkers(int requests);

/// The last thing that a worker sends, or that is sent for it.
enum class WorkerMessage : char
{
    Answer,
    LastAnswer, ///< the worker takes no further request
    Ended       ///< a status as waitpid gives it follows
};

} // namespace limn
