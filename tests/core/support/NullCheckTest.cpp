#include "core/ThrownMessage.h"

#include <gmock/gmock.h>
#include <limn/core/NullCheck.h>

namespace limn::test
{

namespace
{

struct Lamp
{
    int watts = 40;
};

using testing::HasSubstr;

} // namespace

TEST(NullCheck, GivesTheObjectThatIsThere)
{
    const Shared<Lamp> shared = std::make_shared<Lamp>();
    Owned<Lamp> owned;
    owned = std::make_unique<Lamp>();
    const Borrowed<Lamp> borrowed = owned.get();
    borrowed->watts = 60;
    EXPECT_EQ(40, shared->watts);
    EXPECT_EQ(60, (*owned).watts);
    const std::shared_ptr<const Lamp> other = shared; // as limn's functions take it
    EXPECT_EQ(2, other.use_count());
    EXPECT_TRUE(shared && owned && borrowed);
}

TEST(NullCheck, ThrowsWhereNothingIsUsedAsAnObject)
{
    const Shared<const Lamp> shared;
    const Owned<Lamp> owned;
    const Borrowed<Lamp> borrowed;
    EXPECT_FALSE(shared || owned || borrowed);
    EXPECT_TRUE(shared == nullptr && owned == nullptr && borrowed == nullptr);
    EXPECT_THAT(ThrownMessage<ContractError>([&] { (void)shared->watts; }),
                HasSubstr("Lamp' is used that is null"));
    EXPECT_THAT(ThrownMessage<ContractError>([&] { (void)(*owned).watts; }), HasSubstr("Lamp'"));
    EXPECT_THAT(ThrownMessage<ContractError>([&] { (void)borrowed->watts; }), HasSubstr("Lamp'"));
}

} // namespace limn::test
