// SPDX-License-Identifier: GPL-2.0-or-later
// Opening a file beside a writer.
#include "io/hdf5/hdf5_file.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "child.h"
#include "text_file.h"

namespace mikromakro {
namespace {

using std::chrono::milliseconds;

/// Opens an empty file that a process keeps as nobody can read it, for so long.
void open_beside_a_writer(milliseconds time) {
  const Folder folder;
  const std::string file = folder.path("s.h5");
  Hdf5File::create(file);
  const Child writer([&] {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    H5Pset_file_locking(access, 0, 1);
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, access);
    folder.write(id >= 0 ? "is_open" : "is_not_open", "");
    std::this_thread::sleep_for(time);
    return H5Fclose(id) < 0 ? 1 : 0;
  });
  for (int k = 0; k < 1000 && !std::filesystem::exists(folder.path("is_open")); ++k)
    std::this_thread::sleep_for(milliseconds(1));
  ASSERT_TRUE(std::filesystem::exists(folder.path("is_open")));
  Hdf5File::open(file);
}

TEST(Hdf5File, IsOpenedAsSoonAsItsWriterLetsIt) {
  EXPECT_NO_THROW(open_beside_a_writer(milliseconds(200)));
}

TEST(Hdf5File, ThatIsNeverToBeReadIsAnErrorAfterASecond) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_THROW(open_beside_a_writer(milliseconds(60000)), Error);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, milliseconds(30000));
}

}  // namespace
}  // namespace mikromakro
