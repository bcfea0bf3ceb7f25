// Lets an allocation of a whole program fail: LD_PRELOAD of the module that this file makes.
//   LIMN_MALLOC_FAIL=17        the 17th allocation since main() began that counts returns null
//   LIMN_MALLOC_LASTS=1        and so do all behind it
//   LIMN_MALLOC_OF=a:b         allocations count that a module asks for whose name begins so
//   LIMN_MALLOC_PATHS=8        of those that 8 callers in a row ask for alike only the first counts
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
    k_DepthOfNew = 6,
    k_Depth = 24
};

enum Kind
{
    Unknown,
    Library, // hands on what others ask for
    New,     // operator new, and with it whatever it called
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
static int s_PathLength;
static _Atomic uintptr_t s_Paths[k_Places];
static const char* s_Of;
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
    const char* name = info.dli_sname ? info.dli_sname : "";
    if (BeginsWith(name, "_Znwm", 5) || BeginsWith(name, "_Znam", 5))
    {
        return New;
    }
    if (BeginsWith(name, "__cxa_thread_atexit", strlen("__cxa_thread_atexit")))
    {
        return Spared; // glibc ends the program
    }
    // Templates of the library may lie in any module, also in one that did not ask for them.
    const char* templates[] = {"_ZNSt", "_ZNKSt", "_ZSt", "_ZNSa", "_ZN9__gnu_cxx"};
    for (size_t i = 0; i < sizeof(templates) / sizeof(*templates); ++i)
    {
        if (BeginsWith(name, templates[i], strlen(templates[i])))
        {
            return Library;
        }
    }
    const char* libraries[] = {"libfaulty_malloc", "libc.so", "libstdc++", "libgcc_s"};
    for (size_t i = 0; i < sizeof(libraries) / sizeof(*libraries); ++i)
    {
        if (BeginsWith(module, libraries[i], strlen(libraries[i])))
        {
            return Library;
        }
    }
    for (const char* of = s_Of; of && *of;)
    {
        const size_t length = strcspn(of, ":");
        if (BeginsWith(module, of, length))
        {
            return Counts;
        }
        of += length + (of[length] == ':');
    }
    return Spared;
}

static enum Kind FindKind(uintptr_t address)
{
    for (size_t i = address * 0x9e3779b97f4a7c15u >> 48;; ++i)
    {
        struct Place* place = &s_Places[i % k_Places];
        const uintptr_t there = atomic_load(&place->address);
        if (there == address)
        {
            const enum Kind kind = (enum Kind)atomic_load(&place->kind);
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

struct Asking
{
    enum Kind kind; // of who asks
    int depth;      // frames so far
    int callers;    // beyond the libraries
    uintptr_t path; // a hash of them
};

static _Unwind_Reason_Code VisitFrame(struct _Unwind_Context* context, void* data)
{
    struct Asking* asking = data;
    const uintptr_t address = _Unwind_GetIP(context);
    if (address == 0)
    {
        return _URC_END_OF_STACK;
    }
    ++asking->depth;
    const enum Kind kind = FindKind(address - 1);
    if (kind == New)
    {
        *asking = (struct Asking){Library, asking->depth, 0, 0};
        return _URC_NO_REASON;
    }
    asking->kind = asking->kind == Library ? kind : asking->kind;
    if (asking->kind != Library)
    {
        ++asking->callers;
        asking->path = (asking->path ^ address) * 0x9e3779b97f4a7c15u;
        asking->path ^= asking->path >> 32;
    }
    const int isOver = asking->kind != Library && asking->depth >= k_DepthOfNew &&
                       (asking->kind != Counts || asking->callers >= s_PathLength);
    return isOver ? _URC_END_OF_STACK : _URC_NO_REASON;
}

/// Adds to a set; false where it is full, too.
static int IsNew(uintptr_t path)
{
    for (size_t i = 0; i < k_Places; ++i)
    {
        _Atomic uintptr_t* place = &s_Paths[(path + i) % k_Places];
        uintptr_t there = 0;
        if (atomic_compare_exchange_strong(place, &there, path))
        {
            return 1;
        }
        if (there == path)
        {
            return 0;
        }
    }
    return 0;
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
    struct Asking asking = {Library, 0, 0, 0};
    _Unwind_Backtrace(VisitFrame, &asking);
    int fails = 0;
    if (asking.kind == Counts && (s_PathLength == 0 || IsNew(asking.path)))
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
    const char* paths = getenv("LIMN_MALLOC_PATHS");
    s_PathLength = paths ? atoi(paths) : 0;
    s_Of = getenv("LIMN_MALLOC_OF");
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
