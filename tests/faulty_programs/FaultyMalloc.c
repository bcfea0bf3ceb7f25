// Lets an allocation of a whole program fail: LD_PRELOAD of the module that this file makes.
//   LIMN_MALLOC_FAIL=17        the 17th allocation since main() began that counts returns null
//   LIMN_MALLOC_LASTS=1        and so do all behind it
//   LIMN_MALLOC_SPARED=a:b     allocations do not count that a module asks for whose name begins so
//   LIMN_MALLOC_REPORT=FILE    gets who asked for the one that failed, and how many counted
// Who asks is the first caller beyond the C and C++ libraries and operator new.

#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <unwind.h>

void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);

enum
{
    k_Places = 1 << 16,
    k_Depth = 24
};

enum Kind
{
    Unknown,
    Library, // hands on what others ask for
    Spared,
    Counts
};

struct Place
{
    _Atomic uintptr_t address;
    _Atomic int kind;
};

static struct Place s_Places[k_Places];
static atomic_long s_Count;
static atomic_int s_IsOn;
static long s_Fail;
static int s_Lasts;
static const char* s_Spared;
static const char* s_Report;
static pid_t s_Process;

static int BeginsWith(const char* text, const char* begin, size_t length)
{
    return strncmp(text, begin, length) == 0;
}

static enum Kind KindOf(uintptr_t address)
{
    Dl_info info;
    if (!dladdr((void*)address, &info) || !info.dli_fname)
    {
        return Spared; // code that was made while the program runs
    }
    const char* slash = strrchr(info.dli_fname, '/');
    const char* module = slash ? slash + 1 : info.dli_fname;
    const char* libraries[] = {"libfaulty_malloc", "libc.so", "libstdc++", "libgcc_s"};
    for (size_t i = 0; i < sizeof(libraries) / sizeof(*libraries); ++i)
    {
        if (BeginsWith(module, libraries[i], strlen(libraries[i])))
        {
            return Library;
        }
    }
    if (info.dli_sname && (BeginsWith(info.dli_sname, "_Znwm", 5) ||
                           BeginsWith(info.dli_sname, "_Znam", 5)))
    {
        return Library;
    }
    for (const char* name = s_Spared; name && *name;)
    {
        const size_t length = strcspn(name, ":");
        if (BeginsWith(module, name, length))
        {
            return Spared;
        }
        name += length + (name[length] == ':');
    }
    return Counts;
}

static enum Kind FindKind(uintptr_t address)
{
    for (size_t i = address * 0x9e3779b97f4a7c15u >> 48;; ++i)
    {
        struct Place* place = &s_Places[i % k_Places];
        const uintptr_t there = atomic_load(&place->address);
        if (there == address)
        {
            const enum Kind kind = atomic_load(&place->kind);
            return kind != Unknown ? kind : KindOf(address);
        }
        uintptr_t none = 0;
        if (there == 0 && atomic_compare_exchange_strong(&place->address, &none, address))
        {
            const enum Kind kind = KindOf(address);
            atomic_store(&place->kind, kind);
            return kind;
        }
    }
}

static _Unwind_Reason_Code VisitFrame(struct _Unwind_Context* context, void* kind)
{
    const uintptr_t address = _Unwind_GetIP(context);
    if (address == 0)
    {
        return _URC_END_OF_STACK;
    }
    *(enum Kind*)kind = FindKind(address - 1);
    return *(enum Kind*)kind == Library ? _URC_NO_REASON : _URC_END_OF_STACK;
}

static void Write(const char* line, int length)
{
    const int file = open(s_Report, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    const ssize_t unused = write(file, line, (size_t)length);
    (void)unused;
    close(file);
}

static _Unwind_Reason_Code ReportFrame(struct _Unwind_Context* context, void* left)
{
    Dl_info info;
    const uintptr_t address = _Unwind_GetIP(context) - 1;
    if ((*(int*)left)-- == 0 || !dladdr((void*)address, &info) || !info.dli_fname)
    {
        return _URC_END_OF_STACK;
    }
    char line[600];
    Write(line, snprintf(line, sizeof(line), "%.200s+0x%zx %.300s\n", info.dli_fname,
                         (size_t)(address - (uintptr_t)info.dli_fbase),
                         info.dli_sname ? info.dli_sname : "?"));
    return _URC_NO_REASON;
}

static int Fails(void)
{
    static _Thread_local int s_IsAsking;
    if (!atomic_load(&s_IsOn) || s_IsAsking)
    {
        return 0;
    }
    s_IsAsking = 1;
    enum Kind kind = Library;
    _Unwind_Backtrace(VisitFrame, &kind);
    int fails = 0;
    if (kind == Counts)
    {
        const long count = atomic_fetch_add(&s_Count, 1) + 1;
        fails = s_Fail != 0 && (count == s_Fail || (s_Lasts && count > s_Fail));
        if (count == s_Fail && s_Report)
        {
            int left = k_Depth;
            _Unwind_Backtrace(ReportFrame, &left);
        }
    }
    s_IsAsking = 0;
    if (fails)
    {
        errno = ENOMEM;
    }
    return fails;
}

void* malloc(size_t size)
{
    return Fails() ? NULL : __libc_malloc(size);
}

void* calloc(size_t count, size_t size)
{
    return Fails() ? NULL : __libc_calloc(count, size);
}

void* realloc(void* memory, size_t size)
{
    return Fails() ? NULL : __libc_realloc(memory, size);
}

void* memalign(size_t alignment, size_t size)
{
    return Fails() ? NULL : __libc_memalign(alignment, size);
}

void* aligned_alloc(size_t alignment, size_t size)
{
    return Fails() ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size)
{
    void* made = Fails() ? NULL : __libc_memalign(alignment, size);
    *memory = made ? made : *memory;
    return made ? 0 : ENOMEM;
}

static int (*s_Main)(int, char**, char**);

static int Main(int argc, char** argv, char** environment)
{
    const char* fail = getenv("LIMN_MALLOC_FAIL");
    s_Fail = fail ? atol(fail) : 0;
    s_Lasts = getenv("LIMN_MALLOC_LASTS") != NULL;
    s_Spared = getenv("LIMN_MALLOC_SPARED");
    s_Report = getenv("LIMN_MALLOC_REPORT");
    s_Process = getpid();
    atomic_store(&s_IsOn, 1);
    const int result = s_Main(argc, argv, environment);
    atomic_store(&s_IsOn, 0);
    if (s_Report && getpid() == s_Process)
    {
        char line[64];
        Write(line, snprintf(line, sizeof(line), "counted %ld\n", atomic_load(&s_Count)));
    }
    return result;
}

/// Allocations count from main() on: what fails before has nobody to say so.
int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(void),
                      void (*fini)(void), void (*end)(void), void* stack)
{
    typedef int Start(int (*)(int, char**, char**), int, char**, void (*)(void), void (*)(void),
                      void (*)(void), void*);
    s_Main = main;
    union
    {
        void* symbol;
        Start* function;
    } next = {dlsym(RTLD_NEXT, "__libc_start_main")};
    return next.function(Main, argc, argv, init, fini, end, stack);
}
