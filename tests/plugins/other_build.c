#include <stdint.h>

/* A plug-in of this version whose objects have other sizes. */
const struct
{
    const char* version;
    const char* standardLibrary;
    uint64_t layout;
} limn_plugin = {LIMN_VERSION, "libstdc++", 1};
