// A library to preload (LD_PRELOAD) into a program that is to be killed at a chosen moment. The
// disk changes only by system calls, so only these moments matter. The program is killed at the
// call with the number TRACTUS_DIE_AT_CALL among its calls that change a file: before the call or,
// for a call that writes, in the middle of it. If the program reaches its end, the library writes
// the number of these calls to the file named by TRACTUS_CALLS.
//
// The library counts calls from other libraries, but neither calls within the C library nor writing
// to standard output and standard error.

#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

std::atomic<long> calls = 0;

long fatal_call()
{
    static long const number = [] {
        char const* const text = std::getenv("TRACTUS_DIE_AT_CALL");
        return text != nullptr ? std::atol(text) : 0;
    }();
    return number;
}

void die()
{
    ::kill(::getpid(), SIGKILL);
}

bool is_the_last()
{
    return ++calls == fatal_call();
}

bool is_file(int fd)
{
    struct stat about { };
    return fd > STDERR_FILENO && ::fstat(fd, &about) == 0 && S_ISREG(about.st_mode);
}

template<typename Call> Call* next_call(char const* name)
{
    return reinterpret_cast<Call*>(::dlsym(RTLD_NEXT, name));
}

struct AtEnd {
    ~AtEnd()
    {
        char const* const name = std::getenv("TRACTUS_CALLS");
        if (auto* const file = name != nullptr ? std::fopen(name, "w") : nullptr) {
            std::fprintf(file, "%ld\n", calls.load());
            std::fclose(file);
        }
    }
} const at_end;

} // namespace

// Defines a counted call from its return type, name, parameters and arguments.
#define COUNTED(Value, name, parameters, arguments)                                                \
    extern "C" Value name parameters                                                               \
    {                                                                                              \
        static auto* const next = next_call<Value parameters>(#name);                              \
        if (is_the_last())                                                                         \
            die();                                                                                 \
        return next arguments;                                                                     \
    }

COUNTED(int, rename, (char const* from, char const* to), (from, to))
COUNTED(int, link, (char const* from, char const* to), (from, to))
COUNTED(int, linkat, (int from, char const* name, int to, char const* other, int flags),
        (from, name, to, other, flags))
COUNTED(int, unlink, (char const* path), (path))
COUNTED(int, remove, (char const* path), (path))
COUNTED(int, mkdir, (char const* path, mode_t mode), (path, mode))
COUNTED(int, fsync, (int fd), (fd))
COUNTED(int, fdatasync, (int fd), (fd))
COUNTED(int, ftruncate, (int fd, off_t size), (fd, size))
COUNTED(int, ftruncate64, (int fd, off64_t size), (fd, size))

extern "C" ssize_t write(int fd, void const* bytes, std::size_t size)
{
    static auto* const next = next_call<ssize_t(int, void const*, std::size_t)>("write");
    if (is_file(fd) && is_the_last()) {
        (void)!next(fd, bytes, size / 2);
        die();
    }
    return next(fd, bytes, size);
}

extern "C" ssize_t pwrite64(int fd, void const* bytes, std::size_t size, off64_t at)
{
    static auto* const next
        = next_call<ssize_t(int, void const*, std::size_t, off64_t)>("pwrite64");
    if (is_file(fd) && is_the_last()) {
        (void)!next(fd, bytes, size / 2, at);
        die();
    }
    return next(fd, bytes, size, at);
}

extern "C" ssize_t writev(int fd, iovec const* parts, int count)
{
    static auto* const next = next_call<ssize_t(int, iovec const*, int)>("writev");
    if (is_file(fd) && is_the_last()) {
        (void)!next(fd, parts, count / 2);
        die();
    }
    return next(fd, parts, count);
}
