// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <filesystem>

namespace trammel::host {

// An advisory lock of a folder, held as long as this lives; it ends with the process too.
class FolderLock {
 public:
  FolderLock() = default;
  // Waits as long as that where another one holds it.
  explicit FolderLock(const std::filesystem::path& folder,
                      std::chrono::milliseconds patience = {});
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;

  bool held() const { return descriptor_ >= 0; }
  bool busy() const { return busy_; }  // another one held it all that time
  bool is_of(const std::filesystem::path& folder) const;  // and not of another that was there

 private:
  int descriptor_ = -1;
  bool busy_ = false;
};

}  // namespace trammel::host
