// SPDX-License-Identifier: Apache-2.0
//
// What a full disk does to the files of the waves; whole runs: tests/system/files_test.py.
#define TRAMMEL_FST_FILES
#include "cosim/verilated/fst_files.hpp"

#include <catch2/catch.hpp>
#include <cerrno>
#include <string>

#include "cosim/waves.hpp"

using trammel::cosim::take_wave_error;

TEST_CASE("the first error in writing waves is kept until it is taken") {
  take_wave_error();
  std::FILE* const full = trammel_fst_open("/dev/full", "w+b");
  REQUIRE(full != nullptr);
  std::setvbuf(full, nullptr, _IONBF, 0);
  CHECK(take_wave_error() == 0);
  CHECK(trammel_fst_write("four", 1, 4, full) < 4);
  CHECK(take_wave_error() == ENOSPC);
  CHECK(take_wave_error() == 0);
  CHECK(trammel_fst_put('x', full) == EOF);
  CHECK(trammel_fst_open("/no/such/folder/file", "w+b") == nullptr);
  CHECK(take_wave_error() == ENOSPC);  // and not that of the folder
  trammel_fst_close(full);
  take_wave_error();
}

TEST_CASE("what is buffered is an error at its flush, and of a compressed part at its end") {
  take_wave_error();
  std::FILE* const full = trammel_fst_open("/dev/full", "w+b");
  REQUIRE(full != nullptr);
  CHECK(trammel_fst_write("four", 1, 4, full) == 4);
  CHECK(take_wave_error() == 0);
  CHECK(trammel_fst_flush(full) == EOF);
  CHECK(take_wave_error() == ENOSPC);
  trammel_fst_close(full);
  take_wave_error();
  const gzFile packed = gzopen("/dev/full", "wb4");
  REQUIRE(packed != nullptr);
  CHECK(trammel_fst_gzwrite(packed, "four", 4) == 4);
  CHECK(trammel_fst_gzclose(packed) != Z_OK);
  CHECK(take_wave_error() == ENOSPC);
}

TEST_CASE("a temporary file is in memory, and is mapped only where it is") {
  take_wave_error();
  std::FILE* const file = trammel_fst_tmpfile();
  REQUIRE(file != nullptr);
  CHECK(trammel_fst_write("four", 1, 4, file) == 4);
  CHECK(trammel_fst_flush(file) == 0);
  const auto map = [file](std::size_t size) {
    return static_cast<char*>(
        trammel_fst_map(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, fileno(file), 0));
  };
  char* const whole = map(4);
  CHECK(std::string(whole, 4) == "four");
  CHECK(take_wave_error() == 0);
  char* const beyond = map(100000);  // reading it would end the program
  CHECK(beyond[99999] == 0);
  CHECK(take_wave_error() == ENOSPC);
  munmap(whole, 4);
  munmap(beyond, 100000);
  CHECK(trammel_fst_close(file) == 0);
}
