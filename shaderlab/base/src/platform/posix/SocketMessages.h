#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace limn
{

// The messages between a WorkerProcess and its workers.

/// Sends the number of bytes and the bytes. Returns false if the other side is gone.
bool SendMessage(int socket, std::string_view bytes);
/// Receives a message; returns nullopt if the other side is gone.
std::optional<std::string> ReceiveMessage(int socket);

/// A file descriptor that one process sends to another, with a number.
struct SentDescriptor
{
    int descriptor = -1; ///< -1 where the other side is gone
    std::uint64_t number = 0;
};

/// Returns false where the other side is gone.
bool SendDescriptor(int socket, const SentDescriptor& sent);
SentDescriptor ReceiveDescriptor(int socket);

/// Runs the process of a WorkerProcess: starts a worker for each socket that it receives, until the
/// other side is gone.
[[noreturn]] void ServeWorkers(int requests);

/// The kinds of messages that a worker sends, or that are sent for it.
enum class WorkerMessage : char
{
    Answer,
    LastAnswer, ///< the worker takes no further request
    Ended       ///< a status as waitpid gives it follows
};

} // namespace limn
