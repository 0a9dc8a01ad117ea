#include "io/wall_dumps.h"

#include <fmt/format.h>

namespace mikromakro {

std::shared_ptr<const RowBlock> WallDumps::take(std::int64_t step) {
  while (!ahead_ || header_.step < step) {
    ahead_ = files_.next(header_);
    if (!ahead_)
      throw bad_input({files_.reader().file()}, "frame of particles without wall contacts",
                      fmt::format("step {} in both", step), "no more frames there");
  }
  if (header_.step > step)
    throw bad_input({files_.reader().file(), header_.line}, "frame of particles without wall contacts",
                    fmt::format("step {} in both", step), fmt::format("step {} there", header_.step));
  ahead_ = false;
  return std::make_shared<const RowBlock>(files_.reader().take_rows(header_));
}

}  // namespace mikromakro
