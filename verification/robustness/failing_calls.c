/* SPDX-License-Identifier: BSD-3-Clause
 * To be preloaded: counts the calls by which a program and what it starts change files below a folder, and lets one
 * fail, or that one and all that follow, as on a disk that is full, broken or read-only. From the environment:
 *   FAILING_BELOW   the folder, without links in its path
 *   FAILING_COUNT   a file of eight bytes, the calls so far, of all processes
 *   FAILING_CALL    which call fails, from 1; 0: none
 *   FAILING_ERROR   with which errno
 *   FAILING_FOREVER 1: all that follow too, and of the first, if it writes, half goes through
 *   FAILING_LOG     a file that gets a line a call: number, function, path
 * Streams write to the kernel by a way inside the C library that nobody can stand in: those opened for writing
 * are made here, of calls that are counted. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

/* What stands in for nobody: straight to the kernel. */
static int kernel_open(const char* path, int flags, mode_t mode) {
    return (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

static _Atomic uint64_t none, *count = &none;
static uint64_t failing;
static int with_error, forever, log_file = -1;
static char below[PATH_MAX];
static size_t below_length;

static const char* setting(const char* name) {
    const char* value = getenv(name);
    return value ? value : "";
}

static __attribute__((constructor)) void read_settings(void) {
    const int file = kernel_open(setting("FAILING_COUNT"), O_RDWR | O_CLOEXEC, 0);
    if (file < 0) return;
    void* memory = mmap(NULL, sizeof *count, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    syscall(SYS_close, file);
    if (memory == MAP_FAILED) return;
    count = memory;
    failing = strtoull(setting("FAILING_CALL"), NULL, 10);
    with_error = atoi(setting("FAILING_ERROR"));
    forever = atoi(setting("FAILING_FOREVER"));
    log_file = kernel_open(setting("FAILING_LOG"), O_WRONLY | O_APPEND | O_CLOEXEC, 0);
    strncpy(below, setting("FAILING_BELOW"), sizeof below - 1);
    below_length = strlen(below);
}

static int is_below(const char* path) {
    return below_length > 0 && strncmp(path, below, below_length) == 0 && path[below_length] == '/';
}

/* Of a path that may not be there yet: its folder is. */
static int concerns(const char* path, char* whole) {
    char folder[PATH_MAX], name[PATH_MAX];
    const char* slash = strrchr(path, '/');
    if (strlen(path) >= sizeof folder) return 0;
    strcpy(folder, slash ? path : ".");
    if (slash) folder[slash - path + (slash == path)] = '\0';
    strcpy(name, slash ? slash + 1 : path);
    char resolved[PATH_MAX];
    if (!realpath(folder, resolved)) return 0;
    if (strlen(resolved) + strlen(name) + 2 > PATH_MAX) return 0;
    strcpy(whole, resolved);
    strcat(whole, "/");
    strcat(whole, name);
    return is_below(whole);
}

static int concerns_file(int file, char* whole) {
    char link[64];
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t length = readlink(link, whole, PATH_MAX - 1);
    if (length <= 0) return 0;
    whole[length] = '\0';
    return is_below(whole);
}

enum what { goes_through, half_goes_through, fails };

static enum what next(const char* function, const char* path) {
    const uint64_t number = ++*count;
    if (log_file >= 0) {
        char line[PATH_MAX + 64];
        const int length =
            snprintf(line, sizeof line, "%llu %s %s\n", (unsigned long long)number, function, path);
        syscall(SYS_write, log_file, line, (size_t)length);
    }
    if (failing == 0 || number < failing || (number > failing && !forever)) return goes_through;
    errno = with_error;
    return number == failing && forever ? half_goes_through : fails;
}

static int fails_at(const char* function, const char* path) {
    return next(function, path) != goes_through;
}

static int for_writing(int flags) { return (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT); }

static int open_at(int folder, const char* path, int flags, mode_t mode) {
    char whole[PATH_MAX];
    if (for_writing(flags) && (folder == AT_FDCWD || path[0] == '/') && concerns(path, whole) &&
        fails_at("open", whole))
        return -1;
    return (int)syscall(SYS_openat, folder, path, flags, mode);
}

#define MODE_OF(flags, last)                                                                       \
    mode_t mode = 0;                                                                               \
    if ((flags) & (O_CREAT | __O_TMPFILE)) {                                                       \
        va_list arguments;                                                                         \
        va_start(arguments, last);                                                                 \
        mode = va_arg(arguments, mode_t);                                                          \
        va_end(arguments);                                                                         \
    }

int open(const char* path, int flags, ...) {
    MODE_OF(flags, flags)
    return open_at(AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    MODE_OF(flags, flags)
    return open_at(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    MODE_OF(flags, flags)
    return open_at(folder, path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) {
    MODE_OF(flags, flags)
    return open_at(folder, path, flags, mode);
}

int creat(const char* path, mode_t mode) {
    return open_at(AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode);
}

int creat64(const char* path, mode_t mode) { return creat(path, mode); }

/* Of a write of so many bytes: it fails, or takes half of them, or all. */
static int fails_to_take(int file, const char* call, size_t* length) {
    char whole[PATH_MAX];
    if (!concerns_file(file, whole)) return 0;
    const enum what what = next(call, whole);
    if (what == half_goes_through) *length /= 2;
    return what == fails || (what == half_goes_through && *length == 0);
}

ssize_t write(int file, const void* bytes, size_t length) {
    if (fails_to_take(file, "write", &length)) return -1;
    return syscall(SYS_write, file, bytes, length);
}

ssize_t writev(int file, const struct iovec* pieces, int number) {
    char whole[PATH_MAX];
    if (concerns_file(file, whole) && fails_at("writev", whole)) return -1;
    return syscall(SYS_writev, file, pieces, number);
}

ssize_t pwrite(int file, const void* bytes, size_t length, off_t at) {
    if (fails_to_take(file, "pwrite", &length)) return -1;
    return syscall(SYS_pwrite64, file, bytes, length, at);
}

ssize_t pwrite64(int file, const void* bytes, size_t length, off64_t at) {
    return pwrite(file, bytes, length, at);
}

int fsync(int file) {
    char whole[PATH_MAX];
    if (concerns_file(file, whole) && fails_at("fsync", whole)) return -1;
    return (int)syscall(SYS_fsync, file);
}

int fdatasync(int file) {
    char whole[PATH_MAX];
    if (concerns_file(file, whole) && fails_at("fdatasync", whole)) return -1;
    return (int)syscall(SYS_fdatasync, file);
}

int ftruncate(int file, off_t length) {
    char whole[PATH_MAX];
    if (concerns_file(file, whole) && fails_at("ftruncate", whole)) return -1;
    return (int)syscall(SYS_ftruncate, file, length);
}

int ftruncate64(int file, off64_t length) { return ftruncate(file, length); }

/* The file is closed whatever is said. Files that were only read have nothing to lose. */
int close(int file) {
    char whole[PATH_MAX];
    const int flags = (int)syscall(SYS_fcntl, file, F_GETFL);
    const int wrong = flags >= 0 && for_writing(flags & O_ACCMODE) && concerns_file(file, whole) &&
                      fails_at("close", whole);
    const int error = errno, closed = (int)syscall(SYS_close, file);
    if (!wrong) return closed;
    errno = error;
    return -1;
}

int rename(const char* from, const char* to) {
    char whole[PATH_MAX];
    if (concerns(to, whole) && fails_at("rename", whole)) return -1;
    return (int)syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0);
}

int mkdir(const char* path, mode_t mode) {
    char whole[PATH_MAX];
    if (concerns(path, whole) && fails_at("mkdir", whole)) return -1;
    return (int)syscall(SYS_mkdirat, AT_FDCWD, path, mode);
}

/* Streams. */
struct made {
    FILE* stream;
    int file;
};
static struct made all_made[256];

static struct made* made_of(FILE* stream) {
    for (size_t i = 0; i < sizeof all_made / sizeof *all_made; ++i)
        if (all_made[i].stream == stream) return &all_made[i];
    return NULL;
}

static ssize_t read_made(void* cookie, char* bytes, size_t length) {
    return read(((struct made*)cookie)->file, bytes, length);
}

/* 0 for an error: what the C library asks of those who make streams. */
static ssize_t write_made(void* cookie, const char* bytes, size_t length) {
    size_t done = 0;
    while (done < length) {
        const ssize_t written = write(((struct made*)cookie)->file, bytes + done, length - done);
        if (written <= 0) break;
        done += (size_t)written;
    }
    return (ssize_t)done;
}

static int seek_made(void* cookie, off64_t* at, int whence) {
    const off_t reached = lseek(((struct made*)cookie)->file, *at, whence);
    if (reached < 0) return -1;
    *at = reached;
    return 0;
}

static int close_made(void* cookie) {
    struct made* made = cookie;
    made->stream = NULL;
    return close(made->file);
}

static int flags_of(const char* mode) {
    int flags = strchr(mode, '+') ? O_RDWR : mode[0] == 'r' ? O_RDONLY : O_WRONLY;
    if (mode[0] != 'r') flags |= O_CREAT | (mode[0] == 'a' ? O_APPEND : O_TRUNC);
    if (strchr(mode, 'x')) flags |= O_EXCL;
    if (strchr(mode, 'e')) flags |= O_CLOEXEC;
    return flags;
}

FILE* fopen(const char* path, const char* mode) {
    char whole[PATH_MAX];
    const int flags = flags_of(mode);
    if (!for_writing(flags) || !concerns(path, whole)) {
        FILE* (*real)(const char*, const char*) =
            (FILE * (*)(const char*, const char*)) dlsym(RTLD_NEXT, "fopen");
        return real(path, mode);
    }
    const int file = open(path, flags, 0666);
    if (file < 0) return NULL;
    struct made* made = made_of(NULL);
    const cookie_io_functions_t calls = {read_made, write_made, seek_made, close_made};
    if (!made || !(made->stream = fopencookie(made, mode, calls))) abort();
    made->file = file;
    return made->stream;
}

FILE* fopen64(const char* path, const char* mode) { return fopen(path, mode); }

int fileno(FILE* stream) {
    const struct made* made = made_of(stream);
    if (made) return made->file;
    int (*real)(FILE*) = (int (*)(FILE*))dlsym(RTLD_NEXT, "fileno");
    return real(stream);
}
