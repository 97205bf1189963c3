/* SPDX-License-Identifier: LGPL-2.1-or-later */
/*
 * Loaded before the C library by tests/app/writes.py: counts what a program does to the files of one folder, and kills it,
 * or refuses, at one of these calls. Environment:
 *   STOP_FOLDER  the folder, absolute
 *   STOP_NAME    its name as the program is given it
 *   STOP_AT      number of the call, from 1; 0: none
 *   STOP_HOW     kill (of a write half is done first) or refuse (no space left on the disk)
 *   STOP_LIST    file that gets a line for each call
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static int number = 0; /* several threads may wait for the disk */

/* Whether a path is in the folder; NULL is in no folder. */
static int is_in_folder(const char *path)
{
  const char *const names[] = {getenv("STOP_FOLDER"), getenv("STOP_NAME")};
  for (int i = 0; path != NULL && i < 2; ++i)
    if (names[i] != NULL && strncmp(path, names[i], strlen(names[i])) == 0 && path[strlen(names[i])] == '/')
      return 1;
  return 0;
}

/* Notes a call. Returns 0: go on, 1: kill, 2: refuse. */
static int meets(const char *what, const char *path)
{
  if (!is_in_folder(path))
    return 0;
  const int here = __atomic_add_fetch(&number, 1, __ATOMIC_SEQ_CST);
  const char *const list = getenv("STOP_LIST"), *const at = getenv("STOP_AT"), *const how = getenv("STOP_HOW");
  if (list != NULL)
  {
    FILE *const file = fopen(list, "a");
    fprintf(file, "%s %s\n", what, path);
    fclose(file);
  }
  if (at == NULL || atoi(at) != here)
    return 0;
  return how != NULL && strcmp(how, "refuse") == 0 ? 2 : 1;
}

static const char *path_of(const int descriptor, char *to, const size_t size)
{
  char link[64];
  snprintf(link, sizeof(link), "/proc/self/fd/%d", descriptor);
  const ssize_t n = readlink(link, to, size - 1);
  if (n < 0)
    return NULL;
  to[n] = '\0';
  return to;
}

static void die(void)
{
  kill(getpid(), SIGKILL);
  pause();
}

#define NEXT(name, type) ((type) dlsym(RTLD_NEXT, name))
#define REFUSED \
  { \
    errno = ENOSPC; \
    return -1; \
  }

typedef ssize_t (*write_type)(int, const void *, size_t);
typedef ssize_t (*pwrite_type)(int, const void *, size_t, off_t);
typedef int (*path_type)(const char *);

ssize_t write(int descriptor, const void *from, size_t size)
{
  char path[4096];
  const int met = meets("write", path_of(descriptor, path, sizeof(path)));
  if (met == 2)
    REFUSED
  const ssize_t done = NEXT("write", write_type)(descriptor, from, met == 1 ? size / 2 : size);
  if (met == 1)
    die();
  return done;
}

static ssize_t write_at(const char *name, int descriptor, const void *from, size_t size, off_t at)
{
  char path[4096];
  const int met = meets("pwrite", path_of(descriptor, path, sizeof(path)));
  if (met == 2)
    REFUSED
  const ssize_t done = NEXT(name, pwrite_type)(descriptor, from, met == 1 ? size / 2 : size, at);
  if (met == 1)
    die();
  return done;
}

ssize_t pwrite(int descriptor, const void *from, size_t size, off_t at)
{
  return write_at("pwrite", descriptor, from, size, at);
}

ssize_t pwrite64(int descriptor, const void *from, size_t size, off64_t at)
{
  return write_at("pwrite64", descriptor, from, size, at);
}

int rename(const char *from, const char *to)
{
  const int met = meets("rename", to);
  if (met == 2)
    REFUSED
  if (met == 1)
    die();
  return NEXT("rename", int (*)(const char *, const char *))(from, to);
}

static int take_away(const char *name, const char *path)
{
  const int met = meets(name, path);
  if (met == 2)
    REFUSED
  if (met == 1)
    die();
  return NEXT(name, path_type)(path);
}

int unlink(const char *path)
{
  return take_away("unlink", path);
}

int remove(const char *path)
{
  return take_away("remove", path);
}

static int bring(const char *name, int descriptor)
{
  char path[4096];
  const int met = meets(name, path_of(descriptor, path, sizeof(path)));
  if (met == 2)
    REFUSED
  if (met == 1)
    die();
  return NEXT(name, int (*)(int))(descriptor);
}

int fsync(int descriptor)
{
  return bring("fsync", descriptor);
}

static int cut(const char *name, int descriptor, off_t size)
{
  char path[4096];
  const int met = meets("truncate", path_of(descriptor, path, sizeof(path)));
  if (met == 2)
    REFUSED
  if (met == 1)
    die();
  return NEXT(name, int (*)(int, off_t))(descriptor, size);
}

int ftruncate(int descriptor, off_t size)
{
  return cut("ftruncate", descriptor, size);
}

int ftruncate64(int descriptor, off64_t size)
{
  return cut("ftruncate64", descriptor, size);
}

static int open_it(const char *name, const char *path, int flags, mode_t mode)
{
  const int met = (flags & (O_CREAT | O_WRONLY | O_RDWR)) != 0 ? meets("open", path) : 0;
  if (met == 2)
    REFUSED
  if (met == 1)
    die();
  return NEXT(name, int (*)(const char *, int, ...))(path, flags, mode);
}

int open(const char *path, int flags, ...)
{
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return open_it("open", path, flags, mode);
}

int open64(const char *path, int flags, ...)
{
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return open_it("open64", path, flags, mode);
}
