#include <gtest/gtest.h>
#include <limn/base/Diagnostic.h>
#include <limn/core/ContextContainer.h>

#include "Mentions.h"
#include "ThrownMessage.h"

namespace limn
{
namespace
{

struct Blurred final : ContextItem
{
    int reset = 7;
    int kept = 7;
    void Reset() override { reset = 0; }
};
struct Masked final : ContextItem
{
    void Reset() override {}
};

} // namespace

TEST(ContextContainer, HoldsOneItemOfEachTypeThatWasCreated)
{
    ContextContainer container;
    EXPECT_FALSE(container.Contains<Blurred>());
    Blurred& item = container.Create<Blurred>();
    EXPECT_TRUE(container.Contains<Blurred>());
    EXPECT_FALSE(container.Contains<Masked>());
    container.Create<Masked>();
    EXPECT_EQ(&container.Get<Blurred>(), &item);
    EXPECT_EQ(&container.GetOrCreate<Blurred>(), &item);
}

TEST(ContextContainer, GetOrCreateMakesWhatIsNotThere)
{
    ContextContainer container;
    Blurred& item = container.GetOrCreate<Blurred>();
    EXPECT_EQ(&container.Get<Blurred>(), &item);
}

TEST(ContextContainer, RefusesTwoOfOneTypeAndNone)
{
    ContextContainer container;
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { container.Get<Masked>(); }),
        test::Mentions("ContextContainer", "there is no Masked in", "Contains", "GetOrCreate"));
    container.Create<Masked>();
    EXPECT_THAT(
        test::ThrownMessage<ContractError>([&] { container.Create<Masked>(); }),
        test::Mentions("ContextContainer", "Create", "has a Masked already", "GetOrCreate"));
}

// Unity pools items: what Reset leaves alone is found again.
TEST(ContextContainer, ResetsItemsWhenItIsDisposedOfAndUsesThemAgain)
{
    ContextContainer container;
    Blurred& item = container.Create<Blurred>();
    item.reset = 1;
    item.kept = 2;
    container.Dispose();
    EXPECT_FALSE(container.Contains<Blurred>());
    EXPECT_EQ(&container.Create<Blurred>(), &item);
    EXPECT_EQ(item.reset, 0);
    EXPECT_EQ(item.kept, 2);
}

} // namespace limn
