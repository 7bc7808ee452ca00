/* Loaded before the C library: every wait for the disk takes SLOW_DISK_MS milliseconds longer. */
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

static void take_long(void) {
    const char *told = getenv("SLOW_DISK_MS");
    long ms = told ? atol(told) : 0;
    struct timespec delay = {ms / 1000, ms % 1000 * 1000000};
    nanosleep(&delay, NULL);
}

int fsync(int file) {
    take_long();
    return (int)syscall(SYS_fsync, file);
}

int fdatasync(int file) {
    take_long();
    return (int)syscall(SYS_fdatasync, file);
}
