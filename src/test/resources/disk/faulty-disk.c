/*
 * A disk with faults, for a process that has this library preloaded. In the environment DISK tells what is refused and with which errno, as
 * "rename=16 lock=37", for files whose path contains DISK_PATH. SLOW tells likewise what takes how many
 * milliseconds, once: close, rename or unlink.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

static const char *wanted(void) {
    const char *path = getenv("DISK_PATH");
    return path ? path : "";
}

/* What a variable of the environment says of something, 0 if nothing. */
static int told(const char *all, const char *what) {
    size_t length = strlen(what);
    for (const char *at = all; at && (at = strstr(at, what)); at += length)
        if ((at == all || at[-1] == ' ') && at[length] == '=')
            return atoi(at + length + 1);
    return 0;
}

/* The errno with which something is refused, 0 if it is not. */
static int refused(const char *what) { return told(getenv("DISK"), what); }

static void wait_once(const char *what, const char *path) {
    int milliseconds = strstr(path, wanted()) ? told(getenv("SLOW"), what) : 0;
    if (milliseconds) {
        unsetenv("SLOW");
        usleep(1000 * milliseconds);
    }
}

static int refuse(const char *what, const char *path) {
    int number = path && strstr(path, wanted()) ? refused(what) : 0;
    if (number)
        errno = number;
    return number;
}

static int refuse_fd(const char *what, int fd) {
    char link[64], path[4096];
    if (!refused(what))
        return 0;
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    ssize_t length = readlink(link, path, sizeof path - 1);
    path[length < 0 ? 0 : length] = 0;
    return refuse(what, path);
}

#define NEXT(type, name, ...) ((type (*)(__VA_ARGS__)) dlsym(RTLD_NEXT, name))

static int opened(const char *name, const char *path, int flags, mode_t mode) {
    if ((flags & O_CREAT && refuse("create", path)) || ((flags & O_ACCMODE) != O_RDONLY && refuse("open", path)))
        return -1;
    return NEXT(int, name, const char *, int, ...)(path, flags, mode);
}

#define MODE(flags) mode_t mode = 0; if (flags & (O_CREAT | O_TMPFILE)) { va_list all; va_start(all, flags); mode = va_arg(all, mode_t); va_end(all); }

int open(const char *path, int flags, ...) { MODE(flags) return opened("open", path, flags, mode); }
int open64(const char *path, int flags, ...) { MODE(flags) return opened("open64", path, flags, mode); }

static int locked(const char *name, int fd, int command, void *argument) {
    if ((command == F_SETLK || command == F_SETLKW) && refuse_fd("lock", fd))
        return -1;
    return NEXT(int, name, int, int, ...)(fd, command, argument);
}

int fcntl(int fd, int command, ...) { va_list all; va_start(all, command); void *a = va_arg(all, void *); va_end(all); return locked("fcntl", fd, command, a); }
int fcntl64(int fd, int command, ...) { va_list all; va_start(all, command); void *a = va_arg(all, void *); va_end(all); return locked("fcntl64", fd, command, a); }
int flock(int fd, int operation) { return refuse_fd("lock", fd) ? -1 : NEXT(int, "flock", int, int)(fd, operation); }

int fsync(int fd) { return refuse_fd("fsync", fd) ? -1 : NEXT(int, "fsync", int)(fd); }
int fdatasync(int fd) { return refuse_fd("fsync", fd) ? -1 : NEXT(int, "fdatasync", int)(fd); }
int ftruncate(int fd, off_t size) { return refuse_fd("truncate", fd) ? -1 : NEXT(int, "ftruncate", int, off_t)(fd, size); }
int ftruncate64(int fd, off64_t size) { return refuse_fd("truncate", fd) ? -1 : NEXT(int, "ftruncate64", int, off64_t)(fd, size); }
ssize_t write(int fd, const void *bytes, size_t count) {
    return refuse_fd("write", fd) ? -1 : NEXT(ssize_t, "write", int, const void *, size_t)(fd, bytes, count);
}
ssize_t pwrite(int fd, const void *bytes, size_t count, off_t at) {
    return refuse_fd("write", fd) ? -1 : NEXT(ssize_t, "pwrite", int, const void *, size_t, off_t)(fd, bytes, count, at);
}
ssize_t pwrite64(int fd, const void *bytes, size_t count, off64_t at) {
    return refuse_fd("write", fd) ? -1 : NEXT(ssize_t, "pwrite64", int, const void *, size_t, off64_t)(fd, bytes, count, at);
}
ssize_t sendfile64(int to, int from, off64_t *at, size_t count) {
    return refuse_fd("write", to) ? -1 : NEXT(ssize_t, "sendfile64", int, int, off64_t *, size_t)(to, from, at, count);
}
ssize_t copy_file_range(int from, off64_t *at, int to, off64_t *place, size_t count, unsigned flags) {
    return refuse_fd("write", to) ? -1
        : NEXT(ssize_t, "copy_file_range", int, off64_t *, int, off64_t *, size_t, unsigned)(from, at, to, place, count, flags);
}
int close(int fd) {
    char link[64], path[4096];
    snprintf(link, sizeof link, "/proc/self/fd/%d", fd);
    ssize_t length = getenv("SLOW") ? readlink(link, path, sizeof path - 1) : -1;
    if (length > 0) {
        path[length] = 0;
        wait_once("close", path);
    }
    int refusal = refuse_fd("close", fd);
    int closed = NEXT(int, "close", int)(fd);
    errno = refusal ? refusal : errno;
    return refusal ? -1 : closed;
}

int rename(const char *from, const char *to) {
    wait_once("rename", to);
    return refuse("rename", to) ? -1 : NEXT(int, "rename", const char *, const char *)(from, to);
}
int renameat(int f, const char *from, int t, const char *to) {
    return refuse("rename", to) ? -1 : NEXT(int, "renameat", int, const char *, int, const char *)(f, from, t, to);
}
int link(const char *from, const char *to) { return refuse("link", to) ? -1 : NEXT(int, "link", const char *, const char *)(from, to); }
int unlink(const char *path) {
    wait_once("unlink", path);
    return refuse("unlink", path) ? -1 : NEXT(int, "unlink", const char *)(path);
}
int unlinkat(int fd, const char *path, int flags) { return refuse("unlink", path) ? -1 : NEXT(int, "unlinkat", int, const char *, int)(fd, path, flags); }
int chmod(const char *path, mode_t mode) { return refuse("chmod", path) ? -1 : NEXT(int, "chmod", const char *, mode_t)(path, mode); }
int fchmod(int fd, mode_t mode) { return refuse_fd("chmod", fd) ? -1 : NEXT(int, "fchmod", int, mode_t)(fd, mode); }
