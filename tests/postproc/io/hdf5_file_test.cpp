// Opening a file beside a writer.
#include "io/hdf5_file.h"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <thread>

#include "text_file.h"

namespace mikromakro {
namespace {

/// A process that for some time has the file open so that nobody can read it; says when that begins.
pid_t obstruct(const std::string& file, std::chrono::milliseconds time, int said) {
  const pid_t process = fork();
  if (process != 0) return process;
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  H5Pset_file_locking(access, 0, 1);
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, access);
  const char sign = id >= 0 ? 'y' : 'n';
  if (write(said, &sign, 1) != 1) _exit(1);
  std::this_thread::sleep_for(time);
  H5Fclose(id);
  _exit(0);
}

TEST(Hdf5File, IsOpenedAsSoonAsAWriterLetsIt) {
  const Folder folder;
  const std::string file = folder.path("s.h5");
  Hdf5File::create(file);
  std::array<int, 2> said{};
  ASSERT_EQ(pipe(said.data()), 0);
  const pid_t writer = obstruct(file, std::chrono::milliseconds(200), said[1]);
  char sign = 0;
  ASSERT_EQ(read(said[0], &sign, 1), 1);
  ASSERT_EQ(sign, 'y');
  EXPECT_NO_THROW(Hdf5File::open(file));
  waitpid(writer, nullptr, 0);
}

}  // namespace
}  // namespace mikromakro
