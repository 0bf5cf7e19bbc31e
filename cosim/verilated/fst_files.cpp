// SPDX-License-Identifier: Apache-2.0
#define TRAMMEL_FST_FILES
#include "cosim/verilated/fst_files.hpp"

#include <sys/stat.h>

#include <atomic>
#include <cerrno>

#include "cosim/waves.hpp"

namespace {

std::atomic<int> g_error{0};  // the first one since it was taken

void keep(int error) {
  int none = 0;
  g_error.compare_exchange_strong(none, error != 0 ? error : EIO);
}

template <class Result>
Result kept_unless(bool good, Result result) {
  if (!good) keep(errno);
  return result;
}

}  // namespace

namespace trammel::cosim {

int take_wave_error() { return g_error.exchange(0); }

}  // namespace trammel::cosim

std::FILE* trammel_fst_open(const char* name, const char* mode) {
  errno = 0;
  std::FILE* const file = std::fopen(name, mode);
  return kept_unless(file != nullptr || mode[0] == 'r', file);
}

std::FILE* trammel_fst_tmpfile() {
  errno = 0;
  const int memory = memfd_create("trammel-waves", MFD_CLOEXEC);
  std::FILE* const file = memory < 0 ? nullptr : fdopen(memory, "w+b");
  return kept_unless(file != nullptr, file);
}

std::size_t trammel_fst_write(const void* from, std::size_t size, std::size_t count,
                              std::FILE* to) {
  errno = 0;
  const std::size_t written = std::fwrite(from, size, count, to);
  return kept_unless(written == count || size == 0, written);
}

int trammel_fst_put(int byte, std::FILE* to) {
  errno = 0;
  const int written = std::fputc(byte, to);
  return kept_unless(written != EOF, written);
}

int trammel_fst_flush(std::FILE* file) {
  errno = 0;
  const int result = std::fflush(file);
  return kept_unless(result == 0, result);
}

int trammel_fst_close(std::FILE* file) {
  errno = 0;
  const int result = std::fclose(file);
  return kept_unless(result == 0, result);
}

int trammel_fst_gzwrite(gzFile file, const void* from, unsigned size) {
  errno = 0;
  const int written = gzwrite(file, from, size);
  return kept_unless(written == static_cast<int>(size), written);
}

int trammel_fst_gzclose(gzFile file) {
  errno = 0;
  const int result = gzclose(file);
  return kept_unless(result == Z_OK, result);
}

// A file that was cut is not mapped: reading behind its end would end the program.
void* trammel_fst_map(void* at, std::size_t size, int protection, int flags, int file,
                      off_t from) {
  struct stat status {};
  const bool whole = size > 0 && fstat(file, &status) == 0 &&
                     status.st_size >= from + static_cast<off_t>(size);
  if (whole) return mmap(at, size, protection, flags, file, from);
  keep(ENOSPC);
  return mmap(at, size > 0 ? size : 1, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
}
