// SPDX-License-Identifier: Apache-2.0
//
// A sequence that grows on the disk, so that a run of any length takes the same memory: full
// blocks are kept in an unnamed temporary file, and one of them at a time is read back.
// Elements come by value, and are not changed. Not for two threads at once.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

namespace trammel::host {

// Throws std::system_error when the temporary file cannot be made, written or read.
template <class T>
class DiskVector {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;
  static constexpr std::size_t kBlock = std::max<std::size_t>(1, 16384 / sizeof(T));

  class Iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = T;

    Iterator() = default;
    Iterator(const DiskVector& all, std::size_t at) : all_(&all), at_(at) {}

    T operator*() const { return (*all_)[at_]; }
    Iterator& operator+=(difference_type n) {
      at_ = static_cast<std::size_t>(static_cast<difference_type>(at_) + n);
      return *this;
    }
    Iterator& operator++() { return *this += 1; }
    Iterator& operator--() { return *this += -1; }
    difference_type operator-(const Iterator& other) const {
      return static_cast<difference_type>(at_) - static_cast<difference_type>(other.at_);
    }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }
    bool operator!=(const Iterator& other) const { return at_ != other.at_; }

   private:
    const DiskVector* all_ = nullptr;
    std::size_t at_ = 0;
  };

  DiskVector() = default;
  DiskVector(std::initializer_list<T> list) {
    for (const T& one : list) push_back(one);
  }

  std::size_t size() const { return written_ * kBlock + last_.size(); }
  bool empty() const { return size() == 0; }

  void push_back(const T& one) {
    last_.push_back(one);
    if (last_.size() == kBlock) write_last();
  }

  T operator[](std::size_t at) const {
    const std::size_t block = at / kBlock;
    if (block == written_) return last_[at % kBlock];
    if (block != read_block_ || read_.empty()) read(block);
    return read_[at % kBlock];
  }
  T front() const { return (*this)[0]; }
  T back() const { return (*this)[size() - 1]; }
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  [[noreturn]] static void fail(const char* what) {
    const int error = errno;
    std::error_code ignored;
    throw std::system_error(error, std::generic_category(),
                            std::filesystem::temp_directory_path(ignored).string() +
                                ": the record of the run cannot be " + what + " there");
  }

  // In the folder TMPDIR, or /tmp.
  static std::FILE* unnamed_file() {
    std::string name = (std::filesystem::temp_directory_path() / "trammel-XXXXXX").string();
    const int descriptor = mkstemp(name.data());
    if (descriptor < 0) return nullptr;
    unlink(name.c_str());
    return fdopen(descriptor, "w+b");
  }

  void seek(std::size_t block) const {
    const auto place = static_cast<off_t>(block * kBlock * sizeof(T));
    if (fseeko(file_.get(), place, SEEK_SET) != 0) fail("read");
  }

  void write_last() {
    if (!file_) {
      file_.reset(unnamed_file());
      if (!file_) fail("written");
      std::setvbuf(file_.get(), nullptr, _IONBF, 0);
    }
    seek(written_);
    if (std::fwrite(last_.data(), sizeof(T), kBlock, file_.get()) != kBlock) fail("written");
    ++written_;
    last_.clear();
  }

  void read(std::size_t block) const {
    read_.resize(kBlock);
    seek(block);
    if (std::fread(read_.data(), sizeof(T), kBlock, file_.get()) != kBlock) fail("read");
    read_block_ = block;
  }

  std::unique_ptr<std::FILE, Close> file_;
  std::size_t written_ = 0;  // blocks in the file
  std::vector<T> last_;      // begins behind them
  mutable std::vector<T> read_;
  mutable std::size_t read_block_ = 0;
};

}  // namespace trammel::host
