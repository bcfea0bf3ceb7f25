#include <limn/base/HashContent.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace limn
{

std::uint64_t HashContent(std::string_view bytes)
{
    const std::uint64_t hash = XXH3_64bits(bytes.data(), bytes.size());
    return hash == 0 ? 1 : hash;
}

} // namespace limn
