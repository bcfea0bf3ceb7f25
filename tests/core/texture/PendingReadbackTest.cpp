#include "core/ThrownMessage.h"
#include <gtest/gtest.h>
#include <limn/core/AsyncGPUReadback.h>
#include <limn/core/Debug.h>
#include <new>

#include "Mentions.h"

namespace limn
{
namespace
{

std::vector<std::string> s_Logged;

/// A read-back of four bytes that is there at once, or fails as it is told.
class ReadbackAtOnce final : public PendingReadback
{
public:
    explicit ReadbackAtOnce(bool fails) : PendingReadback(Image{}), m_Fails(fails) {}

protected:
    bool isReady() override { return true; }
    void Wait() override {}
    std::vector<std::byte> Take() override
    {
        if (m_Fails)
        {
            throw std::bad_alloc();
        }
        return std::vector<std::byte>(4);
    }

private:
    bool m_Fails;
};

} // namespace

TEST(PendingReadback, SaysWhatWentWrong)
{
    const auto readback = std::make_shared<ReadbackAtOnce>(true);
    readback->Finish(true);
    ASSERT_TRUE(readback->hasError());
    AsyncGPUReadbackRequest request(readback);
    EXPECT_THAT(test::ThrownMessage<ContractError>([&] { request.GetData<std::uint8_t>(); }),
                test::Mentions("read-back", "no data", "not enough memory"));
}

TEST(PendingReadback, LogsWhatItsCallbackThrows)
{
    const auto readback = std::make_shared<ReadbackAtOnce>(false);
    readback->callback = [](const AsyncGPUReadbackRequest&)
    {
        throw std::runtime_error("the author's own");
    };
    s_Logged.clear();
    SetLogSink([](const LogMessage& message) { s_Logged.push_back(message.text); });
    EXPECT_NO_THROW(readback->Finish(true));
    SetLogSink(nullptr);
    ASSERT_EQ(s_Logged.size(), 1u);
    EXPECT_NE(s_Logged[0].find("the author's own"), std::string::npos);
    EXPECT_TRUE(readback->isDone());
    EXPECT_FALSE(readback->hasError());
}

} // namespace limn
