// SPDX-License-Identifier: Apache-2.0
//
// Put before Verilator's FST writer when it is compiled. The writer does not look at what becomes
// of its files, and maps its temporary ones: on a full disk waves would be cut, or the program be
// killed by SIGBUS. Its calls go through here: the first error is kept (take_wave_error() of
// cosim/waves.hpp), and temporary files are in memory.
#pragma once

// What is renamed below must be declared before.
#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>
#include <zlib.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>

std::FILE* trammel_fst_open(const char* name, const char* mode);
std::FILE* trammel_fst_tmpfile();
std::size_t trammel_fst_write(const void* from, std::size_t size, std::size_t count, std::FILE* to);
int trammel_fst_put(int byte, std::FILE* to);
int trammel_fst_flush(std::FILE* file);
int trammel_fst_close(std::FILE* file);
int trammel_fst_gzwrite(gzFile file, const void* from, unsigned size);
int trammel_fst_gzclose(gzFile file);
void* trammel_fst_map(void* at, std::size_t size, int protection, int flags, int file, off_t from);

#ifndef TRAMMEL_FST_FILES
#define fopen trammel_fst_open
#define tmpfile trammel_fst_tmpfile
#define fwrite trammel_fst_write
#define fputc trammel_fst_put
#define fflush trammel_fst_flush
#define fclose trammel_fst_close
#undef gzclose
#define gzwrite trammel_fst_gzwrite
#define gzclose trammel_fst_gzclose
#define mmap trammel_fst_map
#endif
